// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/contact.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/start_angle.hpp"
#include "brachisto/solvers/inertia.hpp"
#include "brachisto/trajectory/extended_residual.hpp"
#include "brachisto/trajectory/reintegration.hpp"

namespace brachisto {

bool Certificate::verified() const {
  return !checks.empty() &&
         std::all_of(checks.begin(), checks.end(),
                     [](const Check& check) { return check.passed; });
}

const Check* Certificate::find(const std::string& name) const {
  const auto found =
      std::find_if(checks.begin(), checks.end(),
                   [&](const Check& check) { return check.name == name; });
  return found == checks.end() ? nullptr : &*found;
}

void Certificate::add(std::string name, double value, double threshold,
                      std::string where) {
  checks.push_back({std::move(name), value, threshold, std::move(where),
                    value <= threshold});
}

std::vector<std::string> not_verified_because(const Certificate& certificate) {
  std::vector<std::string> reasons;
  for (const Check& check : certificate.checks) {
    if (check.passed) continue;
    const std::string where =
        check.where.empty() ? "" : fmt::format(" ({})", check.where);
    reasons.push_back(
        std::isnan(check.value)
            ? fmt::format("{} cannot be measured{}", check.name, where)
        : std::isnan(check.threshold)
            ? fmt::format("{} is {:.3g}, and nothing is known of the error of "
                          "T that could justify it{}",
                          check.name, check.value, where)
            : fmt::format("{} is {:.3g}, more than {:.3g}{}", check.name,
                          check.value, check.threshold, where));
  }
  return reasons;
}

namespace {

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

/// How far the ends of the track are from A and B, or with Contact::Centre how
/// far the ends of the centre's path are.
double contact_error(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  const ExtremalPoint start = curve.at(0.0);
  const ExtremalPoint end = curve.at(1.0);
  const Point A{0.0, 0.0};
  const Point B{scene.L, scene.H};
  if (scene.contact == Contact::Centre) {
    return std::max(distance(start.centre, A), distance(end.centre, B));
  }
  const double r = scene.body.radius;
  // At the start the slope is β₀ in closed form, not the curve's own.
  return std::max(
      distance(track_below(start.centre, r, start_angle(scene.body)), A),
      distance(track_below(end.centre, r, end.beta), B));
}

void check_slope(const ExtremalCurve& curve, Certificate& certificate) {
  const std::vector<double>& slopes = curve.continuous_slope();
  std::size_t worst = 0;
  for (std::size_t c = 0; c < slopes.size(); ++c) {
    // Written so that a NaN is the worst of all.
    if (!(std::abs(slopes[c]) <= std::abs(slopes[worst]))) worst = c;
  }
  certificate.add(
      "slope_angle", std::abs(slopes[worst]), std::numbers::pi,
      fmt::format("collocation point {} of {}", worst, slopes.size()));
}

void check_speed(const ExtremalCurve& curve, Certificate& certificate) {
  std::vector<double> w = curve.w_at_points();
  w.push_back(curve.at(1.0).w);
  std::size_t at_rest = 0;
  std::string where;
  for (std::size_t c = 0; c < w.size(); ++c) {
    if (w[c] > 0.0) continue;  // written so that a NaN counts
    if (at_rest++ == 0) {
      where = fmt::format("w = {:.3g} at collocation point {} of {}", w[c], c,
                          w.size() - 1);
    }
  }
  certificate.add("speed",
                  static_cast<double>(at_rest) / static_cast<double>(w.size()),
                  0.0, where);
}

/// The largest of values that belong to places of the path; a NaN is larger.
struct Largest {
  double value = 0.0;
  double sigma = 0.0;

  void see(double candidate, double at) {
    if (std::isnan(value) || candidate <= value) return;
    value = candidate;
    sigma = at;
  }
  [[nodiscard]] std::string where() const {
    return fmt::format("σ = {:.6g}", sigma);
  }
};

/// 𝓗 and its derivatives between the nodes.
void check_hamiltonian(const ExtremalCurve& curve, double interior,
                       double slope_threshold, Certificate& certificate) {
  const Mesh& mesh = curve.mesh();
  const Scene& scene = curve.scene();
  Largest hamiltonian_off, slope_off;
  Largest flattest{-std::numeric_limits<double>::infinity(), 0.0};
  // Places that are neither nodes nor collocation points, both ends included.
  const int places = mesh.degree + 2;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    for (int i = 0; i <= places; ++i) {
      const double t = static_cast<double>(i) / places;
      const double sigma =
          mesh.boundaries[static_cast<std::size_t>(e)] + t * mesh.length(e);
      const ExtremalPoint at = curve.at(e, t);
      const RollingState state{at.theta, at.w};
      const double root =
          std::sqrt(inertia_factor(scene.body, at.theta, at.beta));
      const SlopeHamiltonian h =
          slope_hamiltonian(scene.body, scene.gravity, state, at.p, at.beta);
      const SlopeHamiltonian interpolated =
          slope_hamiltonian(scene.body, scene.gravity, state, at.p,
                            curve.interpolated_slope(e, t));
      hamiltonian_off.see(std::abs(hamiltonian(scene.body, scene.gravity, state,
                                               at.p, at.beta)) /
                              root,
                          sigma);
      slope_off.see(std::abs(interpolated.d_beta) / root, sigma);
      flattest.see(-h.d2_beta, sigma);
    }
  }
  certificate.add("hamiltonian", hamiltonian_off.value, interior,
                  hamiltonian_off.where());
  certificate.add("slope", slope_off.value, slope_threshold, slope_off.where());
  certificate.add("legendre", flattest.value,
                  -std::numeric_limits<double>::min(), flattest.where());
}

/// That no other direction makes 𝓗 smaller, at ends and middles of elements.
void check_weierstrass(const ExtremalCurve& curve, double threshold,
                       Certificate& certificate) {
  const Scene& scene = curve.scene();
  const Mesh& mesh = curve.mesh();
  Largest worst{-std::numeric_limits<double>::infinity(), 0.0};
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    for (const double t : {0.0, 0.5, 1.0}) {
      // The end of the element before.
      if (e > 0 && t == 0.0) continue;
      const ExtremalPoint at = curve.at(e, t);
      const double sigma =
          mesh.boundaries[static_cast<std::size_t>(e)] + t * mesh.length(e);
      worst.see(gain_of_other_directions(scene.body, scene.gravity,
                                         {at.theta, at.w}, at.p, at.beta),
                sigma);
    }
  }
  certificate.add("weierstrass", worst.value, threshold, worst.where());
}

