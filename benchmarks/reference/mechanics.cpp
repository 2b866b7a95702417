// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <numbers>

#include "reference/classic.hpp"
#include "reference/enclosures.hpp"
#include "support/classics.hpp"
#include "support/closed_forms.hpp"

namespace brachisto::benchmarks {

namespace {

using ocp::Statement;

/// A bead with a wall as a limit of the path.
struct BeadOverWall : testing::Bead {
  template <class S>
  [[nodiscard]] std::array<S, 1> limits(const Point<S>& at) const {
    return {at.states[1] - at.states[0] * 0.5};
  }
};

Statement named(Statement statement, const char* name) {
  statement.name = name;
  return statement;
}

constexpr double kThousandFeet = 32174.0;
constexpr double kFeet = kThousandFeet / 1000.0;  // ft/s²

/// In feet and seconds.
Statement in_feet(Statement statement, const char* name) {
  for (std::size_t i : {0, 1}) statement.states[i].unit = "ft";
  statement.states[2].unit = "ft/s";
  statement.controls[0].unit = "rad";
  statement.time_unit = "s";
  return named(std::move(statement), name);
}

/// Without a wall, or with one that is no state.
Statement bead_to_line(const char* name) {
  Statement out = in_feet(testing::bead_beside_wall(6.0, 0.3), name);
  out.states[1] = {.name = "y",
                   .unit = "ft",
                   .lower = 0.0,
                   .start = 0.0,
                   .guess = [](double t) { return 0.6 * t; }};
  return out;
}

}  // namespace

std::vector<Classic> mechanics() {
  using namespace testing;
  std::vector<Classic> out;
  const auto closed_form = [&](const char* by, double value,
                               std::optional<Enclosure> enclosure) {
    out.back().second = {by, value};
    out.back().closed_form = true;
    out.back().enclosure = enclosure;
  };

  out.push_back(classic(
      "min ∫ u²/2 dt, x' = v, v' = u, x ≤ 1/9, (x, v) from (0, 1) to (0, −1), "
      "T = 1",
      Cart{{}, true}, named(out_and_back(1.0 / 9.0), "Bryson–Denham")));
  closed_form("4/(9 l)", 4.0, Enclosure{4.0, 4.0});

  out.push_back(
      classic("min T, s' = v, v' = u, −1 ≤ u ≤ 2, from rest at 0 to rest at 1",
              Cart{}, named(cart(1.0, 2.0), "double integrator: time")));
  closed_form("√3", std::numbers::sqrt3, enclosed_root_of_3());

  Statement effort =
      named(cart(ocp::kNoBound, ocp::kNoBound), "double integrator: effort");
  effort.duration = ocp::Duration::fixed(1.0);
  out.push_back(classic(
      "min ∫ u²/2 dt, s' = v, v' = u, from rest at 0 to rest at 1, T = 1",
      Cart{{}, true}, effort));
  closed_form("6", 6.0, Enclosure{6.0, 6.0});

  out.push_back(
      classic("min ∫ (a + b) dt, s' = v, v' = a − b, 0 ≤ a, b ≤ 1, from rest "
              "at 0 to rest at 1, T = 3",
              Fuel{}, named(least_fuel(), "double integrator: fuel")));
  closed_form("3 − √5", 3.0 - std::sqrt(5.0), enclosed_least_fuel());

  out.push_back(
      classic("min ∫ x √(1 + u²) dt, x' = u, l' = √(1 + u²), x from 1 to 3, l "
              "from 0 to 4, T = 1",
              Chain{}, named(chain(), "hanging chain")));
  closed_form("catenary", hanging_chain(), enclosed_hanging_chain());
  out.back().literature = {"COPS, 800 intervals", 5.06891};

  out.push_back(classic(
      "min T, x' = v cos u, z' = v sin u, v' = sin u / 2, from rest at (0, 0) "
      "to (3, 1)",
      Bead{{}, 0.5}, named(bead_to_point(), "bead to a point")));
  closed_form("cycloid", cycloid_time_to(3.0), enclosed_cycloid_time(3.0));

  out.push_back(classic(
      "min T, x' = v cos u, y' = v sin u, v' = g sin u, g = 32.174 ft/s², from "
      "rest at (0, 0) to x = 1 ft, |u| ≤ π/2",
      Bead{{}, kFeet}, bead_to_line("bead to a line")));
  closed_form("√(π/g)", static_cast<double>(time_to_line<long double>(kFeet)),
              enclosed_time_to_line(kThousandFeet));
  out.back().literature = {"YAPSS, test of its example", 0.312480130708665};

  const auto along_wall = [&] {
    closed_form("two cycloids and a slide",
                static_cast<double>(time_along_wall<long double>(kFeet)),
                enclosed_time_along_wall(kThousandFeet));
    out.back().literature = {"YAPSS, test of its example", 0.323331164025862};
  };
  Statement limited = bead_to_line("bead over a wall: limit");
  limited.limits = {{.name = "wall", .upper = 0.1}};
  out.push_back(classic("the same with y − x/2 ≤ 0.1 ft, a limit of the path",
                        BeadOverWall{{{}, kFeet}}, limited));
  along_wall();

  out.push_back(
      classic("the same with w = y − x/2 for a state, w ≤ 0.1 ft a bound",
              BeadBesideWall{{}, kFeet},
              in_feet(bead_beside_wall(6.0, 0.3), "bead over a wall: bound")));
  along_wall();
  return out;
}

}  // namespace brachisto::benchmarks
