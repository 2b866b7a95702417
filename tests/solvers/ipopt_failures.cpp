// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What Ipopt reports where a problem misbehaves.

#include <gtest/gtest.h>

#include <ostream>
#include <span>
#include <string>

#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto {
namespace {

using testing::Function;
using testing::HockSchittkowski7;
using testing::kStart;
using testing::LogarithmicBowl;
using testing::NearestPoint;

/// No relative of std::exception, so that nobody can know how to copy it.
struct Mishap {
  int number;
  std::string text;
};

class ExceptionInAnEvaluation : public ::testing::TestWithParam<Function> {};
INSTANTIATE_TEST_SUITE_P(EachFunction, ExceptionInAnEvaluation,
                         ::testing::Values(Function::SetPoint, Function::F,
                                           Function::GradF, Function::G,
                                           Function::JacG, Function::HessLag));

TEST_P(ExceptionInAnEvaluation, IsRethrownUnchanged) {
  HockSchittkowski7 problem;
  problem.on_call = [](Function function) {
    if (function == GetParam()) throw Mishap{42, "as it was thrown"};
  };

  try {
    static_cast<void>(solve_with_ipopt(problem, kStart, {}));
    FAIL() << "nothing was thrown";
  } catch (const Mishap& mishap) {
    EXPECT_EQ(mishap.number, 42);
    EXPECT_EQ(mishap.text, "as it was thrown");
  }
}

TEST_P(ExceptionInAnEvaluation, EndsTheRunAtOnce) {
  HockSchittkowski7 problem;
  int thrown = 0;
  problem.on_call = [&](Function function) {
    if (function != GetParam()) return;
    ++thrown;
    throw Mishap{thrown, ""};
  };

  EXPECT_THROW(static_cast<void>(solve_with_ipopt(problem, kStart, {})),
               Mishap);

  EXPECT_EQ(thrown, 1);
}

// With fixed variables Ipopt holds an array while it asks for the gradient or
// the Hessian, which is lost if an exception passes: the leak sanitizer would
// tell.
TEST_P(ExceptionInAnEvaluation, WithAFixedVariableLeaksNothing) {
  NearestPoint problem;
  problem.fix(2, 1.0);
  problem.on_call = [](Function function) {
    if (function == GetParam()) throw Mishap{5, ""};
  };

  EXPECT_THROW(
      static_cast<void>(solve_with_ipopt(problem, {{2.0, 2.0, 1.0}, {}}, {})),
      Mishap);
}

TEST(ExceptionInALaterIteration, IsRethrownToo) {
  HockSchittkowski7 problem;
  int calls = 0;
  problem.on_call = [&](Function function) {
    if (function == Function::HessLag && ++calls == 3) throw Mishap{3, ""};
  };

  EXPECT_THROW(static_cast<void>(solve_with_ipopt(problem, kStart, {})),
               Mishap);
}

TEST(ARunThatThrew, LeavesNoTraceInTheNextOne) {
  HockSchittkowski7 problem;
  problem.on_call = [](Function function) {
    if (function == Function::G) throw Mishap{0, ""};
  };
  EXPECT_THROW(static_cast<void>(solve_with_ipopt(problem, kStart, {})),
               Mishap);
  problem.on_call = [](Function) {};

  const SolverResult result = solve_with_ipopt(problem, kStart, {});

  EXPECT_EQ(result.status, Status::Solved) << result.message;
}

TEST(NotANumberInTheHessian, IsReported) {
  HockSchittkowski7 problem;
  problem.nan_in_hessian = true;

  const SolverResult result = solve_with_ipopt(problem, kStart, {});

  EXPECT_EQ(result.status, Status::NotEvaluable) << result.message;
  EXPECT_NE(result.message.find("not finite"), std::string::npos)
      << result.message;
}

TEST(RefusalAtTheStart, IsNotEvaluable) {
  LogarithmicBowl problem;

  const SolverResult result = solve_with_ipopt(problem, {{-1.0, -1.0}, {}}, {});

  EXPECT_EQ(result.status, Status::NotEvaluable) << result.message;
  EXPECT_GT(result.refused_points, 0);
  EXPECT_NE(result.message.find("the test says so"), std::string::npos)
      << result.message;
}

TEST(RefusalEverywhereButAtTheStart, IsNoSuccess) {
  LogarithmicBowl problem;
  problem.refuses = [](std::span<const double> x) { return x[0] != 3.0; };

  const SolverResult result = solve_with_ipopt(problem, {{3.0, 3.0}, {}}, {});

  // Steps are shortened until they are lost in rounding, again and again.
  EXPECT_NE(result.status, Status::Solved);
  EXPECT_GT(result.refused_points, result.iterations);
}

TEST(AnInfeasibleConstraint, IsNotConverged) {
  // (1 + x₀²)² + x₁² = 4 has no point with x₀ fixed at 2.
  HockSchittkowski7 problem;
  problem.fix(0, 2.0);

  const SolverResult result = solve_with_ipopt(problem, kStart, {});

  EXPECT_NE(result.status, Status::Solved);
  EXPECT_NE(result.message, "");
}

}  // namespace
}  // namespace brachisto
