// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The checks of a solution under limits.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/nlp/kkt_residual.hpp"
#include "math/index.hpp"
#include "model/contact.hpp"
#include "nlp/active_set.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/inertia.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/contact_error.hpp"
#include "trajectory/reintegration.hpp"

namespace brachisto {

namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

void check_ends(const LimitedCurve& curve, Certificate& certificate) {
  constexpr double kContact = 1e-9;
  const Scene& scene = curve.problem().scene();
  const auto first = curve.at(0.0).state;
  const auto last = curve.at(1.0).state;
  Point start{first.x, first.z}, end{last.x, last.z};
  if (scene.contact != Contact::Centre) {
    start = track_below(start, scene.body.radius, first.beta);
    end = track_below(end, scene.body.radius, last.beta);
  }
  certificate.add("contact_error", contact_error(scene, start, end), kContact);
}

/// By how much the solution exceeds the limit that it exceeds most, with its
/// own speeds and places: at and between the points of all elements.
void check_limits(const LimitedCurve& curve, Certificate& certificate) {
  constexpr double kAllowed = 1e-8;
  double worst = 0.0;
  std::string where;
  for (int e = 0; e < curve.problem().mesh().num_elements(); ++e) {
    check_stop(e);
    double sigma = 0.0;
    const Excess excess = curve.excess_on(e, sigma);
    if (std::isnan(worst) || excess.value <= worst) continue;
    worst = excess.value;
    where = fmt::format("{} at u/U = {:.6g}",
                        name(curve.problem().limits()[at(excess.limit)].kind),
                        sigma);
  }
  certificate.add("limits", worst, kAllowed, where);
}

/// What the path touches at the end of an element.
struct TouchedAt {
  int element;
  int limit;
  double multiplier;  ///< λ of its equation
};

std::vector<TouchedAt> touches_of(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  std::vector<TouchedAt> touches;
  if (!problem.held()) return touches;
  const auto& at_end = problem.held()->at_end;
  // At B there is no place to move.
  for (std::size_t e = 0; e + 1 < at_end.size(); ++e) {
    for (std::size_t i = 0; i < at_end[e].size(); ++i) {
      if (at_end[e][i] == nlp::Held::No) continue;
      const auto element = static_cast<int>(e);
      const auto limit = static_cast<int>(i);
      const int point = (element + 1) * problem.mesh().degree - 1;
      touches.push_back(
          {element, limit,
           curve.point().lambda[at(problem.layout().limit(point, limit))]});
    }
  }
  return touches;
}

/// Of states, control and rows as the problem has them; but where a limit holds
/// at the end of an element alone, touched or about to be held, its multiplier
/// is an impulse, whatever the length of the element.
std::vector<double> weights_of(const LimitedCurve& curve,
                               const LimitedTime& problem) {
  std::vector<double> weights(problem.weights().begin(),
                              problem.weights().end());
  const LimitedTime& held = curve.problem();
  if (!held.held()) return weights;
  for (int c = 0; c < problem.layout().num_points(); ++c) {
    const std::vector<nlp::Held>& all_along =
        held.held()->in_element[at(c / problem.mesh().degree)];
    for (int i = 0; i < problem.layout().num_limits(); ++i) {
      if (held.held_at(c, i) == nlp::Held::No ||
          all_along[at(i)] != nlp::Held::No) {
        continue;
      }
      weights[at(problem.num_variables() + problem.layout().limit(c, i))] = 1.0;
    }
  }
  return weights;
}

/// c' and c'' of what is touched, by the share of the element.
std::array<double, 2> rates_at(const LimitedCurve& curve,
                               const TouchedAt& touch) {
  // Five values: what has to be large against rounding is c'', a polynomial's.
  constexpr double kStep = 0.05;
  const Scene& scene = curve.problem().scene();
  const auto value = [&](double t) {
    return value_of(curve.problem().limits()[at(touch.limit)], scene.body,
                    scene.gravity, curve.at(touch.element, t).state);
  };
  const double near = value(1.0 + kStep), far = value(1.0 + 2.0 * kStep);
  const double back = value(1.0 - kStep), rear = value(1.0 - 2.0 * kStep);
  return {(8.0 * (near - back) - (far - rear)) / (12.0 * kStep),
          (16.0 * (near + back) - (far + rear) - 30.0 * value(1.0)) /
              (12.0 * kStep * kStep)};
}

/// Where the path touches a limit is a variable too, t, with L_tt = λ c'' < 0
/// and L_xt = λ ∂c'/∂x: the limit asks for the largest value along the path.
/// With K the KKT matrix for fixed t eliminating t adds to the Hessian, and by
/// Haynsworth's formula as many positive eigenvalues as
/// L_tt − L_tx K⁻¹ L_xt has. Nothing if L_tt > 0 or if it cannot be told.
std::optional<int> positive_by_touches(LimitedTime& problem,
                                       const LimitedCurve& curve) {
  const std::vector<TouchedAt> touches = touches_of(curve);
  const std::unique_ptr<ChainLdlt> chain =
      touches.empty()
          ? nullptr
          : make_chain_ldlt(problem, nlp::active_set(problem, curve.point()));
  if (!chain || !problem.set_point(curve.point().x)) return 0;
  std::vector<double> hess(problem.hess_lag_pattern().num_entries());
  problem.eval_hess_lag(1.0, curve.point().lambda, hess);
  std::vector<double> jac(problem.jac_g_pattern().num_entries());
  problem.eval_jac_g(jac);
  const std::array<std::span<const double>, 2> values = {hess, jac};
  if (!chain->factorise(values) || chain->inertia().zero > 0) return 0;
  const int n = problem.num_variables();
  const int p = problem.mesh().degree;
  const VariableLayout& layout = problem.layout();
  const auto size = static_cast<Eigen::Index>(touches.size());
  Eigen::MatrixXd by_place = Eigen::MatrixXd::Zero(size, size);
  std::vector<std::vector<double>> mixed;
  for (const TouchedAt& touch : touches) {
    std::vector<double>& column =
        mixed.emplace_back(at(n + problem.num_constraints()), 0.0);
    const auto rate_by = [&](int variable) {
      constexpr double kStep = 1e-5;
      if (problem.variable_range(variable).single()) return;
      const auto moved = [&](double by) {
        PrimalDual point = curve.point();
        point.x[at(variable)] += by;
        // Next to rest the speed may leave no room for the step.
        if (!problem.set_point(point.x)) return kNotKnown;
        return rates_at(LimitedCurve(problem, std::move(point)), touch)[0];
      };
      column[at(variable)] =
          touch.multiplier * (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
    };
    for (int node = touch.element * p; node <= (touch.element + 1) * p;
         ++node) {
      for (int i = 0; i < layout.num_states(); ++i) {
        rate_by(layout.state(node, StateComponent::X) + i);
      }
    }
    for (int c = touch.element * p; c < (touch.element + 1) * p; ++c) {
      rate_by(layout.control(c));
    }
    const auto i = static_cast<Eigen::Index>(mixed.size()) - 1;
    by_place(i, i) = touch.multiplier * rates_at(curve, touch)[1];
    if (!(by_place(i, i) <= 0.0)) return std::nullopt;
  }
  for (Eigen::Index j = 0; j < size; ++j) {
    std::vector<double> solved = mixed[static_cast<std::size_t>(j)];
    chain->solve(solved);
    for (Eigen::Index i = 0; i < size; ++i) {
      const std::vector<double>& row = mixed[static_cast<std::size_t>(i)];
      by_place(i, j) -=
          std::inner_product(row.begin(), row.end(), solved.begin(), 0.0);
    }
  }
  if (!by_place.allFinite()) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      by_place, Eigen::EigenvaluesOnly);
  return static_cast<int>((eigen.eigenvalues().array() > 0.0).count());
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
  const std::optional<int> by_touches = positive_by_touches(problem, curve);
  const int wanted = active.num_free() - by_touches.value_or(0);
  certificate.add(
      "second_order",
      inertia.known && by_touches ? std::abs(inertia.positive - wanted)
                                  : kNotKnown,
      0.0,
      fmt::format("inertia ({}, {}, {}), wanted {} positive", inertia.positive,
                  inertia.negative, inertia.zero, wanted));
}

}  // namespace

