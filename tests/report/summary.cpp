// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/summary.hpp"

#include <gtest/gtest.h>

#include <string>

#include "report/solutions.hpp"

namespace brachisto {
namespace {

using report::summary;

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Summary, OfAVerifiedSolutionHasTheAnswer) {
  const std::string text = summary(testing::uniform_solution());

  EXPECT_TRUE(says(text, "5.115100653580")) << text;
  EXPECT_TRUE(says(text, "verified, feasible")) << text;
}

TEST(Summary, OfAnUnverifiedSolutionHasTheFailedCheckAndNoAnswer) {
  const std::string text = summary(testing::unverified_solution());

  EXPECT_TRUE(says(text, "NOT VERIFIED")) << text;
  EXPECT_TRUE(says(text, "agreement")) << text;
  EXPECT_FALSE(says(text, "5.09")) << text;
}

TEST(Summary, OfAnUnsolvedSceneHasTheReason) {
  const std::string text = summary(testing::impossible_solution());

  EXPECT_TRUE(says(text, "NOT SOLVED")) << text;
  EXPECT_TRUE(says(text, "above its start")) << text;
}

TEST(Summary, TellsOfAContinuation) {
  const std::string text = summary(solve(testing::reference("fast").scene()));

  EXPECT_TRUE(says(text, "followed from η_m = 0")) << text;
}

TEST(Summary, TellsWhyABodyCouldNotRun) {
  Solution solution = testing::uniform_solution();
  solution.diagnostics->min_normal_force = {-0.5, 1.25};

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, "INFEASIBLE")) << text;
  EXPECT_TRUE(says(text, "lift off")) << text;
}

}  // namespace
}  // namespace brachisto
