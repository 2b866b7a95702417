// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/certify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "math/angle.hpp"
#include "model/contact.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "solvers/inertia.hpp"
#include "trajectory/arc_length_motion.hpp"
#include "trajectory/checks.hpp"
#include "trajectory/extended_residual.hpp"
#include "trajectory/reintegration.hpp"

namespace brachisto {

namespace {

/// Moves to the solution; the certificate of one that is refused says the
/// reason instead of measuring what has no meaning.
bool evaluable(Transcription& problem, const PrimalDual& point, double phi,
               Certificate& certificate) {
  problem.set_end_angle(phi);
  if (problem.set_point(point.x)) return true;
  certificate.add("speed", 1.0, 0.0, problem.refusal());
  return false;
}

/// \param rounding  what residuals cannot fall below
void check_residual(const ExtendedResidual& residual, double rounding,
                    Certificate& certificate) {
  certificate.add("kkt_residual", residual.stationarity,
                  std::max(kThresholds.kkt_residual, rounding),
                  residual.worst_variable);
  certificate.add("defects", std::max(residual.defects, residual.fixed_values),
                  kThresholds.defects, residual.worst_constraint);
}

/// The ends, and how far β_end is from φ.
void check_ends(const Scene& scene, Point start, Point end, double beta_end,
                double phi, double rounding, Certificate& certificate) {
  // At the start the slope is β₀ in closed form, not the curve's own.
  check_contact(scene, start, start_angle(scene), end, beta_end, rounding,
                certificate);
  if (scene.contact == Contact::Smooth) {
    certificate.add("closure", std::abs(beta_end - phi), kThresholds.tangency);
  }
}

/// The slope of the curve at its start, against the law for leaving rest. With
/// an initial speed there is no such law, and where that slope moves the start
/// it has to be the one that the start was built from.
void check_start(const ExtremalCurve& curve, double threshold,
                 Certificate& certificate) {
  const Scene& scene = curve.scene();
  const bool open = slope_at_A_is_open(scene);
  if (scene.world.start_speed > 0.0 && !open) return;
  certificate.add(open ? "closure_at_A" : "start_angle",
                  std::abs(curve.at(0.0).beta - start_angle(scene)),
                  open ? kThresholds.tangency : threshold);
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
  const std::vector<double>& w = curve.w_at_points();
  std::size_t at_rest = 0;
  std::string where;
  const auto see = [&](double speed, std::size_t c) {
    if (speed > 0.0) return;  // written so that a NaN counts
    if (at_rest++ > 0) return;
    where = fmt::format("w = {:.3g} at collocation point {} of {}", speed, c,
                        w.size());
  };
  for (std::size_t c = 0; c < w.size(); ++c) see(w[c], c);
  see(curve.at(1.0).w, w.size());
  certificate.add(
      "speed", static_cast<double>(at_rest) / static_cast<double>(w.size() + 1),
      0.0, where);
}

/// What is seen along an extremal.
struct Seen {
  Largest hamiltonian, slope;
  Largest flattest = kBelowAll;
  Largest gain = kBelowAll;  ///< of other directions
};

/// 𝓗 and its derivatives between the nodes, and at ends and middles of elements
/// that no other direction makes it smaller.
Seen look_along(const ExtremalCurve& curve) {
  const Mesh& mesh = curve.mesh();
  const Scene& scene = curve.scene();
  const CollocationScheme& scheme = gauss_scheme(mesh.degree);
  // Places that are neither nodes nor collocation points, both ends included.
  const int count = mesh.degree + 2;
  std::vector<ElementPlace> places;
  for (int i = 0; i <= count; ++i) {
    places.emplace_back(scheme, static_cast<double>(i) / count);
  }
  const ElementPlace middle(scheme, 0.5);
  Seen seen;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    const auto look_around = [&](const ExtremalPoint& at, double sigma) {
      seen.gain.see(gain_of_other_directions(scene, at.state(), at.p, at.beta),
                    sigma);
    };
    for (const ElementPlace& place : places) {
      const double sigma = mesh.sigma(e, place.t);
      const ExtremalPoint at = curve.at(e, place);
      const double root = root_of_inertia(scene, at.theta, at.beta);
      const SlopeHamiltonian h =
          slope_hamiltonian(scene, at.state(), at.p, at.beta);
      const SlopeHamiltonian interpolated = slope_hamiltonian(
          scene, at.state(), at.p, curve.interpolated_slope(e, place));
      seen.hamiltonian.see(
          std::abs(hamiltonian(scene, at.state(), at.p, at.beta)) / root,
          sigma);
      seen.slope.see(std::abs(interpolated.d_beta) / root, sigma);
      seen.flattest.see(-h.d2_beta, sigma);
      // The start of an element is the end of the one before.
      if (place.t == 1.0 || sigma == 0.0) look_around(at, sigma);
    }
    look_around(curve.at(e, middle), mesh.sigma(e, 0.5));
  }
  return seen;
}

/// What ½ w² has gained since the body was left at rest or pushed, against the
/// fall of the potential at the centre of mass less the work of the drag.
void check_energy(const ExtremalCurve& curve, double threshold,
                  Certificate& certificate) {
  const Scene& scene = curve.scene();
  const Mesh& mesh = curve.mesh();
  // Exact for polynomials of degree 2p + 5, of higher order than the solution.
  const math::QuadratureRule rule = math::gauss_legendre(mesh.degree + 3);
  const CollocationScheme& scheme = gauss_scheme(mesh.degree);
  std::vector<ElementPlace> places;
  for (const double t : rule.points) places.emplace_back(scheme, t);
  const ElementPlace last(scheme, 1.0);
  const ExtremalPoint start = curve.at(0.0);
  const Point heavy = mass_centre(scene.body, start.centre, scene.body.theta_m);
  const double push = pushed_w(scene, start.beta);
  double lost = 0.0;
  Largest drift;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    for (std::size_t i = 0; i < rule.points.size() && scene.world.air.any();
         ++i) {
      const ExtremalPoint at = curve.at(e, places[i]);
      const double v = at.w / root_of_inertia(scene, at.theta, at.beta);
      lost += rule.weights[i] * mesh.length(e) * curve.rolling_time() * at.w *
              drag(scene.world.air, v);
    }
    const ExtremalPoint at = curve.without_slope(e, last);
    const double gained = 0.5 * (at.w * at.w - push * push);
    const Point there = mass_centre(scene.body, at.centre, at.theta);
    const double work = potential_fall(scene, heavy, there) - lost;
    drift.see(std::abs(gained - work) / scene.gravity,
              mesh.boundaries[static_cast<std::size_t>(e) + 1]);
  }
  certificate.add("energy_drift", drift.value, threshold, drift.where());
}

