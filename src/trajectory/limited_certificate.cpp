// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The checks of a solution under limits.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "brachisto/nlp/problem.hpp"
#include "model/field.hpp"
#include "model/path_inequality.hpp"
#include "model/start_under_limits.hpp"
#include "nlp/active_set.hpp"
#include "solvers/inertia.hpp"
#include "trajectory/checks.hpp"
#include "trajectory/places.hpp"
#include "trajectory/reintegration.hpp"

namespace brachisto {

namespace {

/// The slopes that the scene itself asks for, whatever the solution was built
/// with: the one at B where it is given, and at A the law for leaving rest, but
/// where a path that a bound of valleys or the contact frees from it turns.
void check_slopes(const LimitedCurve& curve, Certificate& certificate) {
  constexpr double kSlope = 1e-9;
  const Scene& scene = curve.problem().scene();
  if (scene.contact == Contact::EndSlope) {
    certificate.add("end_slope",
                    std::abs(curve.at(1.0).state.beta -
                             scene.end_slope.value_or(kUnmeasured)),
                    kSlope);
  }
  if (const auto& corner = curve.problem().ends().corner) {
    certificate.add("start_corner", std::abs(curve.off_corner()), kSlope,
                    name(curve.problem().limits()[corner->limit].kind));
    certificate.add("start_corner_sign",
                    // In this order a NaN remains one.
                    std::max(-curve.corner_multiplier(), 0.0), kSlope);
  }
  if (curve.problem().pushed()) {
    if (curve.problem().free_contacts()) return;
    certificate.add(
        "start_angle",
        std::abs(curve.start_slope() -
                 curve.problem().ends().start.value_or(kUnmeasured)),
        kSlope);
    return;
  }
  const std::vector<PathInequality> limits =
      inequalities(scene.body, scene.limits);
  if (scene.contact == Contact::Optimal ||
      (bound_valleys(limits) && curve.holds_control(0))) {
    return;
  }
  certificate.add(
      "start_angle",
      std::abs(curve.at(0.0).state.beta -
               start_angle_under(scene, limits).value_or(kUnmeasured)),
      kSlope);
}

/// What the kinetic energy has gained against the fall of the potential at the
/// centre of mass less the work of the drag and of the losses, over g H.
void check_energy(const LimitedCurve& curve, double threshold,
                  Certificate& certificate) {
  const Scene& scene = curve.problem().scene();
  const World& world = scene.world;
  if (!world.losses.any()) return;
  const Mesh& mesh = curve.problem().mesh();
  const math::QuadratureRule rule = math::gauss_legendre(mesh.degree + 3);
  const auto speed = [&](const TurningPoint<double>& at) {
    return at.w / root_of_inertia(scene, at.theta, at.beta);
  };
  const auto kinetic = [&](const TurningPoint<double>& at) {
    return 0.5 * inertia_factor(scene.body, at.theta, at.beta) *
           std::pow(speed(at), 2);
  };
  const auto heavy = [&](const TurningPoint<double>& at) {
    return mass_centre(scene.body, {at.x, at.z}, at.theta);
  };
  const TurningPoint<double> start = curve.at(0.0).state;
  double lost = 0.0;
  Largest drift;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const TurningPoint<double> at = curve.state_at(e, rule.points[i]);
      const double ds =
          rule.weights[i] * mesh.length(e) * curve.rolling_time() * at.w;
      lost += ds * (drag(world.air, speed(at)) +
                    world.losses.factor(scene.body) * scene.gravity *
                        contact_force(scene, at).normal);
    }
    const TurningPoint<double> at = curve.state_at(e, 1.0);
    const double gained = kinetic(at) - kinetic(start);
    const double work = potential_fall(scene, heavy(start), heavy(at)) - lost;
    drift.see(std::abs(gained - work) / (scene.gravity * scene.H),
              mesh.sigma(e, 1.0));
  }
  certificate.add("energy_drift", drift.value, threshold, drift.where());
}

/// By how much the solution exceeds the limit that it exceeds most, with its
/// own speeds and places: at and between the points of all elements.
void check_limits(const LimitedCurve& curve, Certificate& certificate) {
  constexpr double kAllowed = 1e-8;
  const ExcessAt worst = curve.largest_excess();
  if (worst.value <= 0.0) {
    certificate.add("limits", 0.0, kAllowed);
    return;
  }
  const LimitedTime& problem = curve.problem();
  certificate.add("limits", worst.value, kAllowed,
                  fmt::format("{} at u/U = {:.6g}",
                              name(problem.limits()[at(worst.limit)].kind),
                              problem.mesh().sigma(worst.element, worst.t)));
}

/// Multipliers at the end of an element are impulses, whatever its length, of a
/// limit that holds there alone, touched or about to be held, and of all where
/// one is touched.
bool is_impulse(const LimitedTime& problem, int row) {
  const VariableLayout& layout = problem.layout();
  if (!problem.held() || row >= layout.end_of_points()) return false;
  const int c = layout.point_of(row), i = layout.limit_of(row);
  if (i < 0 || problem.held_at(c, i) == nlp::Held::No) return false;
  const HeldLimits& held = *problem.held();
  const std::size_t e = at(c / problem.mesh().degree);
  const bool last = (c + 1) % problem.mesh().degree == 0;
  const bool touched = last && !held.at_end[e].empty();
  return touched || held.in_element[e][at(i)] == nlp::Held::No;
}

