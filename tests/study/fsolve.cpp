// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What solve() says of the paper's discrete solution.

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using testing::off_centred_scene;

SolveOptions fsolve_options(DiscreteSolver solver) {
  SolveOptions options;
  options.use<DiscreteSystem>().solver = solver;
  return options;
}

TEST(MethodFsolve, SolvesAndIsNotVerified) {
  const Solution solution =
      solve(off_centred_scene(), fsolve_options(DiscreteSolver::Hybrid));

  EXPECT_EQ(solution.status, Status::Solved) << solution.message;
  ASSERT_TRUE(solution.discrete());
  EXPECT_EQ(solution.discrete()->nodes, 100);
  EXPECT_NEAR(solution.discrete()->tau, 5.0802, 1e-4);  // computed elsewhere
  EXPECT_FALSE(solution.verified());
  EXPECT_EQ(solution.motion(), nullptr);
  EXPECT_FALSE(solution.diagnostics);
}

TEST(MethodFsolve, StatesItsTrueError) {
  SolveOptions options = fsolve_options(DiscreteSolver::Lifted);
  options.use<DiscreteSystem>().nodes = 50;

  const Solution solution = solve(off_centred_scene(), options);

  const double exact = testing::reference("reference_case").tau;
  ASSERT_TRUE(solution.discrete());
  ASSERT_TRUE(solution.extremal);
  const Check* check = solution.certificate.find("discretisation");
  ASSERT_NE(check, nullptr);
  EXPECT_FALSE(check->passed);
  // The extremal method has ten digits and more.
  EXPECT_NEAR(check->value, std::abs(solution.discrete()->tau / exact - 1.0),
              1e-10);
  ASSERT_EQ(solution.not_verified_because().size(), 1u);
  EXPECT_NE(solution.message.find(solution.not_verified_because().front()),
            std::string::npos)
      << solution.message;
}

TEST(MethodFsolve, IsNotVerifiedEvenIfEveryCheckPassed) {
  Solution solution;
  solution.status = Status::Solved;
  solution.certificate.add("discretisation", 0.0, 1e-10);
  solution.answer = std::make_shared<const Answer>(DiscreteAnswer{});

  EXPECT_FALSE(solution.verified());
}

TEST(MethodFsolve, TellsWhyItFailed) {
  Scene scene = off_centred_scene();
  scene.L = 2.0;

  const Solution solution =
      solve(scene, fsolve_options(DiscreteSolver::Hybrid));

  EXPECT_NE(solution.status, Status::Solved);
  EXPECT_FALSE(solution.verified());
  EXPECT_FALSE(solution.extremal) << "nothing to compare";
  EXPECT_NE(solution.message.find("progress"), std::string::npos)
      << solution.message;
}

TEST(MethodFsolve, KeepsLimits) {
  SolveOptions options = fsolve_options(DiscreteSolver::Lifted);
  options.limits.iterations = 1;

  EXPECT_EQ(solve(off_centred_scene(), options).status, Status::IterationLimit);
  options = fsolve_options(DiscreteSolver::Hybrid);
  options.limits.seconds = 1e-9;
  const Solution late = solve(off_centred_scene(), options);
  EXPECT_EQ(late.status, Status::TimeLimit);
  EXPECT_FALSE(late.discrete());
}

}  // namespace
}  // namespace brachisto