void check_energy(const ExtremalCurve& curve, double threshold,
                  Certificate& certificate) {
  const Scene& scene = curve.scene();
  const double z_0 = curve.at(0.0).centre.z;
  Largest drift;
  for (int e = 0; e < curve.mesh().num_elements(); ++e) {
    const ExtremalPoint at = curve.at(e, 1.0);
    const double E = energy_height(scene.body, at.centre.z - z_0, at.theta);
    drift.see(std::abs(at.w * at.w / (2.0 * scene.gravity) - E),
              curve.mesh().boundaries[static_cast<std::size_t>(e) + 1]);
  }
  certificate.add("energy_drift", drift.value, threshold, drift.where());
}

void check_second_order(RollingTime& problem, const PrimalDual& point,
                        Certificate& certificate) {
  int free = 0;
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    if (problem.lower()[i] != problem.upper()[i]) ++free;
  }
  const Inertia inertia = kkt_inertia(problem, point);
  const double wrong = inertia.known
                           ? std::abs(inertia.positive - free) + inertia.zero
                           : std::numeric_limits<double>::quiet_NaN();
  certificate.add("second_order", wrong, 0.0,
                  fmt::format("inertia ({}, {}, {}), wanted ({}, {}, 0)",
                              inertia.positive, inertia.negative, inertia.zero,
                              free, problem.num_constraints()));
}

void check_motion(const ExtremalCurve& curve, double time_error,
                  double threshold, Certificate& certificate) {
  const Reintegration motion = reintegrate(curve);
  const std::string where =
      motion.arrived()
          ? ""
          : fmt::format("{}, after {:.3g} % of it", describe(motion.end),
                        100.0 * motion.share);
  certificate.add("reintegrated_time",
                  motion.arrived() ? motion.corrected_time_error
                                   : std::numeric_limits<double>::quiet_NaN(),
                  time_error + motion.integration_error, where);
  const double worst =
      motion.arrived()
          ? std::max({motion.time_error, motion.speed_error,
                      motion.position_error, motion.rotation_error})
          : std::numeric_limits<double>::quiet_NaN();
  certificate.add("reintegration_error", worst, threshold, where);
}

}  // namespace

Certificate certify(RollingTime& problem, const PrimalDual& point, double phi,
                    double error, const CertificateThresholds& thresholds) {
  Certificate certificate;
  problem.set_end_angle(phi);
  if (!problem.set_point(point.x)) {
    // Says the reason instead of measuring what has no meaning.
    certificate.add("speed", 1.0, 0.0, problem.refusal());
    return certificate;
  }
  const ExtendedResidual residual = extended_residual(problem, point);
  certificate.add("kkt_residual", residual.stationarity,
                  thresholds.kkt_residual, residual.worst_variable);
  certificate.add("defects", std::max(residual.defects, residual.fixed_values),
                  thresholds.defects, residual.worst_constraint);

  const ExtremalCurve curve(problem, point);
  certificate.add("contact_error", contact_error(curve),
                  thresholds.contact_error);
  if (problem.scene().contact == Contact::Smooth) {
    certificate.add("closure", std::abs(curve.at(1.0).beta - phi),
                    thresholds.closure);
  }
  check_slope(curve, certificate);
  check_speed(curve, certificate);

  const double p = problem.mesh().degree;
  // Written so that a NaN, an unknown error, remains one.
  const auto at_most = [](double largest, double value) {
    return value > largest ? largest : value;
  };
  const double factor = thresholds.interior_factor;
  const double interior = factor * std::pow(error, 0.5 * (p + 1.0) / p);
  const double slopes =
      at_most(thresholds.largest_slope, factor * std::sqrt(error));
  check_hamiltonian(curve, at_most(thresholds.largest_interior, interior),
                    slopes, certificate);
  check_weierstrass(curve, thresholds.weierstrass, certificate);
  certificate.add(
      "start_angle",
      std::abs(curve.at(0.0).beta - start_angle(problem.scene().body)), slopes);
  check_energy(curve, at_most(thresholds.largest_at_end, factor * error),
               certificate);
  check_second_order(problem, point, certificate);
  check_motion(curve, thresholds.time_factor * error,
               at_most(thresholds.largest_at_end, interior), certificate);
  return certificate;
}

}  // namespace brachisto
