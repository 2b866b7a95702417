// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Where a path begins on two limits.

#include <cmath>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "math/roots.hpp"
#include "transcription/held_control.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

double LimitedCurve::off_corner() const {
  const StartCorner& corner = *problem_->ends().corner;
  const PathInequality& limit = problem_->limits()[corner.limit];
  const TurningPoint<double> start = at(0, 0.0).state;
  return value_of(limit, problem_->scene(),
                  problem_->pushed() ? start : problem_->resting(start.beta)) -
         bound_of(limit, corner.at);
}

double LimitedCurve::corner_multiplier() const {
  using Jet = math::Jet2<double, 1>;
  const StartCorner& corner = *problem_->ends().corner;
  if (!problem_->pushed()) {
    const double lambda = point_->lambda[brachisto::at(
        problem_->layout().start_row(static_cast<int>(corner.limit)))];
    return corner.at == nlp::Held::AtUpper ? lambda : -lambda;
  }
  std::vector<nlp::Held> held;
  for (int i = 0; i < problem_->layout().num_limits(); ++i) {
    held.push_back(problem_->held_at(0, i));
  }
  const int control = held_of_control(held, problem_->limits());
  LimitedTime problem = *problem_;
  if (control < 0 || !problem.set_point(point_->x)) return std::nan("");
  const auto by_slope = static_cast<double>(
      nlp::lagrangian_gradient(problem, point_->lambda)[brachisto::at(
          problem.layout().state(0, StateComponent::Beta))]);
  const TurningPoint<double> start = at(0, 0.0).state;
  const PathInequality& holds = problem.limits()[brachisto::at(control)];
  const TurningPoint<Jet> turned = with_control_at(
      holds, bound_of(holds, held[brachisto::at(control)]), problem.scene(),
      TurningPoint<Jet>{Jet(start.x), Jet(start.z), Jet(start.theta),
                        Jet(start.w), Jet::variable(start.beta, 0),
                        Jet(start.q)});
  const double rise =
      value_of(problem.limits()[corner.limit], problem.scene(), turned)
          .gradient[0];
  const bool opens = (rise > 0.0) == (corner.at == nlp::Held::AtLower);
  return opens ? by_slope : -by_slope;
}

std::optional<StartCorner> LimitedCurve::corner_at_rest(double exceeded) const {
  const LimitedTime& problem = *problem_;
  for (int i = 0; i < problem.layout().num_limits(); ++i) {
    const PathInequality& limit = problem.limits()[brachisto::at(i)];
    if (limit.bounds_force() && active(0, i)) return std::nullopt;
  }
  if (!holds_control(0)) return std::nullopt;
  const TurningPoint<double> rest = problem.resting(at(0, 0.0).state.beta);
  for (int i = 0; i < problem.layout().num_start_rows(); ++i) {
    const auto number = brachisto::at(i);
    const PathInequality& limit = problem.limits()[number];
    const double value = value_of(limit, problem.scene(), rest);
    if (problem.held()) {
      if (value - limit.upper > exceeded) {
        return StartCorner{number, nlp::Held::AtUpper};
      }
      if (limit.lower - value > exceeded) {
        return StartCorner{number, nlp::Held::AtLower};
      }
    } else if (at_rest_[number] != nlp::Held::No) {
      return StartCorner{number, at_rest_[number]};
    }
  }
  return std::nullopt;
}

LimitedCurve::Misled LimitedCurve::misled_from_rest() const {
  using Jet = math::Jet2<double, 1>;
  const LimitedTime& problem = *problem_;
  const Scene& scene = problem.scene();
  const auto& corner = problem.ends().corner;
  if (!problem.held() || !corner || problem.pushed()) return {};
  const auto& in_element = problem.held()->in_element;
  std::size_t arc = 1;  // as many elements as hold the same
  while (arc < in_element.size() && in_element[arc] == in_element.front()) {
    ++arc;
  }
  const double end = problem.mesh().boundaries[arc];
  const int control = held_of_control(in_element.front(), problem.limits());
  if (control < 0) return {};
  // Of the control at its greatest p_β is not positive, and not negative at its
  // least.
  const TurningPoint<double> middle = at(0.5 * end).state;
  const double rise =
      value_of(problem.limits()[brachisto::at(control)], scene,
               TurningPoint<Jet>{Jet(middle.x), Jet(middle.z),
                                 Jet(middle.theta), Jet(middle.w),
                                 Jet(middle.beta), Jet::variable(middle.q, 0)})
          .gradient[0];
  const bool at_greatest = (in_element.front()[brachisto::at(control)] ==
                            nlp::Held::AtUpper) == (rise > 0.0);
  const auto wrong = [&](double sigma) {  // > 0 as far as it is
    const double p_beta = at(sigma).p_beta;
    return at_greatest ? p_beta : -p_beta;
  };
  if (!(wrong(0.0) > 0.0)) return {};
  constexpr double kFirst = 1e-9, kWider = 1.3;
  Misled out;
  for (double here = kFirst, last = 0.0; here < end && out.until == 0.0;
       last = std::exchange(here, kWider * here)) {
    if (!(wrong(here) <= 0.0)) continue;
    out.until = math::find_root(wrong, last, here, wrong(last), wrong(here));
  }
  if (out.until == 0.0) return out;
  const PathInequality& limit = problem.limits()[corner->limit];
  const double bound = bound_of(limit, corner->at);
  const bool stationary = scene.contact != Contact::Smooth;
  const math::QuadratureRule rule = math::gauss_legendre(4);
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const LimitedPoint here = at(out.until * rule.points[i]);
    const double turn =
        with_control_at(limit, bound, scene, here.state).q - here.state.q;
    out.cost +=
        rule.weights[i] *
        std::abs(stationary ? here.p_beta * turn / transit_time() : turn);
  }
  out.cost *= out.until * rolling_time();
  return out;
}

}  // namespace brachisto
