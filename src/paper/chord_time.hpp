// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Transit time of one chord, in units with 2 g = 1.

#pragma once

#include <cmath>

#include "brachisto/run/solve_options.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto::paper {

/// A body and what does not change along its path.
struct Roller {
  Body body;
  DiscreteReading::Quadrature quadrature =
      DiscreteReading::Quadrature::MeanSpeed;
  double sin_theta_m = 0.0;
  /// dθ/ds = 1/r; 0 if the motion does not depend on θ.
  double turns = 0.0;

  Roller(const Body& which, const DiscreteReading& reading)
      : body(which),
        quadrature(reading.quadrature),
        sin_theta_m(std::sin(which.theta_m)),
        turns(which.off_centred() ? 1.0 / which.radius : 0.0) {}
};

/// The body at one node.
template <class Scalar>
struct NodeState {
  Scalar drop, theta, sin_theta, cos_theta, energy;
  bool at_rest = false;  ///< by definition, whatever `energy` is
};

template <class Scalar>
[[nodiscard]] NodeState<Scalar> node_state(const Roller& roller,
                                           const Scalar& drop,
                                           const Scalar& theta,
                                           bool at_rest = false) {
  using std::cos;
  using std::sin;
  const Scalar sine = sin(theta);
  return {drop,
          theta,
          sine,
          cos(theta),
          energy_height_from_sines(roller.body, drop, sine, roller.sin_theta_m),
          at_rest};
}

template <class Scalar>
[[nodiscard]] Scalar chord_length(const Scalar& dx, const Scalar& dz) {
  using std::sqrt;
  return sqrt(dx * dx + dz * dz);
}

/// v_c = √(E/A) with the slope (cos β, sin β) of a chord, eq. (B2).
template <class Scalar>
[[nodiscard]] Scalar speed(const Roller& roller, const NodeState<Scalar>& node,
                           const Scalar& cos_beta, const Scalar& sin_beta) {
  using std::sqrt;
  if (node.at_rest) return Scalar(0.0);
  const Scalar sin_delta =
      node.sin_theta * cos_beta - node.cos_theta * sin_beta;
  return sqrt(node.energy / inertia_factor(roller.body, sin_delta));
}

/// Time from one node to the next. The slope is that of the chord.
/// \param l  chord_length(dx, right.drop − left.drop)
template <class Scalar>
[[nodiscard]] Scalar chord_time(const Roller& roller, const Scalar& dx,
                                const Scalar& l, const NodeState<Scalar>& left,
                                const NodeState<Scalar>& right) {
  using Quadrature = DiscreteReading::Quadrature;
  const Scalar cos_beta = dx / l;
  const Scalar sin_beta = (right.drop - left.drop) / l;
  if (roller.quadrature == Quadrature::Midpoint) {
    const auto middle =
        node_state<Scalar>(roller, (left.drop + right.drop) * 0.5,
                           (left.theta + right.theta) * 0.5);
    return l / speed(roller, middle, cos_beta, sin_beta);
  }
  const Scalar v_left = speed(roller, left, cos_beta, sin_beta);
  const Scalar v_right = speed(roller, right, cos_beta, sin_beta);
  if (roller.quadrature == Quadrature::Trapezoid && !left.at_rest) {
    return l * 0.5 * (Scalar(1.0) / v_left + Scalar(1.0) / v_right);
  }
  return l * 2.0 / (v_left + v_right);
}

}  // namespace brachisto::paper
