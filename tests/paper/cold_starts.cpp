// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The answer does not depend on where the first iteration starts.

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;

// What cold starts cannot change: both runs end in the same refinement.
constexpr double kRounding = 1e-12;
// On the coarse mesh τ is right to some five digits; branches differ by more.
constexpr double kCoarse = 1e-4;

void expect_same_answer(const Solution& solution, const Solution& expected,
                        const char* name) {
  ASSERT_TRUE(solution.verified()) << name << ": " << solution.message;
  EXPECT_NEAR(solution.motion()->tau() / expected.motion()->tau(), 1.0,
              kRounding)
      << name;
  ASSERT_TRUE(solution.cold_start) << name;
  const ColdStart& cold = *solution.cold_start;
  EXPECT_EQ(cold.tau.has_value(), cold.status == Status::Solved) << name;
  if (cold.principal) {
    ASSERT_TRUE(cold.tau) << name;
    EXPECT_NEAR(*cold.tau / expected.motion()->tau(), 1.0, kCoarse) << name;
  }
}

TEST(AColdStart, FromTheStraightLineGivesTheSameAnswer) {
  for (const auto* row : {&reference("reference_case"), &reference("fast"),
                          &reference("theta_-30"), &reference("r_0.2"),
                          &reference("uniform_L3"), &reference("bead_L3")}) {
    const Solution expected = solve(row->scene());
    ASSERT_TRUE(expected.verified()) << row->name;
    EXPECT_FALSE(expected.cold_start) << row->name;
    SolveOptions options;
    options.use<Collocation>().guess = Guess::Straight;

    expect_same_answer(solve(row->scene(), options), expected, row->name);
  }
}

TEST(AColdStart, FromRandomSlopesGivesTheSameAnswer) {
  int principal = 0;
  for (const auto* row : {&reference("reference_case"),
                          &reference("uniform_L3"), &reference("theta_-30")}) {
    const Solution expected = solve(row->scene());
    ASSERT_TRUE(expected.verified()) << row->name;
    for (const std::uint64_t seed : {1U, 2U, 3U, 17U, 4711U}) {
      SolveOptions options;
      auto& program = options.use<Collocation>();
      program.guess = Guess::Random;
      program.seed = seed;

      const Solution solution = solve(row->scene(), options);

      expect_same_answer(solution, expected, row->name);
      if (solution.cold_start && solution.cold_start->principal) ++principal;
    }
  }
  // Most of them do find the principal branch by themselves.
  EXPECT_GE(principal, 8);
}

TEST(AColdStart, IsRepeatable) {
  SolveOptions options;
  auto& program = options.use<Collocation>();
  program.guess = Guess::Random;
  program.seed = 5;
  const Scene scene = reference("reference_case").scene();

  const Solution first = solve(scene, options);
  const Solution second = solve(scene, options);

  ASSERT_TRUE(first.cold_start && second.cold_start);
  EXPECT_EQ(first.cold_start->tau, second.cold_start->tau);
  EXPECT_EQ(first.effort.iterations, second.effort.iterations);
  EXPECT_EQ(first.motion()->tau(), second.motion()->tau());
}

}  // namespace
}  // namespace brachisto
