// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What Ipopt returns where everything goes well.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto {
namespace {

using testing::HockSchittkowski7;
using testing::LogarithmicBowl;
using testing::NearestPoint;

// The KKT residual is below Ipopt's 1e-12; the inverse KKT matrices of these
// problems have norms below ten.
constexpr double kTolerance = 1e-11;

PrimalDual cold(std::vector<double> x) {
  return {std::move(x), {}};
}

TEST(Ipopt, FindsTheSolutionAndItsMultiplier) {
  HockSchittkowski7 problem;

  const SolverResult result = solve_with_ipopt(problem, cold({2.0, 2.0}), {});

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  EXPECT_NEAR(result.point.x[0], 0.0, kTolerance);
  EXPECT_NEAR(result.point.x[1], HockSchittkowski7::kSolution, kTolerance);
  EXPECT_NEAR(result.point.lambda[0], HockSchittkowski7::kMultiplier,
              kTolerance);
  EXPECT_GT(result.iterations, 1);
  EXPECT_EQ(result.refused_points, 0);
}

TEST(Ipopt, MultipliersHaveTheSignOfTheLagrangian) {
  // ∂(f + λ g)/∂x_i = 2 x_i + λ = 0 at x_i = 2.
  NearestPoint problem;

  const SolverResult result =
      solve_with_ipopt(problem, cold({0.0, 1.0, -1.0}), {});

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  EXPECT_NEAR(result.point.lambda[0], -4.0, kTolerance);
}

TEST(Ipopt, ReachesTheToleranceAskedForInAResidualComputedOutside) {
  HockSchittkowski7 problem;
  IpoptOptions options;

  for (const double tolerance : {1e-6, 1e-12}) {
    options.tolerance = tolerance;

    const SolverResult result =
        solve_with_ipopt(problem, cold({2.0, 2.0}), options);

    ASSERT_EQ(result.status, Status::Solved) << result.message;
    EXPECT_LE(nlp::kkt_residual(problem, result.point).max(), tolerance);
  }
}

TEST(Ipopt, AWarmStartAtTheSolutionNeedsAtMostOneIteration) {
  HockSchittkowski7 problem;
  const SolverResult first = solve_with_ipopt(problem, cold({2.0, 2.0}), {});

  const SolverResult again = solve_with_ipopt(problem, first.point, {});

  ASSERT_EQ(again.status, Status::Solved) << again.message;
  EXPECT_LE(again.iterations, 1);
  EXPECT_NEAR(again.point.x[1], HockSchittkowski7::kSolution, kTolerance);
  EXPECT_NEAR(again.point.lambda[0], HockSchittkowski7::kMultiplier,
              kTolerance);
}

TEST(Ipopt, KeepsAFixedVariableExactlyWhereItIs) {
  constexpr double kFixed = 1.0 / 3.0;
  NearestPoint problem;
  problem.fix(2, kFixed);

  const SolverResult result =
      solve_with_ipopt(problem, cold({1.0, 1.0, kFixed}), {});

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  EXPECT_EQ(result.point.x[2], kFixed);
  EXPECT_NEAR(result.point.x[0], 0.5 * (6.0 - kFixed), kTolerance);
  EXPECT_NEAR(result.point.x[1], 0.5 * (6.0 - kFixed), kTolerance);
}

TEST(Ipopt, StepsBackFromPointsThatTheProblemRefuses) {
  LogarithmicBowl problem;

  const SolverResult result = solve_with_ipopt(problem, cold({3.0, 3.0}), {});

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  EXPECT_GT(result.refused_points, 0);
  EXPECT_NEAR(result.point.x[0], 1.0, kTolerance);
  EXPECT_NEAR(result.point.x[1], 1.0, kTolerance);
}

TEST(Ipopt, TheLogIsKeptIfAskedForOnly) {
  HockSchittkowski7 problem;
  IpoptOptions verbose;
  verbose.verbose = true;

  const SolverResult silent = solve_with_ipopt(problem, cold({2.0, 2.0}), {});
  const SolverResult logged =
      solve_with_ipopt(problem, cold({2.0, 2.0}), verbose);

  EXPECT_EQ(silent.log, "");
  EXPECT_NE(logged.log.find("inf_pr"), std::string::npos) << logged.log;
}

/// A scratch directory as the working directory.
class ScratchDirectory {
 public:
  ScratchDirectory() : previous_(std::filesystem::current_path()) {
    std::string name =
        (std::filesystem::temp_directory_path() / "brachisto-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
    std::filesystem::current_path(path_);
  }
  ~ScratchDirectory() {
    std::filesystem::current_path(previous_);
    std::filesystem::remove_all(path_);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

 private:
  std::filesystem::path previous_, path_;
};

TEST(Ipopt, AStrayOptionFileInTheWorkingDirectoryIsIgnored) {
  const ScratchDirectory directory;
  std::ofstream("ipopt.opt") << "max_iter 0\n";
  HockSchittkowski7 problem;

  const SolverResult result = solve_with_ipopt(problem, cold({2.0, 2.0}), {});

  EXPECT_EQ(result.status, Status::Solved) << result.message;
}

/// What the process writes to a descriptor while this lives, C and C++ alike.
class Capture {
 public:
  explicit Capture(int descriptor)
      : descriptor_(descriptor), file_(std::tmpfile()) {
    std::fflush(nullptr);
    saved_ = ::dup(descriptor_);
    ::dup2(::fileno(file_), descriptor_);
  }
  ~Capture() { std::fclose(file_); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  /// Ends the capture.
  [[nodiscard]] std::string text() {
    std::fflush(nullptr);
    ::dup2(saved_, descriptor_);
    ::close(saved_);
    std::string out;
    std::rewind(file_);
    for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) {
      out += static_cast<char>(c);
    }
    return out;
  }

 private:
  int descriptor_;
  int saved_ = -1;
  std::FILE* file_;
};

TEST(Ipopt, PrintsNothing) {
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    for (const bool verbose : {false, true}) {
      HockSchittkowski7 problem;
      IpoptOptions options;
      options.verbose = verbose;
      Capture capture(descriptor);

      static_cast<void>(solve_with_ipopt(problem, cold({2.0, 2.0}), options));
      const std::string text = capture.text();

      EXPECT_EQ(text, "") << "descriptor " << descriptor;
    }
  }
}

TEST(Ipopt, KnowsItsVersions) {
  EXPECT_TRUE(ipopt_version().starts_with("3.")) << ipopt_version();
  EXPECT_NE(mumps_version(), "");
}

}  // namespace
}  // namespace brachisto
