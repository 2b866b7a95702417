// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Right derivatives are told from wrong ones, each where it is wrong.

#include "program_files/derivative_check.hpp"

#include <gtest/gtest.h>

#include <cstddef>

#include "nlp/tiny_problem.hpp"

namespace brachisto {
namespace {

using program_files::check_program;
using program_files::ProgramCheck;
using testing::TinyProblem;

/// Not its answer, so that nothing vanishes.
const PrimalDual kPoint{{1.25, 0.75, 2.0}, {-2.0, 0.5}};

TEST(DerivativeCheck, FindsNothingWrongWithRightOnes) {
  TinyProblem problem;

  const ProgramCheck check = check_program(problem, kPoint);

  EXPECT_TRUE(check.agrees()) << check.in_words();
  EXPECT_EQ(check.variables, 3);
  EXPECT_EQ(check.fixed, 1);
  EXPECT_EQ(check.constraints, 2);
  EXPECT_EQ(check.links, 0);
  // f is quadratic, so that the formula errs by rounding over the step alone:
  // of numbers of order ten, 1e-15 over 1e-3.
  for (const auto& one : check.derivatives) {
    EXPECT_LE(one.difference, 1e-11) << one.name;
  }
  // The Hessian (2 1/2; 1/2 2) on the null space of (1 1; 3/4 5/4), which is
  // empty: as many signs of each kind as there are equations.
  EXPECT_TRUE(check.minimum());
  EXPECT_EQ(check.inertia.positive, 2);
  EXPECT_EQ(check.inertia.negative, 2);
}

TEST(DerivativeCheck, NamesTheRowOfAWrongEntry) {
  constexpr double kWrong = 1e-6;
  struct Fault {
    std::vector<double> TinyProblem::*spoilt;
    std::size_t entry, derivative;
    const char* row;
  };
  for (const Fault& fault :
       {Fault{&TinyProblem::spoil_grad_f, 1, 0, "the objective"},
        Fault{&TinyProblem::spoil_jac_g, 1, 1, "g[0]"},
        Fault{&TinyProblem::spoil_jac_g, 4, 1, "g[1]"},
        Fault{&TinyProblem::spoil_hess_lag, 3, 2, "x[1]"}}) {
    TinyProblem problem;
    (problem.*fault.spoilt)[fault.entry] = kWrong;

    const ProgramCheck check = check_program(problem, kPoint);

    SCOPED_TRACE(fault.row);
    EXPECT_FALSE(check.agrees());
    const auto& wrong = check.derivatives[fault.derivative];
    EXPECT_FALSE(wrong.agrees());
    EXPECT_EQ(wrong.worst_row, fault.row);
    EXPECT_GT(wrong.difference, 0.1 * kWrong);
    EXPECT_LT(wrong.difference, 10.0 * kWrong);
  }
}

TEST(DerivativeCheck, DoesNotTakeNothingForAgreement) {
  TinyProblem problem;
  problem.spoil_g[0] = std::numeric_limits<double>::quiet_NaN();

  EXPECT_FALSE(check_program(problem, kPoint).agrees());
}

}  // namespace
}  // namespace brachisto
