// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Every hard problem, and every one with limits, ends the way its comments say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "paper/names.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;

/// The rest of the line that starts with the mark; "" if there is none.
std::string comment_of(const fs::path& file, const std::string& mark) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    if (line.starts_with(mark)) return line.substr(mark.size());
  }
  return "";
}

/// "verified", "tau = 4.397012851", or "refused: " and words of the message.
std::string promise_of(const fs::path& file) {
  return comment_of(file, "# Pass: ");
}

class HardProblem : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Files, HardProblem,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_HARD_DIR)),
    testing::file_name);

class LimitedProblem : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Files, LimitedProblem,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_LIMITS_DIR)),
    testing::file_name);

void expect_refused(const fs::path& file, const std::string& because) {
  std::string message;
  try {
    const io::ProblemFile problem = io::read_problem_file(file);
    const Solution solution = solve(problem.scene, problem.options);
    EXPECT_EQ(solution.status, Status::NotReached);
    EXPECT_FALSE(trajectory_of(solution));
    message = solution.message;
  } catch (const io::InputError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find(because), std::string::npos) << message;
}

void expect_tau(const Solution& solution, const std::string& digits) {
  const double expected = std::stod(digits);
  const std::size_t point = digits.find('.');
  const auto decimals = static_cast<double>(digits.size() - point - 1);
  const double half_digit = 0.5 * std::pow(10.0, -decimals);
  const double tau = solution.motion()->tau();

  EXPECT_NEAR(tau, expected, half_digit + *solution.estimated_error * tau);
}

void expect_promise(const fs::path& file) {
  const std::string promise = promise_of(file);
  const std::string refused = "refused: ";
  if (promise.starts_with(refused)) {
    expect_refused(file, promise.substr(refused.size()));
    return;
  }
  ASSERT_TRUE(promise == "verified" || promise.starts_with("tau = "))
      << '"' << promise << '"';
  const io::ProblemFile problem = io::read_problem_file(file);

  const Solution solution = solve(problem.scene, problem.options);

  std::string failed;
  for (const Check& check : solution.certificate.checks) {
    if (!check.passed) failed += " " + check.name;
  }
  ASSERT_TRUE(solution.verified()) << solution.message << failed;
  if (promise != "verified") expect_tau(solution, promise.substr(6));
  // τ is that of the continuation wherever a cold start went.
  const bool cold = problem.options.of<Collocation>()->guess != Guess::Cycloid;
  EXPECT_EQ(comment_of(file, "# Cold start: "), cold ? "principal" : "");
  if (cold) {
    ASSERT_TRUE(solution.cold_start);
    EXPECT_TRUE(solution.cold_start->principal)
        << describe(solution.cold_start->status);
  }
}

TEST_P(HardProblem, EndsAsItsCommentSays) {
  expect_promise(fs::path(BRACHISTO_HARD_DIR) / (GetParam() + ".yaml"));
}

TEST_P(LimitedProblem, EndsAsItsCommentSays) {
  expect_promise(fs::path(BRACHISTO_LIMITS_DIR) / (GetParam() + ".yaml"));
}

class WorldProblem : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Files, WorldProblem,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_WORLDS_DIR)),
    testing::file_name);

TEST_P(WorldProblem, EndsAsItsCommentSays) {
  expect_promise(fs::path(BRACHISTO_WORLDS_DIR) / (GetParam() + ".yaml"));
}

class LossProblem : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Files, LossProblem,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_LOSSES_DIR)),
    testing::file_name);

TEST_P(LossProblem, EndsAsItsCommentSays) {
  expect_promise(fs::path(BRACHISTO_LOSSES_DIR) / (GetParam() + ".yaml"));
}

class Starter : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Files, Starter,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_RACE_DIR)),
    testing::file_name);

TEST_P(Starter, EndsAsItsCommentSays) {
  expect_promise(fs::path(BRACHISTO_RACE_DIR) / (GetParam() + ".yaml"));
}

class BuiltTrack : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Files, BuiltTrack,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_BUILD_DIR)),
    testing::file_name);

TEST_P(BuiltTrack, EndsAsItsCommentSays) {
  expect_promise(fs::path(BRACHISTO_BUILD_DIR) / (GetParam() + ".yaml"));
}

}  // namespace
}  // namespace brachisto