/// On the critical cone: limits that hold are equations, the others are absent.
/// With (p, z, q) positive, zero and negative eigenvalues of the Hessian on the
/// null space of m equations of rank r, the matrix has p + r positive ones, the
/// number of variables if and only if z = q = 0. Equations that depend on each
/// other, as where limits hold the control everywhere, add but zeros.
void check_second_order(const LimitedCurve& curve, Certificate& certificate) {
  LimitedTime problem = curve.problem();
  const nlp::ActiveSet active = nlp::active_set(problem, curve.point());
  const Inertia inertia = kkt_inertia(problem, curve.point());
  const std::optional<int> by_places = positive_by_places(curve);
  const int wanted = active.num_free() + by_places.value_or(0);
  certificate.add(
      "second_order",
      inertia.known && by_places ? std::abs(inertia.positive - wanted)
                                 : kUnmeasured,
      0.0,
      fmt::format("inertia ({}, {}, {}), wanted {} positive", inertia.positive,
                  inertia.negative, inertia.zero, wanted));
}

/// The conditions of the problem whose limits are inequalities.
void check_conditions(const LimitedCurve& curve, double error,
                      Certificate& certificate) {
  constexpr double kComplementarity = 1e-9, kOfError = 0.1;
  // What an element errs by may turn the sign where a multiplier vanishes, as
  // it does quadratically at junctions. One of −ε, even along the whole path,
  // is worth ε² in T, for the control that gives way changes by as much.
  constexpr double kSign = 1e-6;
  const LimitedTime& held = curve.problem();
  LimitedTime problem = held.as_inequalities();
  // Of states, control and rows as the problem has them.
  const int n = problem.num_variables();
  const auto weight = [&](int i) {
    return i >= n && is_impulse(held, i - n) ? 1.0 : problem.weight(i);
  };
  const nlp::KktResidual residual =
      nlp::kkt_residual(problem, curve.point(), weight);
  double least_weight = 1.0;
  for (int i = 0; i < n + problem.num_constraints(); ++i) {
    least_weight = std::min(least_weight, weight(i));
  }
  // Stationarity is a sum of multipliers times matrix entries, as a defect is
  // one of unknowns. Over the weight of a short element rounding alone may be
  // more.
  const double rounding = std::max(problem.rounding(curve.point().x),
                                   problem.rounding(curve.point().lambda)) /
                          least_weight;
  certificate.add("kkt_residual", residual.stationarity,
                  std::max(kThresholds.kkt_residual, rounding),
                  residual.worst_variable);
  certificate.add("defects", residual.infeasibility + residual.bound_violation,
                  kThresholds.defects, residual.worst_constraint);
  if (curve.problem().held()) {
    certificate.add("complementarity", residual.complementarity,
                    kComplementarity, residual.worst_multiplier);
  } else {
    // An interior-point method leaves as much at each point, of short elements
    // too: in sum, what T has yet to lose.
    certificate.add("complementarity", residual.gap / curve.transit_time(),
                    std::max(kComplementarity, kOfError * error),
                    residual.worst_multiplier);
  }
  const double largest =
      std::max(1.0, curve.largest_multiplier(0, problem.mesh().num_elements()));
  certificate.add("multiplier_signs",
                  residual.sign / (largest * curve.rolling_time()), kSign);
}

}  // namespace

Certificate certify(const LimitedCurve& curve, double mismatch, double error) {
  constexpr double kAllowed = 1e-8;
  const LimitedTime& problem = curve.problem();
  Certificate certificate;
  check_conditions(curve, error, certificate);
  check_limits(curve, certificate);
  check_second_order(curve, certificate);
  const TurningPoint<double> first = curve.at(0.0).state;
  const TurningPoint<double> last = curve.at(1.0).state;
  check_contact(problem.scene(), {first.x, first.z}, first.beta,
                {last.x, last.z}, last.beta, 0.0, certificate);
  check_slopes(curve, certificate);
  certificate.add("closure", std::abs(mismatch), kThresholds.tangency);
  Largest steepest;
  for (int node = 0; node < problem.layout().num_nodes(); ++node) {
    steepest.see(std::abs(curve.point().x[at(
                     problem.layout().state(node, StateComponent::Beta))]),
                 node);
  }
  certificate.add("slope_angle", steepest.value, std::numbers::pi);
  constexpr double kRounding = 1e-12;
  const double reached =
      kThresholds.interior_factor * std::max(error, kRounding);
  check_energy(curve, reached, certificate);
  const Reintegration motion = reintegrate(curve);
  certificate.add("reintegration_error", motion.worst(), reached);
  certificate.add("reintegrated_limits", motion.excess, kAllowed,
                  fmt::format("at u/U = {:.6g}", motion.excess_at));
  return certificate;
}

}  // namespace brachisto
