// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/limited_time_formulas.hpp"

#include <array>

#include "math/index.hpp"
#include "model/field.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto::program_files {

namespace {

using enum StateComponent;

constexpr std::array kLimitedStates{X, Z, Theta, W, Beta};

}  // namespace

Formula LimitedTimeFormulas::state(int node, StateComponent component) const {
  if (component == Theta && !layout().has_theta()) return 0.0;
  return Formula::unknown(layout().state(node, component));
}

TurningPoint<Formula> LimitedTimeFormulas::turning_point(int point) const {
  const int node = point + 1;
  const double h = problem_.mesh().length(point / problem_.mesh().degree);
  return {state(node, X),
          state(node, Z),
          state(node, Theta),
          state(node, W),
          state(node, Beta),
          Formula::unknown(layout().control(point)) * (1.0 / h)};
}

Formula LimitedTimeFormulas::duration(int point) const {
  return problem_.mesh().length(point / problem_.mesh().degree) *
         Formula::unknown(layout().rolling_time());
}

int LimitedTimeFormulas::num_objective_parts() const {
  return layout().num_points();
}

Formula LimitedTimeFormulas::objective_part(int point) const {
  const double b =
      problem_.scheme().rule.weights[at(point % problem_.mesh().degree)];
  return b * duration(point) *
         root_of_inertia(problem_.scene().body, state(point + 1, Theta),
                         state(point + 1, Beta));
}

Formula LimitedTimeFormulas::constraint(int index) const {
  if (index >= layout().start_row(0)) {
    return limit_at_rest(index - layout().start_row(0));
  }
  if (index >= layout().contact_row(0)) {
    return contact(index - layout().contact_row(0));
  }
  const int point = layout().point_of(index);
  if (index >= layout().limit(point, 0)) {
    const Scene& scene = problem_.scene();
    const int limit = index - layout().limit(point, 0);
    return value_of(problem_.limits()[at(limit)], scene.body, scene.gravity,
                    turning_point(point));
  }
  for (const StateComponent component : kLimitedStates) {
    if (component == Theta && !layout().has_theta()) continue;
    if (index == layout().defect(point, component)) {
      return defect(point, component);
    }
  }
  return {};
}

Formula LimitedTimeFormulas::defect(int point, StateComponent component) const {
  const int p = problem_.mesh().degree;
  const Body& body = problem_.scene().body;
  const TurningPoint<Formula> here = turning_point(point);
  Formula difference;
  for (int n = 0; n <= p; ++n) {
    difference += problem_.scheme().derivative(point % p, n) *
                  state(point / p * p + n, component);
  }
  const auto rate = [&]() -> Formula {
    switch (component) {
      case X:
        return place_rate(here.w, cos(here.beta));
      case Z:
        return place_rate(here.w, sin(here.beta));
      case Theta:
        return turning_rate(here.w, body.radius);
      case W:
        return speed_rate(problem_.scene().gravity,
                          layout().has_theta() ? body.eta_m : 0.0,
                          sin(here.beta), cos(here.theta));
      case Beta:
        return here.q;
    }
    return {};
  };
  return difference - duration(point) * rate();
}

Formula LimitedTimeFormulas::limit_at_rest(int limit) const {
  const Scene& scene = problem_.scene();
  return value_of(problem_.limits()[at(limit)], scene.body, scene.gravity,
                  TurningPoint<Formula>{0.0, 0.0, scene.body.theta_m, 0.0,
                                        state(0, Beta), 0.0});
}

Formula LimitedTimeFormulas::contact(int number) const {
  const Scene& scene = problem_.scene();
  const bool at_A = number < 2;
  const int node = at_A ? 0 : layout().num_points();
  const OffContact<Formula> off = off_contact(
      state(node, X), state(node, Z), scene.body.radius, at_A ? 0.0 : scene.L,
      at_A ? 0.0 : scene.H, state(node, Beta));
  return number % 2 == 0 ? off.x : off.z;
}

}  // namespace brachisto::program_files