/// No costate is constant in the field of a sphere, but what all may be turned
/// by about its centre is. The uniform field's costates need no such check, for
/// they are read as constants.
void check_turning(const ExtremalCurve& curve, double threshold,
                   Certificate& certificate) {
  const std::optional<Point> O = turning_centre(curve.scene().world);
  if (!O) return;
  const auto costate = [&](const ExtremalPoint& at) {
    return turning_costate(*O, at.centre, at.p);
  };
  const double scale = turning_scale(*O, curve.transit_time());
  const double end = costate(curve.at(1.0));
  const ElementPlace first(gauss_scheme(curve.mesh().degree), 0.0);
  Largest drift;
  for (int e = 0; e < curve.mesh().num_elements(); ++e) {
    drift.see(std::abs(costate(curve.without_slope(e, first)) - end) / scale,
              curve.mesh().boundaries[static_cast<std::size_t>(e)]);
  }
  certificate.add("turning_costate", drift.value, threshold, drift.where());
}

void check_second_order(Transcription& problem, const PrimalDual& point,
                        Certificate& certificate) {
  int free = 0;
  for (int i = 0; i < problem.num_variables(); ++i) {
    if (!problem.variable_range(i).single()) ++free;
  }
  const Inertia inertia = kkt_inertia(problem, point);
  const double wrong = inertia.known
                           ? std::abs(inertia.positive - free) + inertia.zero
                           : kUnmeasured;
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
                  motion.arrived() ? motion.corrected_time_error : kUnmeasured,
                  time_error + motion.integration_error, where);
  certificate.add("reintegration_error", motion.worst(), threshold, where);
}

/// Slopes, and 𝓗 on the pieces, at the current point of `problem`.
void check_pieces(const ArcLength& problem, std::span<const double> lambda,
                  double threshold, Certificate& certificate) {
  const Scene& scene = problem.scene();
  Largest steepest = kBelowAll, flattest = kBelowAll, better = kBelowAll;
  const Costates end = problem.end_costates(lambda);
  double beta = start_angle(scene.body);
  for (int node = 1; node <= problem.num_intervals(); ++node) {
    check_stop(node);
    const ArcLength::PieceState at = problem.piece_state(node, lambda, end);
    beta += math::least_turn(at.beta - beta);
    steepest.see(std::abs(beta), node);
    const RollingState state{at.theta, at.w};
    flattest.see(
        -slope_hamiltonian(scene.body, scene.gravity, state, at.p, at.beta)
             .d2_beta,
        node);
    better.see(gain_of_other_directions(scene.body, scene.gravity, state, at.p,
                                        at.beta),
               node);
  }
  const auto piece = [&](const Largest& found) {
    return fmt::format("piece {} of {}", static_cast<int>(found.place),
                       problem.num_intervals());
  };
  certificate.add("slope_angle", steepest.value, std::numbers::pi,
                  piece(steepest));
  certificate.add("legendre", flattest.value,
                  -std::numeric_limits<double>::min(), piece(flattest));
  certificate.add("weierstrass", better.value, threshold, piece(better));
}

