// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Stated problems against their closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "brachisto/ocp.hpp"
#include "support/classics.hpp"
#include "support/closed_forms.hpp"

namespace brachisto::ocp {
namespace {

using namespace testing;

/// Solved and verified, and the cost as near to the closed form as is said.
template <class Formulas>
Answer expect_cost(const Problem<Formulas>& problem, double exact,
                   const SolveBy& by = {}) {
  const Answer answer = problem.solve(by);
  EXPECT_TRUE(answer.verified()) << answer.message << "; " << answer.why_not();
  // What is estimated, and what is wanted of Newton's method.
  const double rounding = 1e-13 * (1.0 + std::abs(exact));
  EXPECT_NEAR(answer.cost, exact, answer.estimated_error + rounding);
  EXPECT_LE(answer.estimated_error, by.tolerance * std::max(1.0, exact) * 10.0);
  return answer;
}

/// Pushed by 2 and braked by 1: v² (1/4 + 1/2) = 1 at the switch, which is
/// passed after v/2; T = 3 v/2.
TEST(Posed, TheLeastTimeOfACartFindsItsSwitch) {
  const Problem problem(Cart{}, cart(1.0, 2.0));

  const Answer answer = expect_cost(problem, std::sqrt(3.0));

  ASSERT_EQ(answer.junctions.size(), 1U);
  EXPECT_NEAR(answer.junctions[0], 1.0 / std::sqrt(3.0), 1e-12);
}

struct CartInWind : Sizes<2, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    return {S(1.0), {at.states[1], at.controls[0] + at.controls[1]}};
  }
};

/// A wind of 1/2 that is given: pushed by 2 and braked by 1 in all.
TEST(Posed, AFixedControlStandsBesideOneThatJumps) {
  Statement statement = cart(1.5, 1.5);
  statement.controls.push_back({.name = "wind", .lower = 0.5, .upper = 0.5});
  const Problem problem(CartInWind{}, statement);

  const Answer answer = expect_cost(problem, std::sqrt(3.0));

  ASSERT_EQ(answer.junctions.size(), 1U);
  EXPECT_NEAR(answer.junctions[0], 1.0 / std::sqrt(3.0), 1e-12);
}

TEST(Posed, EstimatesOfABangBangControlAreHonest) {
  const Problem problem(Cart{}, cart(1.0, 2.0));
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    expect_cost(problem, std::sqrt(3.0), {.tolerance = tolerance});
  }
}

/// u = 6 − 12 t, and with the end 1 the cost is 6·1²: it changes by 12.
TEST(Posed, TheLeastEffortOfACartIsSix) {
  Statement statement = cart(kNoBound, kNoBound);
  statement.duration = Duration::fixed(1.0);
  const Problem problem(Cart{{}, true}, statement);

  const Answer answer = expect_cost(problem, 6.0);

  EXPECT_NEAR(answer.by_end[0], 12.0, 1e-9);
  EXPECT_NEAR(answer.at(0.25).controls[0], 3.0, 1e-9);
  EXPECT_NEAR(answer.at(0.25).costates[0], -12.0, 1e-9);
}

/// In the time 3: v (3 − v) = 1, pushed and braked for v each.
TEST(Posed, TheLeastFuelOfACartCoasts) {
  const Problem problem(Fuel{}, least_fuel());

  expect_cost(problem, 3.0 - std::sqrt(5.0));
}

TEST(Posed, BrysonAndDenhamKeepOff) {
  const Problem problem(Cart{{}, true}, out_and_back(1.0 / 9.0));

  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Answer answer = expect_cost(problem, 4.0, {.tolerance = tolerance});

    ASSERT_EQ(answer.prices.size(), 1U);
    // d(4/9l)/dl = −36; multipliers err by the root of what the cost does.
    EXPECT_NEAR(answer.prices[0].by_upper, -36.0, 360.0 * std::sqrt(tolerance));
  }
}

TEST(Posed, EstimatesAreHonestWhereverBrysonAndDenhamHaveTheirWall) {
  for (const double wall : {0.05, 1.0 / 12.0, 0.1, 0.125, 0.15}) {
    const Problem problem(Cart{{}, true}, out_and_back(wall));
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      expect_cost(problem, 4.0 / (9.0 * wall), {.tolerance = tolerance});
    }
  }
}

/// On these meshes an arc's begin was taken to be where it is not, and drifted
/// along the wall between the points: the cost erred by up to 1e-6.
TEST(Posed, AJunctionThatIsNotSettledIsHonestOrNamed) {
  struct Case {
    double wall;
    int degree, elements;
  };
  for (const auto [wall, degree, elements] :
       {Case{0.04, 5, 10}, Case{0.07, 5, 10}, Case{0.12, 5, 10},
        Case{0.05, 5, 7}, Case{0.09, 5, 7}, Case{0.1, 5, 7}, Case{0.04, 4, 16},
        Case{0.06, 4, 16}, Case{0.12, 7, 6}}) {
    const Problem problem(Cart{{}, true}, out_and_back(wall));
    const double exact = 4.0 / (9.0 * wall);
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const Answer answer = problem.solve(
          {.tolerance = tolerance, .degree = degree, .elements = elements});

      EXPECT_NEAR(answer.cost, exact,
                  answer.estimated_error + 1e-13 * (1.0 + exact))
          << wall << ", " << degree << ", " << tolerance;
      if (answer.verified()) continue;
      EXPECT_NE(answer.why_not().find("not settled"), std::string::npos)
          << answer.why_not();
      EXPECT_NE(answer.why_not().find("try another degree"), std::string::npos);
    }
  }
}

