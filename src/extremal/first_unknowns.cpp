// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/first_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brachisto/model/cycloid.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

// For constant A, ∂𝓗/∂β = 0 and 𝓗 = 0 say that the vector (w p_x, w p_z + g
// p_w) is −√A (cos β, sin β). With β = π/2 − ψ/2 and w = 2 √(g a) sin ψ/2 this
// gives p_x = −√A/(2 √(g a)); p_w(U) = 0 gives p_z = p_x cot(ψ_end/2).
ExtremalGuess cycloid_guess(const Scene& scene) {
  ExtremalGuess guess;
  const std::optional<CycloidArc> arc = axisymmetric_optimum(scene);
  if (!arc) return guess;
  const double g = scene.gravity;
  const double root = std::sqrt(axisymmetric_inertia_factor(scene.body));
  const double p_x = -root / (2.0 * std::sqrt(g * arc->a));
  const double p_z = p_x / std::tan(0.5 * arc->psi_end);
  const Body body = scene.body;

  guess.rolling_time = arc->rolling_time(g);
  guess.phi = arc->slope_angle(arc->psi_end);
  guess.p_x = p_x;
  guess.p_z = p_z;
  guess.state = [arc = *arc, body, g, root, p_z](double sigma) {
    const double psi = sigma * arc.psi_end;
    const Point centre = arc.at(psi);
    const double w = arc.fall_speed(g, psi);
    const double turned =
        body.rolls() ? arc.arc_length(psi) / body.radius : 0.0;
    return ExtremalState{.x = centre.x,
                         .z = centre.z,
                         .theta = body.theta_m + turned,
                         .w = w,
                         .p_theta = 0.0,
                         .p_w = -(root * std::cos(0.5 * psi) + w * p_z) / g,
                         .beta = arc.slope_angle(psi),
                         .t = root * sigma * arc.rolling_time(g)};
  };
  return guess;
}

namespace shooting {

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

}  // namespace shooting

}  // namespace brachisto
