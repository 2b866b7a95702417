// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/arc_length_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/contact.hpp"
#include "brachisto/model/hamiltonian.hpp"
#include "brachisto/model/start_angle.hpp"
#include "brachisto/solvers/inertia.hpp"
#include "brachisto/trajectory/arc_length_residual.hpp"
#include "brachisto/trajectory/path_certificate.hpp"

namespace brachisto {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A largest value and the piece where it is; a NaN is larger.
struct Largest {
  double value = -std::numeric_limits<double>::infinity();
  int piece = 0;

  void see(double candidate, int at) {
    if (std::isnan(value) || candidate <= value) return;
    value = candidate;
    piece = at;
  }
  [[nodiscard]] std::string where(const ArcLength& problem) const {
    return fmt::format("piece {} of {}", piece, problem.num_intervals());
  }
};

/// 𝓗 on the pieces, at the current point of `problem`.
void check_directions(const ArcLength& problem, std::span<const double> lambda,
                      double threshold, Certificate& certificate) {
  const Scene& scene = problem.scene();
  Largest flattest, better;
  for (const ArcLength::PieceState& at : problem.piece_states(lambda)) {
    const RollingState state{at.theta, at.w};
    flattest.see(
        -slope_hamiltonian(scene.body, scene.gravity, state, at.p, at.beta)
             .d2_beta,
        at.node);
    better.see(gain_of_other_directions(scene.body, scene.gravity, state, at.p,
                                        at.beta),
               at.node);
  }
  certificate.add("legendre", flattest.value,
                  -std::numeric_limits<double>::min(), flattest.where(problem));
  certificate.add("weierstrass", better.value, threshold,
                  better.where(problem));
}

void check_slope(const ArcLength& problem, std::span<const double> x,
                 Certificate& certificate) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  Largest steepest;
  double beta = start_angle(problem.scene().body);
  double x_c = 0.0, z_c = 0.0;
  for (int node = 1; node <= problem.num_intervals(); ++node) {
    check_stop(node);
    const auto i = static_cast<std::size_t>(
        problem.layout().state(node, StateComponent::X));
    const double raw = std::atan2(x[i + 1] - z_c, x[i] - x_c);
    beta += std::remainder(raw - beta, kTurn);
    steepest.see(std::abs(beta), node);
    x_c = x[i];
    z_c = x[i + 1];
  }
  certificate.add("slope_angle", steepest.value, std::numbers::pi,
                  steepest.where(problem));
}

void check_second_order(ArcLength& problem, const PrimalDual& point,
                        Certificate& certificate) {
  constexpr int kFixed = 2;  // x and z of the last node
  const int free = problem.num_variables() - kFixed;
  const Inertia inertia = kkt_inertia(problem, point);
  const double wrong = inertia.known
                           ? std::abs(inertia.positive - free) + inertia.zero
                           : kUnknown;
  certificate.add("second_order", wrong, 0.0,
                  fmt::format("inertia ({}, {}, {}), wanted ({}, {}, 0)",
                              inertia.positive, inertia.negative, inertia.zero,
                              free, problem.num_constraints()));
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

/// How far the track's ends are from A and B, or with Contact::Centre the ends
/// of the centre's path, by the last node and β_end.
double contact_error(const ArcLength& problem, std::span<const double> x,
                     double beta_end) {
  const Scene& scene = problem.scene();
  const Point start = start_of_centre(scene);
  const auto i = static_cast<std::size_t>(
      problem.layout().state(problem.num_intervals(), StateComponent::X));
  const Point end{start.x + x[i], start.z + x[i + 1]};
  if (scene.contact == Contact::Centre) {
    return std::max(distance(start, {0.0, 0.0}),
                    distance(end, {scene.L, scene.H}));
  }
  const double r = scene.body.radius;
  return std::max(
      distance(track_below(start, r, start_angle(scene.body)), {0.0, 0.0}),
      distance(track_below(end, r, beta_end), {scene.L, scene.H}));
}

void check_motion(const ArcLengthMotion& motion, double error,
                  const CertificateThresholds& thresholds,
                  Certificate& certificate) {
  // Of the quadrature and the integrator, over thousands of pieces.
  constexpr double kIntegrator = 1e-10;
  constexpr double kBegin = 0.02;  // the share of T where the integrator begins
  const PrescribedMotion& curve = motion.on_curve();
  if (curve.stall()) {
    const std::string where = curve.stall()->message();
    certificate.add("reintegrated_time", kUnknown,
                    thresholds.time_factor * error, where);
    certificate.add("reintegration_error", kUnknown, kIntegrator, where);
    return;
  }
  certificate.add("reintegrated_time",
                  std::abs(curve.transit_time() / motion.transit_time() - 1.0),
                  thresholds.time_factor * error + curve.error_estimate());
  certificate.add("reintegration_error", reintegration_error(curve, kBegin),
                  std::max(error, kIntegrator));
  certificate.add("start_angle",
                  std::abs(curve.start_angle() - motion.start_angle()),
                  std::min(thresholds.largest_slope,
                           thresholds.interior_factor * std::sqrt(error)));
}

}  // namespace

Certificate certify(ArcLength& problem, const PrimalDual& point, double phi,
                    const ArcLengthMotion& motion, double error,
                    const CertificateThresholds& thresholds) {
  Certificate certificate;
  problem.set_end_angle(phi);
  if (!problem.set_point(point.x)) {
    certificate.add("speed", 1.0, 0.0, problem.refusal());
    return certificate;
  }
  certificate.add("speed", 0.0, 0.0);  // w > 0, or it had been refused
  const double rounding = problem.rounding(point.x);
  const ExtendedResidual residual = extended_residual(problem, point);
  certificate.add("kkt_residual", residual.stationarity,
                  std::max(thresholds.kkt_residual, rounding),
                  residual.worst_variable);
  certificate.add("defects", std::max(residual.defects, residual.fixed_values),
                  thresholds.defects, residual.worst_constraint);
  const bool smooth = problem.scene().contact == Contact::Smooth;
  const double beta_end = problem.end_slope(point.x, point.lambda);
  certificate.add("contact_error", contact_error(problem, point.x, beta_end),
                  std::max(thresholds.contact_error, rounding));
  if (smooth) {
    certificate.add("closure", std::abs(beta_end - phi), thresholds.closure);
  }
  check_slope(problem, point.x, certificate);
  check_directions(problem, point.lambda,
                   std::max(thresholds.weierstrass, rounding), certificate);
  check_second_order(problem, point, certificate);
  check_motion(motion, error, thresholds, certificate);
  return certificate;
}

}  // namespace brachisto
