// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/places.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "math/dense.hpp"
#include "nlp/active_set.hpp"
#include "solvers/chain_ldlt.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

/// The end of an element, and what is touched there.
struct Place {
  int element;
  int limit = -1;  ///< −1 where the limit that holds the control changes
  double multiplier = 0.0;
};

std::vector<Place> touches_of(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  std::vector<Place> touches;
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

/// Where a limit takes the control over from another one.
std::vector<Place> switches_of(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  std::vector<Place> switches;
  if (!problem.held()) return switches;
  const auto& held = problem.held()->in_element;
  const auto holds = [&](std::size_t e) {
    return held_of_control(held[e], problem.limits()) >= 0;
  };
  for (std::size_t e = 0; e + 1 < held.size(); ++e) {
    if (held[e] != held[e + 1] && holds(e) && holds(e + 1)) {
      switches.push_back({static_cast<int>(e)});
    }
  }
  return switches;
}

/// c' and c'' of what is touched, by the share of the element.
std::array<double, 2> rates_at(const LimitedCurve& curve, const Place& touch) {
  // Five values: what has to be large against rounding is c'', a polynomial's.
  constexpr double kStep = 0.05;
  const Scene& scene = curve.problem().scene();
  const auto value = [&](double t) {
    return value_of(curve.problem().limits()[at(touch.limit)], scene,
                    curve.state_at(touch.element, t));
  };
  const double near = value(1.0 + kStep), far = value(1.0 + 2.0 * kStep);
  const double back = value(1.0 - kStep), rear = value(1.0 - 2.0 * kStep);
  return {(8.0 * (near - back) - (far - rear)) / (12.0 * kStep),
          (16.0 * (near + back) - (far + rear) - 30.0 * value(1.0)) /
              (12.0 * kStep * kStep)};
}

class Places {
 public:
  explicit Places(const LimitedCurve& curve)
      : curve_(curve), problem_(curve.problem()), places_(touches_of(curve)) {}

  [[nodiscard]] std::optional<int> positive() {
    std::vector<Place> switches = switches_of(curve_);
    // What is touched where it begins to hold leaves the control no choice
    // there: it does not jump.
    std::erase_if(switches, [&](const Place& place) {
      const auto& after = problem_.held()->in_element[at(place.element) + 1];
      return std::ranges::any_of(places_, [&](const Place& touch) {
        return touch.element == place.element &&
               after[at(touch.limit)] != nlp::Held::No;
      });
    });
    places_.insert(places_.end(), switches.begin(), switches.end());
    if (places_.empty()) return 0;
    Eigen::MatrixXd schur = own_rates();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      if (places_[i].limit >= 0 && !(schur(j, j) <= 0.0)) return std::nullopt;
    }
    const nlp::ActiveSet active = nlp::active_set(problem_, curve_.point());
    if (active.num_equations() > active.num_free()) return 0;
    const std::unique_ptr<ChainLdlt> chain = make_chain_ldlt(problem_, active);
    if (!chain || !factorise(*chain)) return 0;
    std::vector<std::vector<double>> columns;
    for (const Place& place : places_) {
      columns.push_back(place.limit < 0 ? by_switch(place) : by_touch(place));
      keep_active(active, columns.back());
    }
    for (Eigen::Index j = 0; j < schur.cols(); ++j) {
      std::vector<double> solved = columns[static_cast<std::size_t>(j)];
      chain->solve(solved);
      for (Eigen::Index i = 0; i < schur.rows(); ++i) {
        const std::vector<double>& row = columns[static_cast<std::size_t>(i)];
        schur(i, j) -=
            std::inner_product(row.begin(), row.end(), solved.begin(), 0.0);
      }
    }
    if (!schur.allFinite()) return std::nullopt;
    const auto jumps = std::ranges::count_if(
        switches, [&](const Place& place) { return jumps_at(place.element); });
    return static_cast<int>(jumps -
                            (math::eigenvalues(schur).array() > 0.0).count());
  }

 private:
  [[nodiscard]] bool factorise(ChainLdlt& chain) {
    if (!problem_.set_point(curve_.point().x)) return false;
    std::vector<double> hess(problem_.hess_lag_pattern().num_entries());
    problem_.eval_hess_lag(1.0, curve_.point().lambda, hess);
    std::vector<double> jac(problem_.jac_g_pattern().num_entries());
    problem_.eval_jac_g(jac);
    const std::array<std::span<const double>, 2> values = {hess, jac};
    return chain.factorise(values) && chain.inertia().zero == 0;
  }

  [[nodiscard]] std::vector<double> nothing() const {
    return std::vector<double>(
        at(problem_.num_variables() + problem_.num_constraints()), 0.0);
  }

  /// What is given has no part in K.
  void keep_active(const nlp::ActiveSet& active,
                   std::vector<double>& column) const {
    for (std::size_t i = 0; i < active.variables.size(); ++i) {
      if (active.variables[i] != nlp::Held::No) column[i] = 0.0;
    }
    for (std::size_t i = 0; i < active.constraints.size(); ++i) {
      if (active.constraints[i] == nlp::Held::No) {
        column[active.variables.size() + i] = 0.0;
      }
    }
  }

  [[nodiscard]] bool jumps_at(int element) const {
    const auto& held = problem_.held()->in_element;
    return opposite(problem_, held[at(element)], held[at(element + 1)],
                    curve_.state_at(element, 1.0));
  }

  /// The element before grows, the one behind shrinks.
  [[nodiscard]] std::vector<double> by_switch(const Place& place) const {
    std::vector<double> column = nothing();
    problem_.add_rates_by_length(place.element, 1.0, curve_.point().lambda,
                                 column);
    problem_.add_rates_by_length(place.element + 1, -1.0, curve_.point().lambda,
                                 column);
    return column;
  }

  /// L_xt = λ ∂c'/∂x, of the states and controls of the element.
  [[nodiscard]] std::vector<double> by_touch(const Place& touch) const {
    constexpr double kStep = 1e-5;
    const VariableLayout& layout = problem_.layout();
    const int p = problem_.mesh().degree;
    std::vector<double> column = nothing();
    const auto problem = std::make_shared<LimitedTime>(problem_);
    const auto rate_by = [&](int variable, double step) {
      if (problem_.variable_range(variable).single()) return;
      const auto moved = [&](double by) {
        PrimalDual point = curve_.point();
        point.x[at(variable)] += by;
        return rates_at(LimitedCurve(problem, std::move(point)), touch)[0];
      };
      column[at(variable)] =
          touch.multiplier * (moved(step) - moved(-step)) / (2.0 * step);
    };
    for (int node = touch.element * p; node <= (touch.element + 1) * p;
         ++node) {
      const int w = layout.state(node, StateComponent::W);
      for (int i = 0; i < layout.num_states(); ++i) {
        const int state = layout.state(node, StateComponent::X) + i;
        // Next to rest the speed leaves no room for a step as long.
        rate_by(state, state == w
                           ? kStep * std::min(1.0, curve_.point().x[at(w)])
                           : kStep);
      }
    }
    for (int c = touch.element * p; c < (touch.element + 1) * p; ++c) {
      rate_by(layout.control(c), kStep);
    }
    return column;
  }

  /// C.
  [[nodiscard]] Eigen::MatrixXd own_rates() const {
    constexpr double kShare = 1e-4;
    const auto size = static_cast<Eigen::Index>(places_.size());
    Eigen::MatrixXd own = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      const Place& place = places_[static_cast<std::size_t>(j)];
      if (place.limit >= 0) {
        own(j, j) = place.multiplier * rates_at(curve_, place)[1];
        continue;
      }
      const Mesh& mesh = problem_.mesh();
      const double step = kShare * std::min(mesh.length(place.element),
                                            mesh.length(place.element + 1));
      const Eigen::VectorXd more = slopes_where(place, step);
      own.col(j) = (more - slopes_where(place, -step)) / (2.0 * step);
      own.row(j) = own.col(j);
    }
    return own;
  }

  /// The derivatives of the Lagrangian by all places where a switch is
  /// elsewhere, but for what does not change with it.
  [[nodiscard]] Eigen::VectorXd slopes_where(const Place& at_switch,
                                             double by) const {
    const auto moved = std::make_shared<LimitedTime>(problem_);
    Mesh mesh = problem_.mesh();
    mesh.boundaries[at(at_switch.element + 1)] += by;
    moved->change(problem_.limits(), mesh, problem_.ends());
    Eigen::VectorXd slopes =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(places_.size()),
                                  std::numeric_limits<double>::quiet_NaN());
    if (!moved->set_point(curve_.point().x)) return slopes;
    const LimitedCurve there(moved, curve_.point());
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      double& slope = slopes[static_cast<Eigen::Index>(i)];
      if (place.limit >= 0) {
        slope = place.multiplier * rates_at(there, place)[0];
        continue;
      }
      // f is linear in the lengths.
      std::vector<double> rates = nothing();
      for (const int e : {0, 1}) {
        moved->add_rates_by_length(place.element + e, e == 0 ? 1.0 : -1.0,
                                   curve_.point().lambda, rates);
      }
      slope = std::inner_product(curve_.point().lambda.begin(),
                                 curve_.point().lambda.end(),
                                 rates.begin() + problem_.num_variables(), 0.0);
    }
    return slopes;
  }

  const LimitedCurve& curve_;
  LimitedTime problem_;
  std::vector<Place> places_;
};

}  // namespace

std::optional<int> positive_by_places(const LimitedCurve& curve) {
  return Places(curve).positive();
}

}  // namespace brachisto
