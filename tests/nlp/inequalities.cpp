// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ranges, the KKT residual and the active set of a program with inequalities
// that is solved by hand.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "brachisto/nlp/problem.hpp"
#include "nlp/active_set.hpp"
#include "nlp/tiny_problem.hpp"
#include "solvers/inequality_problems.hpp"
#include "support/numbers.hpp"

namespace brachisto::testing {
namespace {

using nlp::Held;
using nlp::kkt_residual;
using nlp::KktResidual;

/// minimise (x₀ − 2)² + (x₁ + 1)² subject to 0 ≤ x₀ + x₁ ≤ 1, x₀ ≤ 5,
/// 0 ≤ x₁ ≤ 3. At the solution (1, 0) ∇f = (−2, 2): λ = 2, z_l = (0, 4).
struct ByHand {
  static constexpr int kVariables = 2, kConstraints = 1;
  static constexpr std::array<nlp::Range, 2> kBounds{
      {{-kNoBound, 5.0}, {0.0, 3.0}}};
  static constexpr std::array<nlp::Range, 1> kRanges{{{0.0, 1.0}}};

  template <class X>
  static auto f(const X& x) {
    return (x[0] - 2.0) * (x[0] - 2.0) + (x[1] + 1.0) * (x[1] + 1.0);
  }
  template <class X>
  static auto g(const X& x) {
    return std::array{x[0] + x[1]};
  }
};

const PrimalDual kSolution{{1.0, 0.0}, {2.0}, {0.0, 4.0}, {0.0, 0.0}};

TEST(ProblemRanges, AreEquationsUnlessAProblemSaysOtherwise) {
  const TinyProblem equations;
  const DenseProblem<ByHand> inequalities;

  EXPECT_FALSE(equations.has_inequalities());
  EXPECT_TRUE(equations.constraint_range(1).single());
  EXPECT_EQ(equations.constraint_range(1).lower, 0.0);
  EXPECT_TRUE(equations.variable_range(2).single());
  EXPECT_FALSE(equations.variable_range(0).bounded());

  EXPECT_TRUE(inequalities.has_inequalities());
  EXPECT_EQ(inequalities.constraint_range(0).upper, 1.0);
  EXPECT_TRUE(inequalities.variable_range(0).bounded());
  EXPECT_FALSE(inequalities.variable_range(1).single());
}

TEST(KktResidualWithInequalities, VanishesAtTheSolution) {
  DenseProblem<ByHand> problem;

  const KktResidual residual = kkt_residual(problem, kSolution);

  EXPECT_EQ(residual.max(), 0.0);
  EXPECT_EQ(residual.barrier_parameter, 0.0);
}

TEST(KktResidualWithInequalities, TellsTheConditionsApart) {
  DenseProblem<ByHand> problem;
  const auto at = [&](PrimalDual point) {
    return kkt_residual(problem, point);
  };

  // No multiplier of the bound of x₁.
  const KktResidual slope = at({{1.0, 0.0}, {2.0}});
  EXPECT_EQ(slope.stationarity, 4.0);
  EXPECT_EQ(slope.worst_variable, "x1");
  EXPECT_EQ(slope.complementarity, 0.0);

  // x₁ below its bound by ½, x₀ + x₁ = 3 above by 2.
  const KktResidual outside = at({{3.5, -0.5}, {0.0}});
  EXPECT_EQ(outside.bound_violation, 0.5);
  EXPECT_EQ(outside.infeasibility, 2.0);
  EXPECT_EQ(outside.worst_constraint, "g0");

  // z_l of x₁ at ½ from its bound; λ where g is ¼ from its upper one.
  const KktResidual inside = at({{0.25, 0.5}, {2.0}, {0.0, 4.0}, {0.0, 0.0}});
  EXPECT_EQ(inside.complementarity, 2.0);
  EXPECT_EQ(inside.worst_multiplier, "x1");
  EXPECT_EQ(inside.sign, 0.0);
  // Products 4 · ½ and 2 · ¼ over the four bounds that multipliers belong to:
  // three of variables, the nearer one of g.
  EXPECT_EQ(inside.gap, 2.5);
  EXPECT_EQ(inside.barrier_parameter, 0.625);

  // λ belongs to the nearer bound, the upper one: λ < 0 has the wrong sign.
  EXPECT_EQ(at({{0.25, 0.5}, {-2.0}}).complementarity, 0.5);
  EXPECT_EQ(at({{0.25, 0.5}, {-2.0}}).sign, 2.0);

  // A multiplier of the wrong sign, and one without a bound.
  EXPECT_EQ(at({{1.0, 0.0}, {2.0}, {0.0, -4.0}, {0.0, 0.0}}).sign, 4.0);
  EXPECT_EQ(at({{1.0, 0.0}, {2.0}, {3.0, 4.0}, {0.0, 0.0}}).sign, 3.0);
}

TEST(KktResidualWithInequalities, NeverHidesANotANumber) {
  DenseProblem<ByHand> problem;
  for (int i = 0; i < 5; ++i) {
    PrimalDual point = kSolution;
    (i < 2   ? point.x[static_cast<std::size_t>(i)]
     : i < 3 ? point.lambda[0]
     : i < 4 ? point.z_lower[1]
             : point.z_upper[0]) = kNaN;

    const KktResidual residual = kkt_residual(problem, point);

    EXPECT_TRUE(std::isnan(residual.max())) << i;
    if (i >= 2) {
      EXPECT_TRUE(std::isnan(residual.complementarity)) << i;
    }
  }
}

TEST(KktResidualWithInequalities, RefusesMultipliersOfTheWrongLength) {
  DenseProblem<ByHand> problem;
  PrimalDual point = kSolution;
  point.z_upper.clear();

  EXPECT_THROW(static_cast<void>(kkt_residual(problem, point)),
               std::invalid_argument);
}

TEST(ActiveSet, HoldsWhatHasALargerMultiplierThanDistance) {
  DenseProblem<ByHand> problem;
  // As an interior-point method leaves it, with products 1e-8.
  const PrimalDual near{{1.0, 2.5e-9}, {2.0}, {0.0, 4.0}, {2.5e-9, 3.3e-9}};

  const nlp::ActiveSet active = nlp::active_set(problem, near);

  EXPECT_EQ(active.variables[0], Held::No);
  EXPECT_EQ(active.variables[1], Held::AtLower);
  EXPECT_EQ(active.constraints[0], Held::AtUpper);
  EXPECT_EQ(active.num_free(), 1);
  EXPECT_EQ(active.num_equations(), 1);

  PrimalDual polished{{1.0, 0.0}, {2.0}};
  ASSERT_TRUE(problem.set_point(polished.x));
  nlp::set_bound_multipliers(problem, active, polished);
  EXPECT_EQ(polished.z_lower, kSolution.z_lower);
  EXPECT_EQ(polished.z_upper, kSolution.z_upper);
}

TEST(ActiveSet, OfEquationsDependsOnNoPoint) {
  TinyProblem problem;

  const nlp::ActiveSet active = nlp::active_set(problem, {});

  EXPECT_EQ(problem.points, 0);
  EXPECT_EQ(active.num_free(), 2);
  EXPECT_EQ(active.num_equations(), 2);
  EXPECT_EQ(active.variables[2], Held::AtLower);
}

}  // namespace
}  // namespace brachisto::testing
