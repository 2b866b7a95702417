// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <numbers>

#include "reference/classic.hpp"
#include "reference/second_methods.hpp"

namespace brachisto::benchmarks {

namespace {

using ocp::Sizes;
using ocp::Statement;

struct Cart : Sizes<2, 1> {
  bool effort = false;
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& u = at.controls[0];
    return {effort ? u * u * 0.5 : S(1.0), {at.states[1], u}};
  }
};

/// The push as a difference of two, whose sum costs.
struct Fuel : Sizes<2, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [push, brake] = at.controls;
    return {push + brake, {at.states[1], push - brake}};
  }
};

struct Chain : Sizes<2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& u = at.controls[0];
    const S along = sqrt(u * u + 1.0);
    return {at.states[0] * along, {u, along}};
  }
};

/// (x, z, v), z downwards.
struct Bead : Sizes<3, 1> {
  double g;
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& v = at.states[2];
    const S c = cos(at.controls[0]), s = sin(at.controls[0]);
    return {S(1.0), {v * c, v * s, s * g}};
  }
};

/// The same with a wall as a limit of the path.
struct BeadOverWall : Bead {
  template <class S>
  [[nodiscard]] std::array<S, 1> limits(const Point<S>& at) const {
    return {at.states[1] - at.states[0] * 0.5};
  }
};

/// (x, y − x/2, v): the wall is a bound of a state.
struct BeadBesideWall : Sizes<3, 1> {
  double g;
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& v = at.states[2];
    const S c = cos(at.controls[0]), s = sin(at.controls[0]);
    return {S(1.0), {v * c, v * (s - c * 0.5), s * g}};
  }
};

std::vector<ocp::Variable> at_rest() {
  return {{.name = "s", .start = 0.0, .end = 1.0},
          {.name = "v", .start = 0.0, .end = 0.0}};
}

constexpr double kFeet = 32.174;  // ft/s²
constexpr double kUpright = 0.5 * std::numbers::pi;

ocp::Variable slope(double least) {
  return {.name = "slope",
          .unit = "rad",
          .lower = least,
          .upper = kUpright,
          .guess = [](double t) { return 1.4 * (1.0 - t); }};
}

ocp::Variable speed(double last) {
  return {.name = "v",
          .unit = "ft/s",
          .lower = 0.0,
          .start = 0.0,
          .guess = [last](double t) { return last * std::sqrt(t); }};
}

}  // namespace

std::vector<Classic> mechanics() {
  std::vector<Classic> out;

  out.push_back(classic(
      "min ∫ u²/2 dt, x' = v, v' = u, x ≤ 1/9, (x, v) from (0, 1) to (0, −1), "
      "T = 1",
      Cart{{}, true},
      {.name = "Bryson–Denham",
       .states = {{.name = "x", .upper = 1.0 / 9.0, .start = 0.0, .end = 0.0},
                  {.name = "v", .start = 1.0, .end = -1.0}},
       .controls = {{.name = "u"}},
       .duration = ocp::Duration::fixed(1.0)}));
  out.back().second = {"4/(9 l)", 4.0};

  out.push_back(classic(
      "min T, s' = v, v' = u, −1 ≤ u ≤ 2, from rest at 0 to rest at 1", Cart{},
      {.name = "double integrator: time",
       .states = at_rest(),
       .controls = {{.name = "u", .lower = -1.0, .upper = 2.0}}}));
  out.back().second = {"√3", std::numbers::sqrt3};

  out.push_back(
      classic("min ∫ u²/2 dt, s' = v, v' = u, from rest at 0 to rest at 1, "
              "T = 1",
              Cart{{}, true},
              {.name = "double integrator: effort",
               .states = at_rest(),
               .controls = {{.name = "u"}},
               .duration = ocp::Duration::fixed(1.0)}));
  out.back().second = {"6", 6.0};

  out.push_back(
      classic("min ∫ (a + b) dt, s' = v, v' = a − b, 0 ≤ a, b ≤ 1, from rest "
              "at 0 to rest at 1, T = 3",
              Fuel{},
              {.name = "double integrator: fuel",
               .states = at_rest(),
               .controls = {{.name = "push", .lower = 0.0, .upper = 1.0},
                            {.name = "brake", .lower = 0.0, .upper = 1.0}},
               .duration = ocp::Duration::fixed(3.0)}));
  out.back().second = {"3 − √5", 3.0 - std::sqrt(5.0)};

  out.push_back(
      classic("min ∫ x √(1 + u²) dt, x' = u, l' = √(1 + u²), x from 1 to 3, l "
              "from 0 to 4, T = 1",
              Chain{},
              {.name = "hanging chain",
               .states = {{.name = "x", .start = 1.0, .end = 3.0},
                          {.name = "l", .start = 0.0, .end = 4.0}},
               .controls = {{.name = "u",
                             .guess = [](double t) { return 8.0 * t - 3.0; }}},
               .duration = ocp::Duration::fixed(1.0)}));
  out.back().second = {"catenary", hanging_chain()};
  out.back().literature = {"COPS, 800 intervals", 5.06891};

  out.push_back(classic(
      "min T, x' = v cos u, z' = v sin u, v' = sin u / 2, from rest at (0, 0) "
      "to (3, 1)",
      Bead{{}, 0.5},
      {.name = "bead to a point",
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
       .duration = {.guess = 4.0}}));
  out.back().second = {"cycloid", cycloid_time(3.0)};

  const ocp::Variable x{
      .name = "x", .unit = "ft", .lower = 0.0, .start = 0.0, .end = 1.0};
  const ocp::Variable y{.name = "y",
                        .unit = "ft",
                        .lower = 0.0,
                        .start = 0.0,
                        .guess = [](double t) { return 0.6 * t; }};
  out.push_back(classic(
      "min T, x' = v cos u, y' = v sin u, v' = g sin u, g = 32.174 ft/s², from "
      "rest at (0, 0) to x = 1 ft, |u| ≤ π/2",
      Bead{{}, kFeet},
      {.name = "bead to a line",
       .states = {x, y, speed(6.0)},
       .controls = {slope(-kUpright)},
       .duration = {.guess = 0.3},
       .time_unit = "s"}));
  out.back().second = {"√(π/g)", time_to_line(kFeet)};
  out.back().literature = {"YAPSS, test of its example", 0.312480130708665};

  out.push_back(classic("the same with y − x/2 ≤ 0.1 ft, a limit of the path",
                        BeadOverWall{{{}, kFeet}},
                        {.name = "bead over a wall: limit",
                         .states = {x, y, speed(6.0)},
                         .controls = {slope(-kUpright)},
                         .limits = {{.name = "wall", .upper = 0.1}},
                         .duration = {.guess = 0.3},
                         .time_unit = "s"}));
  out.back().second = {"two cycloids and a slide", time_along_wall(kFeet)};
  out.back().literature = {"YAPSS, test of its example", 0.323331164025862};

  out.push_back(classic(
      "the same with w = y − x/2 for a state, w ≤ 0.1 ft a bound",
      BeadBesideWall{{}, kFeet},
      {.name = "bead over a wall: bound",
       .states = {x,
                  {.name = "w", .unit = "ft", .upper = 0.1, .start = 0.0},
                  speed(6.0)},
       .controls = {slope(-kUpright)},
       .duration = {.guess = 0.3},
       .time_unit = "s"}));
  out.back().second = {"two cycloids and a slide", time_along_wall(kFeet)};
  out.back().literature = {"YAPSS, test of its example", 0.323331164025862};
  return out;
}

}  // namespace brachisto::benchmarks