Certificate certify(const LimitedCurve& curve, double mismatch, double error) {
  constexpr double kResidual = 1e-9;
  constexpr double kComplementarity = 1e-9;
  // What an element errs by may turn the sign where a multiplier vanishes, as
  // it does quadratically at junctions. One of −ε, even along the whole path,
  // is worth ε² in T, for the control that gives way changes by as much.
  constexpr double kSign = 1e-6;
  constexpr double kTangency = 1e-8;
  constexpr double kAllowed = 1e-8;
  Certificate certificate;
  LimitedTime problem = curve.problem().as_inequalities();
  const std::vector<double> weights = weights_of(curve, problem);
  const nlp::KktResidual residual =
      nlp::kkt_residual(problem, curve.point(), weights);
  // Over the weight of a short element rounding alone may be more.
  const double rounding = problem.rounding(curve.point().x) /
                          *std::min_element(weights.begin(), weights.end());
  certificate.add("kkt_residual", residual.stationarity,
                  std::max(kResidual, rounding), residual.worst_variable);
  certificate.add("defects", residual.infeasibility + residual.bound_violation,
                  kResidual, residual.worst_constraint);
  certificate.add("complementarity", residual.complementarity, kComplementarity,
                  residual.worst_multiplier);
  const double largest =
      std::max(1.0, curve.largest_multiplier(0, problem.mesh().num_elements()));
  certificate.add("multiplier_signs",
                  residual.sign / (largest * curve.rolling_time()), kSign);
  check_limits(curve, certificate);
  check_second_order(curve, certificate);
  check_ends(curve, certificate);
  certificate.add("closure", std::abs(mismatch), kTangency);
  double steepest = 0.0;
  for (int node = 0; node < problem.layout().num_nodes(); ++node) {
    const double slope = std::abs(
        curve.point()
            .x[at(problem.layout().state(node, StateComponent::Beta))]);
    // Written so that a NaN stays.
    if (!(slope <= steepest)) steepest = slope;
  }
  certificate.add("slope_angle", steepest, std::numbers::pi);
  constexpr double kInterior = 100.0;
  constexpr double kRounding = 1e-12;
  const LimitedReintegration motion = reintegrate(curve);
  certificate.add("reintegration_error", motion.error,
                  kInterior * std::max(error, kRounding));
  certificate.add("reintegrated_limits", motion.excess, kAllowed,
                  fmt::format("at u/U = {:.6g}", motion.excess_at));
  return certificate;
}

}  // namespace brachisto
