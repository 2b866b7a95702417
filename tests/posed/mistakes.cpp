// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What is said of mistakes in stated problems.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/ocp.hpp"

namespace brachisto::ocp {
namespace {

/// x' = u, and a cost.
template <class Cost>
struct Line : Sizes<1, 1> {
  Cost cost;
  explicit Line(Cost of) : cost(of) {}
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    return {cost(at.states[0], at.controls[0]), {at.controls[0]}};
  }
};

const auto kSquare = [](const auto& /*x*/, const auto& u) { return u * u; };

Statement line() {
  return {.name = "line",
          .states = {{.name = "x", .start = 0.0, .end = 1.0}},
          .controls = {{.name = "u"}},
          .duration = Duration::fixed(1.0)};
}

template <class Cost>
std::string refusal(Cost cost, const Statement& statement) {
  try {
    (void)Problem(Line(cost), statement);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// That a text has all of these.
void expect_says(const std::string& text,
                 std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\n" << part;
  }
}

TEST(PosedMistakes, AWrongNumberOfStatesIsCounted) {
  Statement statement = line();
  statement.states.push_back({.name = "y"});

  expect_says(refusal(kSquare, statement),
              {"line", "1 states", "2 are stated"});
}

TEST(PosedMistakes, ANumberThatIsNoneNamesItsState) {
  Statement statement = line();
  statement.states[0].end = std::nan("");

  expect_says(refusal(kSquare, statement), {"the end of x is not finite"});
}

TEST(PosedMistakes, AnEndOutsideOfItsBoundsIsNamed) {
  Statement statement = line();
  statement.states[0].upper = 0.5;

  expect_says(refusal(kSquare, statement),
              {"the end of x, 1, is not between its bounds"});
}

TEST(PosedMistakes, WhatHasNoNameIsCounted) {
  Statement statement = line();
  statement.controls[0].name = "";

  expect_says(refusal(kSquare, statement), {"control 1 has no name"});
}

TEST(PosedMistakes, AGuessByOneValueNamesItsVariable) {
  Statement statement = line();
  statement.controls[0].guess = std::vector{1.0};

  expect_says(refusal(kSquare, statement),
              {"the guess of u has fewer than two values"});
}

TEST(PosedMistakes, CrossedBoundsAreNamed) {
  Statement statement = line();
  statement.controls[0].lower = 2.0;
  statement.controls[0].upper = 1.0;

  expect_says(refusal(kSquare, statement), {"the bounds of u, 2 and 1"});
}

TEST(PosedMistakes, ANameThatBreaksTablesAndPicturesIsRefused) {
  Statement statement = line();
  statement.controls[0].name = "a < b";
  expect_says(refusal(kSquare, statement), {"the name a < b holds"});
  statement = line();
  statement.states[0].unit = "kg, m";
  expect_says(refusal(kSquare, statement), {"the unit of x holds"});
}

TEST(PosedMistakes, AGuessThatIsNotFiniteNamesItsPlace) {
  Statement statement = line();
  statement.states[0].guess = [](double t) { return std::log(0.5 - t); };

  expect_says(refusal(kSquare, statement),
              {"the guess of x is not finite after 50 %"});
}

TEST(PosedMistakes, AFormulaThatIsNotFiniteAtTheGuessNamesRateAndPlace) {
  const auto cost = [](const auto& x, const auto& u) {
    return u * u + log(x - 0.5);
  };
  const Answer answer = Problem(Line(cost), line()).solve();

  EXPECT_EQ(answer.status, Status::NotEvaluable);
  expect_says(answer.message, {"the cost's rate is not finite", "x = 0."});
}

TEST(PosedMistakes, WhatCannotBeReachedNamesTheEquation) {
  Statement statement = line();
  statement.controls[0].lower = 0.0;
  statement.controls[0].upper = 0.5;
  const Answer answer = Problem(Line(kSquare), statement).solve();

  EXPECT_NE(answer.status, Status::Solved);
  expect_says(answer.message,
              {"no path was found", "the equation of x", "missed by"});
}

TEST(PosedMistakes, ACostWithoutABoundNamesWhatGrows) {
  const auto cost = [](const auto& x, const auto& u) { return x - u * u; };
  Statement statement = line();
  statement.states[0].end = {};
  const Answer answer = Problem(Line(cost), statement).solve();

  EXPECT_NE(answer.status, Status::Solved);
  expect_says(answer.message, {"falls without bound", "has grown to"});
}

/// The sign of x − 1/3 as a cost.
TEST(PosedMistakes, AJumpOfAFormulaNamesItsPlace) {
  const auto cost = [](const auto& x, const auto& u) {
    const auto from = (x - 1.0 / 3.0) * 1e9;
    return u * u + from / sqrt(from * from + 1.0);
  };
  const Answer answer = Problem(Line(cost), line())
                            .solve({.most_elements = 200, .most_passes = 8});

  EXPECT_FALSE(answer.verified());
  expect_says(
      answer.message,
      {"line", "the cost's rate jumps at t = ", "x = 0.33333", "smooth"});
}

/// x' = u, and what depends on the sign of x − 3/10.
TEST(PosedMistakes, AFormulaWithoutADerivativeNamesItsPlace) {
  const auto cost = [](const auto& x, const auto& u) {
    const auto from = x - 0.3;
    return u * u + from / sqrt(from * from);
  };
  const Answer answer = Problem(Line(cost), line()).solve();

  EXPECT_FALSE(answer.verified());
  expect_says(answer.why_not(), {"the cost's rate", "x = 0.3", "smooth"});
}

TEST(PosedMistakes, AFormulaThatIsNotFiniteAtTheStartIsNamed) {
  const auto cost = [](const auto& x, const auto& u) { return u * u + log(x); };
  const Answer answer = Problem(Line(cost), line()).solve();

  EXPECT_FALSE(answer.verified());
  expect_says(answer.why_not(), {"the cost's rate", "not finite", "x = 0"});
}

/// ∫ u² of the way 1 is 1/T.
TEST(PosedMistakes, ADurationWithoutABoundIsNamed) {
  Statement statement = line();
  statement.duration = {};
  const Answer answer = Problem(Line(kSquare), statement).solve();

  EXPECT_FALSE(answer.verified());
  expect_says(answer.why_not(), {"the duration has grown to", "bound it"});
}

TEST(PosedMistakes, BoundsThatStopThePathAreNamed) {
  Statement statement = line();
  statement.controls[0].lower = 0.0;
  statement.controls[0].upper = 0.5;
  const Answer answer = Problem(Line(kSquare), statement).solve();

  expect_says(answer.message, {"stopped by u ≤ 0.5"});
}

struct Two : Sizes<2, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [u, w] = at.controls;
    return {u * u, {u, w}};
  }
};