/// x' = v, v' = u − x to rest at 0 from rest at x₀ ≤ 2: an arc about −1 and one
/// about 1 in the plane of x and v, that meet at X = ((x₀ + 1)² − 1)/4.
struct Oscillator : Sizes<2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [x, v] = at.states;
    return {S(1.0), {v, at.controls[0] - x}};
  }
};

TEST(Posed, AnOscillatorIsStoppedByOneSwitch) {
  for (const double start : {0.35, 0.8, 1.3, 1.9}) {
    const Problem problem(
        Oscillator{}, {.name = "oscillator",
                       .states = {{.name = "x", .start = start, .end = 0.0},
                                  {.name = "v", .start = 0.0, .end = 0.0}},
                       .controls = {{.name = "u", .lower = -1.0, .upper = 1.0}},
                       .duration = {.guess = 2.0}});
    const double meets = 0.25 * ((start + 1.0) * (start + 1.0) - 1.0);
    const double first = std::acos((meets + 1.0) / (start + 1.0));
    for (const auto& [tolerance, degree] :
         {std::pair(1e-4, 5), std::pair(1e-8, 7), std::pair(1e-10, 4)}) {
      const Answer answer =
          expect_cost(problem, first + std::acos(1.0 - meets),
                      {.tolerance = tolerance, .degree = degree});

      ASSERT_EQ(answer.junctions.size(), 1U) << start;
      EXPECT_NEAR(answer.junctions[0], first, 10.0 * std::sqrt(tolerance));
    }
  }
}

/// ∫ x² with x' = u, −1 ≤ u ≤ 1, from x = 1: to 0 in the time 1, and along it
/// by u = 0, a singular arc; 1/3.
struct ToZero : Sizes<1, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    return {at.states[0] * at.states[0], {at.controls[0]}};
  }
};

TEST(Posed, ASingularArcBeginsWhereItDoes) {
  const Problem problem(
      ToZero{}, {.name = "to zero",
                 .states = {{.name = "x", .start = 1.0}},
                 .controls = {{.name = "u", .lower = -1.0, .upper = 1.0}},
                 .duration = Duration::fixed(2.3)});
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Answer answer =
        expect_cost(problem, 1.0 / 3.0, {.tolerance = tolerance});

    ASSERT_FALSE(answer.junctions.empty());
    EXPECT_NEAR(answer.junctions[0], 1.0, std::cbrt(tolerance));
  }
}

/// Held from 3 l to 1 − 3 l, where the control is continuous.
TEST(Posed, BrysonAndDenhamKnowWhereTheyTouch) {
  const Answer answer =
      expect_cost(Problem(Cart{{}, true}, out_and_back(1.0 / 9.0)), 4.0);

  ASSERT_EQ(answer.junctions.size(), 2U);
  // To the root of the rounding of 4, or of 4 (1 + δ²).
  EXPECT_NEAR(answer.junctions[0], 1.0 / 3.0, 1e-8);
  EXPECT_NEAR(answer.junctions[1], 2.0 / 3.0, 1e-8);
}

TEST(Posed, TheFastestBeadRunsOnACycloid) {
  const Problem problem(Bead{{}, 0.5}, bead_to_point());

  expect_cost(problem, cycloid_time_to(3.0));
}

TEST(Posed, ABeadSlidesAlongAWall) {
  const Problem problem(BeadBesideWall{{}, 1.0}, bead_beside_wall(1.0, 2.0));

  for (const double tolerance : {1e-6, 1e-10}) {
    expect_cost(problem, static_cast<double>(time_along_wall<long double>(1.0)),
                {.tolerance = tolerance});
  }
}

TEST(Posed, AHangingChainIsACatenary) {
  expect_cost(Problem(Chain{}, chain()), hanging_chain());
}

struct Drift : Sizes<1, 1, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& u = at.controls[0];
    return {u * u * 0.5, {at.parameters[0] + u}};
  }
  template <class S>
  [[nodiscard]] S end_cost(const Ends<S>& ends) const {
    return ends.parameters[0] * ends.parameters[0] * 0.5;
  }
};

/// Half of the way each.
TEST(Posed, AParameterSharesWhatItCosts) {
  const Problem problem(Drift{},
                        {.name = "drift",
                         .states = {{.name = "x", .start = 0.0, .end = 1.0}},
                         .controls = {{.name = "u"}},
                         .parameters = {{.name = "drift"}},
                         .duration = Duration::fixed(1.0)});

  const Answer answer = expect_cost(problem, 0.25);

  EXPECT_NEAR(answer.parameters[0], 0.5, 1e-9);
}

/// To a circle of radius 1 about (2, 0).
struct ToACircle : Sizes<2, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [u, v] = at.controls;
    return {(u * u + v * v) * 0.5, {u, v}};
  }
  template <class S>
  [[nodiscard]] std::array<S, 1> limits(const Point<S>& at) const {
    return {at.controls[0]};
  }
  template <class S>
  [[nodiscard]] std::array<S, 1> end_conditions(const Ends<S>& ends) const {
    const S x = ends.end[0] - 2.0, y = ends.end[1];
    return {x * x + y * y};
  }
};

/// At the distance 1, straight and evenly: 1/2.
TEST(Posed, AConditionOfTheEndIsKept) {
  Statement statement{
      .name = "to a circle",
      .states = {{.name = "x", .start = 0.0}, {.name = "y", .start = 0.0}},
      .controls = {{.name = "u"}, {.name = "v"}},
      .limits = {{.name = "speed", .upper = 2.0}},
      .end_conditions = {{"circle", 1.0, 1.0}},
      .duration = Duration::fixed(1.0)};
  const Problem problem(ToACircle{}, statement);

  expect_cost(problem, 0.5);
}

}  // namespace
}  // namespace brachisto::ocp
