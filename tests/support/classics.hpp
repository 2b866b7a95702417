// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Classics of optimal control with closed forms: their formulas, and what is
/// said of them.

#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "brachisto/ocp.hpp"

namespace brachisto::testing {

/// s' = v, v' = u, in the least time or with the least ∫ u²/2 dt.
struct Cart : ocp::Sizes<2, 1> {
  bool effort = false;
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& u = at.controls[0];
    return {effort ? u * u * 0.5 : S(1.0), {at.states[1], u}};
  }
};

/// From rest at 0 to rest at 1.
[[nodiscard]] inline ocp::Statement cart(double strongest_brake,
                                         double strongest_push) {
  return {
      .name = "cart",
      .states = {{.name = "s", .start = 0.0, .end = 1.0},
                 {.name = "v", .start = 0.0, .end = 0.0}},
      .controls = {
          {.name = "u", .lower = -strongest_brake, .upper = strongest_push}}};
}

/// Bryson and Denham (1963): x ≤ l is kept by the cost 4/(9 l) for l ≤ 1/6.
[[nodiscard]] inline ocp::Statement out_and_back(double wall) {
  return {.name = "out and back",
          .states = {{.name = "x", .upper = wall, .start = 0.0, .end = 0.0},
                     {.name = "v", .start = 1.0, .end = -1.0}},
          .controls = {{.name = "u"}},
          .duration = ocp::Duration::fixed(1.0)};
}

/// The push as a difference of two, whose sum costs.
struct Fuel : ocp::Sizes<2, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [push, brake] = at.controls;
    return {push + brake, {at.states[1], push - brake}};
  }
};

/// In the time 3: v (3 − v) = 1, pushed and braked for v each; 3 − √5.
[[nodiscard]] inline ocp::Statement least_fuel() {
  ocp::Statement out = cart(0.0, 1.0);
  out.controls = {{.name = "push", .lower = 0.0, .upper = 1.0},
                  {.name = "brake", .lower = 0.0, .upper = 1.0}};
  out.duration = ocp::Duration::fixed(3.0);
  return out;
}

/// ∫ x ds of a chain of given length.
struct Chain : ocp::Sizes<2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& u = at.controls[0];
    const S along = sqrt(u * u + 1.0);
    return {at.states[0] * along, {u, along}};
  }
};

[[nodiscard]] inline ocp::Statement chain() {
  return {.name = "chain",
          .states = {{.name = "x", .start = 1.0, .end = 3.0},
                     {.name = "l", .start = 0.0, .end = 4.0}},
          .controls = {{.name = "u",
                        .guess = [](double t) { return 8.0 * t - 3.0; }}},
          .duration = ocp::Duration::fixed(1.0)};
}

/// (x, z, v), z downwards.
struct Bead : ocp::Sizes<3, 1> {
  double g;
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& v = at.states[2];
    const S c = cos(at.controls[0]), s = sin(at.controls[0]);
    return {S(1.0), {v * c, v * s, s * g}};
  }
};

/// From rest to 3 across and 1 below, g = 1/2.
[[nodiscard]] inline ocp::Statement bead_to_point() {
  return {.name = "bead",
          .states = {{.name = "x", .start = 0.0, .end = 3.0},
                     {.name = "z", .start = 0.0, .end = 1.0},
                     {.name = "v",
                      .lower = 0.0,
                      .start = 0.0,
                      .guess = [](double t) { return std::sqrt(t); }}},
          .controls = {{.name = "slope",
                        .lower = -2.0,
                        .upper = 2.0,
                        .guess = [](double t) { return 1.5 - 2.0 * t; }}},
          .duration = {.guess = 4.0}};
}

/// (x, w = z − x/2, v): a wall is a bound of a state.
struct BeadBesideWall : ocp::Sizes<3, 1> {
  double g;
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& v = at.states[2];
    const S c = cos(at.controls[0]), s = sin(at.controls[0]);
    return {S(1.0), {v * c, v * (s - c * 0.5), s * g}};
  }
};

/// To x = 1 with w ≤ 0.1.
///
/// \param speed  about the last one
/// \param time   about what it takes
[[nodiscard]] inline ocp::Statement bead_beside_wall(double speed,
                                                     double time) {
  constexpr double kUpright = 0.5 * std::numbers::pi;
  return {.name = "bead beside a wall",
          .states = {{.name = "x", .lower = 0.0, .start = 0.0, .end = 1.0},
                     {.name = "w", .upper = 0.1, .start = 0.0},
                     {.name = "v",
                      .lower = 0.0,
                      .start = 0.0,
                      .guess = [=](double t) { return speed * std::sqrt(t); }}},
          .controls = {{.name = "slope",
                        .lower = -kUpright,
                        .upper = kUpright,
                        .guess = [](double t) { return 1.4 * (1.0 - t); }}},
          .duration = {.guess = time}};
}

}  // namespace brachisto::testing