TEST(PosedMistakes, ASizeThatNothingTellsIsAskedFor) {
  Statement statement = line();
  statement.states[0].end = 1e6;
  statement.controls.push_back({.name = "w", .lower = 0.0, .upper = 1.0});
  statement.states.push_back({.name = "y", .start = 0.0, .end = 2.0});
  const Answer answer = Problem(Two{}, statement).solve();

  EXPECT_FALSE(answer.verified());
  expect_says(answer.message, {"y is missed", "size of u: give"});
}

template <class Formulas>
std::string refusal_of_solve(Formulas formulas, const Statement& statement,
                             const SolveBy& by = {}) {
  const Problem problem(formulas, statement);
  try {
    (void)problem.solve(by);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

struct Idle : Sizes<1, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    return {at.controls[0] * at.controls[0], {at.controls[0]}};
  }
};

TEST(PosedMistakes, AControlOnWhichNothingDependsIsNamed) {
  Statement statement = line();
  statement.controls.push_back({.name = "w"});

  expect_says(refusal_of_solve(Idle{}, statement),
              {"nothing depends on w", "leave it out"});
}

/// A body that is pushed along a direction, which is an angle.
struct Steered : Sizes<3, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const S& v = at.states[2];
    const auto& [angle, push] = at.controls;
    return {S(1.0), {v * cos(angle), v * sin(angle), push}};
  }
};

/// At rest along the guess, where no angle matters: by a straight line of the
/// length √2 in T = √(2 √2).
TEST(PosedMistakes, AControlThatMattersOffTheGuessAloneIsNone) {
  const Statement statement{
      .name = "steered",
      .states = {{.name = "x", .start = 0.0, .end = 1.0},
                 {.name = "y", .start = 0.0, .end = 1.0},
                 {.name = "v", .start = 0.0}},
      .controls = {{.name = "angle", .lower = -1.5, .upper = 1.5},
                   {.name = "push", .lower = -1.0, .upper = 1.0}}};
  const Answer answer = Problem(Steered{}, statement).solve();

  EXPECT_TRUE(answer.verified()) << answer.message << "; " << answer.why_not();
  EXPECT_NEAR(answer.cost, std::sqrt(2.0 * std::sqrt(2.0)), 1e-9);
}

struct Limited : Sizes<1, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    return {at.controls[0] * at.controls[0], {at.controls[0]}};
  }
  template <class S>
  [[nodiscard]] std::array<S, 2> limits(const Point<S>& at) const {
    return {at.states[0] + at.controls[0], at.states[0] * 2.0};
  }
};

TEST(PosedMistakes, ALimitThatTheStartBreaksIsNamed) {
  Statement statement = line();
  statement.limits = {{.name = "pace", .lower = 0.5},
                      {.name = "height", .lower = 0.5}};

  expect_says(refusal_of_solve(Limited{}, statement),
              {"height is 0", "given at the start", "0.5"});
}

TEST(PosedMistakes, OptionsOutOfRangeAreNamed) {
  const Line formulas(kSquare);
  expect_says(refusal_of_solve(formulas, line(), {.tolerance = -1.0}),
              {"the tolerance, -1, is not positive"});
  expect_says(refusal_of_solve(formulas, line(), {.degree = 40}),
              {"the degree, 40, is not between 2 and 11"});
  expect_says(refusal_of_solve(formulas, line(), {.elements = 0}),
              {"elements, 0, is less than 1"});
}

TEST(PosedMistakes, NothingHasToBeGuessed) {
  const Answer answer = Problem(Line(kSquare), line()).solve();

  EXPECT_TRUE(answer.verified()) << answer.why_not();
  EXPECT_NEAR(answer.cost, 1.0, 1e-10);
}

}  // namespace
}  // namespace brachisto::ocp
