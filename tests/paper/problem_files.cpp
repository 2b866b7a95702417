// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Every problem file of the paper's figures gives the number it promises.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "paper/names.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;

/// "here: tau = 5.093444466618" or "here: T = 1.228459939435 s".
struct Promise {
  bool is_time = false;  // T in seconds, not τ
  double value = 0.0;
  double half_digit = 0.0;  // of the last one printed
};

Promise promise_of(const fs::path& file) {
  static const std::regex kPattern(R"(here: (tau|T) = ([0-9]+\.([0-9]+)))");
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.starts_with('#')) {
    std::smatch match;
    if (!std::regex_search(line, match, kPattern)) continue;
    return {match[1] == "T", std::stod(match[2]),
            0.5 * std::pow(10.0, -static_cast<double>(match[3].length()))};
  }
  throw std::runtime_error(file.string() + " promises no number");
}

class PaperProblem : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(
    Files, PaperProblem,
    ::testing::ValuesIn(testing::problem_files(BRACHISTO_PAPER_DIR)),
    testing::file_name);

TEST(PaperProblems, CoverTheFiguresOfThePaper) {
  const std::vector<std::string> names =
      testing::problem_files(BRACHISTO_PAPER_DIR);
  for (const std::string figure : {"fig03", "fig04", "fig06", "fig08", "fig09",
                                   "fig10", "fig11", "fig12", "fig13"}) {
    EXPECT_TRUE(std::ranges::any_of(names, [&](const std::string& name) {
      return name.starts_with(figure);
    })) << figure;
  }
}

TEST_P(PaperProblem, GivesTheNumberInItsFirstComment) {
  const fs::path file = fs::path(BRACHISTO_PAPER_DIR) / (GetParam() + ".yaml");
  const Promise promise = promise_of(file);
  const io::ProblemFile problem = io::read_problem_file(file);

  const Solution solution = solve(problem.scene, problem.options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const double value = promise.is_time ? solution.motion()->transit_time()
                                       : solution.motion()->tau();
  // To the digits printed, as far as the result itself claims to know them.
  EXPECT_NEAR(value, promise.value,
              promise.half_digit + *solution.estimated_error * value);
}

}  // namespace
}  // namespace brachisto
