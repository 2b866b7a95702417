// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/first_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachisto::shooting {

int choose_arcs(const Scene& natural, const ExtremalGuess& guess, int wanted) {
  constexpr int kFewest = 4;
  constexpr int kMost = 20000;
  constexpr double kPerTurn = 3.0;
  if (wanted > 0) return wanted;
  const double turns =
      natural.body.rolls()
          ? std::abs(guess.state(1.0).theta - natural.body.theta_m) /
                (2.0 * std::numbers::pi)
          : 0.0;
  return static_cast<int>(
      std::clamp(std::ceil(kPerTurn * turns), 1.0 * kFewest, 1.0 * kMost));
}

ChainVector to_chain(const Scene& natural, const Units& units,
                     const ExtremalGuess& guess, int num_arcs) {
  ChainVector point;
  point.globals << guess.rolling_time / units.time, guess.p_x * units.speed(),
      guess.p_z * units.speed(), guess.phi, natural.body.eta_m;
  for (int i = 0; i <= num_arcs; ++i) {
    const ExtremalState s = guess.state(static_cast<double>(i) / num_arcs);
    Vector6 node;
    node << s.x / units.length, s.z / units.length, s.theta,
        s.w / units.speed(), s.p_theta / units.time,
        s.p_w * units.speed() / units.time;
    point.nodes.push_back(node);
  }
  return point;
}

ChainScale scale_of(const Scene& natural, const ChainVector& point) {
  const double p = std::hypot(point.globals(kPX), point.globals(kPZ));
  ChainScale scale;
  scale.globals << point.globals(kU), p, p, 1.0, 1.0;
  scale.node << 1.0, 1.0, 1.0, 1.0, 1.0 / inverse_radius(natural.body),
      std::max(1.0, std::abs(point.nodes.front()(kPW)));
  return scale;
}

}  // namespace brachisto::shooting