void check_motion(const ArcLengthMotion& motion, double error,
                  Certificate& certificate) {
  // Of the quadrature and the integrator, over thousands of pieces.
  constexpr double kIntegrator = 1e-10;
  constexpr double kBegin = 0.02;  // the share of T where the integrator begins
  const PrescribedMotion& curve = motion.on_curve();
  if (curve.stall()) {
    const std::string where = curve.stall()->message();
    certificate.add("reintegrated_time", kUnmeasured,
                    kThresholds.time_factor * error, where);
    certificate.add("reintegration_error", kUnmeasured, kIntegrator, where);
    return;
  }
  certificate.add("reintegrated_time",
                  std::abs(curve.transit_time() / motion.transit_time() - 1.0),
                  kThresholds.time_factor * error + curve.error_estimate());
  certificate.add("reintegration_error", reintegration_error(curve, kBegin),
                  std::max(error, kIntegrator));
  certificate.add(
      "start_angle",
      std::abs(motion.continued_start_angle() - motion.start_angle()),
      std::min(kThresholds.largest_slope,
               kThresholds.interior_factor * std::sqrt(error)));
}

}  // namespace

Certificate certify(RollingTime& problem, const PrimalDual& point,
                    const ExtremalCurve& curve, double phi, double error) {
  Certificate certificate;
  if (!evaluable(problem, point, phi, certificate)) return certificate;
  check_residual(extended_residual(problem, point), 0.0, certificate);
  const ExtremalPoint end = curve.at(1.0);
  check_ends(problem.scene(), curve.at(0.0).centre, end.centre, end.beta, phi,
             0.0, certificate);
  check_slope(curve, certificate);
  check_speed(curve, certificate);

  const double p = problem.mesh().degree;
  // Written so that a NaN, an unknown error, remains one.
  const auto at_most = [](double largest, double value) {
    return value > largest ? largest : value;
  };
  const double factor = kThresholds.interior_factor;
  const double interior = factor * std::pow(error, 0.5 * (p + 1.0) / p);
  const double slopes =
      at_most(kThresholds.largest_slope, factor * std::sqrt(error));
  const Seen seen = look_along(curve);
  certificate.add("hamiltonian", seen.hamiltonian.value,
                  at_most(kThresholds.largest_interior, interior),
                  seen.hamiltonian.where());
  certificate.add("slope", seen.slope.value, slopes, seen.slope.where());
  certificate.add("legendre", seen.flattest.value,
                  -std::numeric_limits<double>::min(), seen.flattest.where());
  certificate.add("weierstrass", seen.gain.value, kThresholds.weierstrass,
                  seen.gain.where());
  check_start(curve, slopes, certificate);
  const double at_ends = at_most(kThresholds.largest_at_end, factor * error);
  check_energy(curve, at_ends, certificate);
  check_turning(curve, at_ends, certificate);
  check_second_order(problem, point, certificate);
  check_motion(curve, kThresholds.time_factor * error,
               at_most(kThresholds.largest_at_end, interior), certificate);
  return certificate;
}

Certificate certify(RollingTime& problem, const PrimalDual& point, double phi,
                    double error) {
  return certify(problem, point, ExtremalCurve(problem, point), phi, error);
}

Certificate certify(ArcLength& problem, const PrimalDual& point, double phi,
                    const ArcLengthMotion& motion, double error) {
  Certificate certificate;
  if (!evaluable(problem, point, phi, certificate)) return certificate;
  certificate.add("speed", 0.0, 0.0);  // w > 0, or it had been refused
  const double rounding = problem.rounding(point.x);
  check_residual(extended_residual(problem, point), rounding, certificate);
  const Point start = start_of_centre(problem.scene());
  const auto last = static_cast<std::size_t>(
      problem.layout().state(problem.num_intervals(), StateComponent::X));
  check_ends(problem.scene(), start,
             {start.x + point.x[last], start.z + point.x[last + 1]},
             problem.end_slope(point.x, point.lambda), phi, rounding,
             certificate);
  check_pieces(problem, point.lambda,
               std::max(kThresholds.weierstrass, rounding), certificate);
  check_second_order(problem, point, certificate);
  check_motion(motion, error, certificate);
  return certificate;
}

}  // namespace brachisto
