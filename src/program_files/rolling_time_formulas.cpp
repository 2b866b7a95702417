// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/rolling_time_formulas.hpp"

#include <array>

#include "math/index.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto::program_files {

namespace {

using enum StateComponent;

constexpr std::array kQuantityStates{X, Z, Theta, W};
constexpr int kNumQuantityStates = static_cast<int>(kQuantityStates.size());

}  // namespace

int RollingTimeFormulas::num_quantities() const {
  return kNumQuantityStates * layout().num_points();
}

Formula RollingTimeFormulas::quantity(int index) const {
  const StateComponent component =
      kQuantityStates[at(index % kNumQuantityStates)];
  if (component == Theta && !layout().has_theta()) return 0.0;
  const int p = problem_.mesh().degree;
  const int point = index / kNumQuantityStates;
  Formula sum;
  for (int n = 0; n <= p; ++n) {
    sum += problem_.scheme().interpolation(point % p, n) *
           Formula::unknown(layout().state(point / p * p + n, component));
  }
  return sum;
}

Formula RollingTimeFormulas::at_point(int point,
                                      StateComponent component) const {
  return Formula::quantity(kNumQuantityStates * point +
                           static_cast<int>(component));
}

Formula RollingTimeFormulas::beta(int point) const {
  return Formula::unknown(layout().beta(point));
}

Formula RollingTimeFormulas::duration(int point) const {
  return problem_.mesh().length(point / problem_.mesh().degree) *
         Formula::unknown(layout().rolling_time());
}

Formula RollingTimeFormulas::root(int point) const {
  const Formula theta = layout().has_theta() ? at_point(point, Theta) : 0.0;
  return root_of_inertia(problem_.scene().body, theta, beta(point));
}

int RollingTimeFormulas::num_objective_parts() const {
  return layout().num_points();
}

Formula RollingTimeFormulas::objective_part(int point) const {
  const double b =
      problem_.scheme().rule.weights[at(point % problem_.mesh().degree)];
  return b * duration(point) * root(point);
}

Formula RollingTimeFormulas::constraint(int index) const {
  const Scene& scene = problem_.scene();
  const int p = problem_.mesh().degree;
  const int point = layout().point_of(index);
  const Formula hU = duration(point);
  const Formula w = at_point(point, W);
  const auto difference = [&](StateComponent component) {
    Formula sum;
    for (int n = 0; n <= p; ++n) {
      sum += problem_.scheme().derivative(point % p, n) *
             Formula::unknown(layout().state(point / p * p + n, component));
    }
    return sum;
  };
  const auto is = [&](StateComponent component) {
    return index == layout().defect(point, component);
  };
  if (is(X)) return place_defect(difference(X), hU, w, cos(beta(point)));
  if (is(Z)) return place_defect(difference(Z), hU, w, sin(beta(point)));
  if (layout().has_theta() && is(Theta)) {
    return turning_defect(difference(Theta), hU, w, scene.body.radius);
  }
  const Formula theta = layout().has_theta() ? at_point(point, Theta) : 0.0;
  if (scene.world.changes_rates()) {
    return speed_defect(
        difference(W), hU, 1.0,
        speed_gain(scene, at_point(point, X), at_point(point, Z), theta, w,
                   beta(point), root(point)));
  }
  const Formula gain = layout().has_theta()
                           ? energy_slope(scene.body, theta, beta(point))
                           : sin(beta(point));
  return speed_defect(difference(W), hU, scene.gravity, gain);
}

}  // namespace brachisto::program_files
