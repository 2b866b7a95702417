// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Programs with inequalities: Ipopt, its multipliers, warm starts, polishing by
// Newton's method and the inertia, against published and closed-form solutions;
// the chain factorisation against MUMPS.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "nlp/active_set.hpp"
#include "solvers/chain_hook.hpp"
#include "solvers/hock_schittkowski.hpp"
#include "solvers/inequality_problems.hpp"
#include "solvers/inertia.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto::testing {
namespace {

void expect_near(const std::vector<double>& found,
                 const std::vector<double>& expected, double tolerance,
                 const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], tolerance) << what << ", entry " << i;
  }
}

template <class Formula>
class HockSchittkowski : public ::testing::Test {};
using Formulas = ::testing::Types<Hs35, Hs43, Hs71, Hs76, Hs83, Hs100>;
TYPED_TEST_SUITE(HockSchittkowski, Formulas);

/// One unit of the last of seven printed digits.
double printed(double value) {
  return std::abs(value) < 1e-7
             ? 1e-7
             : std::pow(10.0, std::floor(std::log10(std::abs(value))) - 6.0);
}

TYPED_TEST(HockSchittkowski, HasThePublishedSolution) {
  DenseProblem<TypeParam> problem;

  const SolverResult result =
      solve_with_ipopt(problem, {TypeParam::kStart, {}}, {});

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  ASSERT_TRUE(problem.set_point(result.point.x));
  EXPECT_NEAR(problem.eval_f(), TypeParam::kLeast, TypeParam::kDigit);
  for (std::size_t i = 0; i < result.point.x.size(); ++i) {
    EXPECT_NEAR(result.point.x[i], TypeParam::kSolution[i],
                printed(TypeParam::kSolution[i]))
        << "x" << i;
  }
  for (std::size_t i = 0; i < TypeParam::kMultipliers.size(); ++i) {
    EXPECT_NEAR(result.point.lambda[i], TypeParam::kMultipliers[i],
                printed(TypeParam::kMultipliers[i]))
        << "lambda" << i;
  }
}

TYPED_TEST(HockSchittkowski, SatisfiesTheKktConditions) {
  DenseProblem<TypeParam> problem;

  const SolverResult result =
      solve_with_ipopt(problem, {TypeParam::kStart, {}}, {});
  const nlp::KktResidual kkt = nlp::kkt_residual(problem, result.point);

  // Ipopt's tolerance is relative to the mean of the multipliers over 100.
  double sum = 0.0;
  for (const double lambda : result.point.lambda) sum += std::abs(lambda);
  for (const double z : result.point.z_lower) sum += z;
  for (const double z : result.point.z_upper) sum += z;
  EXPECT_LE(kkt.max(), 1e-12 * std::max(1.0, sum)) << kkt.worst_variable;
  EXPECT_EQ(kkt.sign, 0.0);
}

TYPED_TEST(HockSchittkowski, PassesIpoptsDerivativeChecker) {
  DenseProblem<TypeParam> problem;
  IpoptOptions options;
  options.check_derivatives = true;
  options.max_iterations = 0;

  const SolverResult result =
      solve_with_ipopt(problem, {TypeParam::kSolution, {}}, options);

  EXPECT_THAT(result.log, ::testing::HasSubstr(
                              "No errors detected by derivative checker."));
}

TYPED_TEST(HockSchittkowski, IsPolishedToItsActiveBounds) {
  DenseProblem<TypeParam> problem;
  IpoptOptions rough;
  rough.tolerance = 1e-6;
  const SolverResult result =
      solve_with_ipopt(problem, {TypeParam::kStart, {}}, rough);
  NewtonOptions options;
  // Values and multipliers up to 1e4 in problem 83, some ε of them.
  options.tolerance = std::abs(TypeParam::kLeast) > 1e4 ? 1e-11 : 1e-12;

  const NewtonResult polished =
      solve_with_newton(problem, result.point, options);

  EXPECT_EQ(polished.status, Status::Solved) << polished.residual;
  const nlp::KktResidual kkt = nlp::kkt_residual(problem, polished.point);
  EXPECT_LE(kkt.max(), options.tolerance);
  // An active variable lies on its bound exactly; the value of an active
  // constraint within the rounding of its terms, which λ multiplies: in problem
  // 83 with 809 times ε of 20.
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  double rounding = 1e3 * kEpsilon;
  for (int i = 0; i < TypeParam::kConstraints; ++i) {
    const double lambda = polished.point.lambda[static_cast<std::size_t>(i)];
    const nlp::Range range = problem.constraint_range(i);
    // The bound that λ belongs to.
    const double bound = lambda < 0.0 ? range.lower : range.upper;
    if (std::isfinite(bound)) {
      rounding = std::max(rounding, 4.0 * kEpsilon * std::abs(lambda * bound));
    }
  }
  EXPECT_LE(kkt.complementarity, rounding);
  const nlp::ActiveSet active = nlp::active_set(problem, polished.point);
  EXPECT_EQ(active.num_free(), TypeParam::kFree);
  EXPECT_EQ(active.num_equations(), TypeParam::kEquations);
}

TYPED_TEST(HockSchittkowski, HasTheInertiaOfAMinimum) {
  DenseProblem<TypeParam> problem;
  const SolverResult result =
      solve_with_ipopt(problem, {TypeParam::kStart, {}}, {});

  const Inertia inertia = kkt_inertia(problem, result.point);

  EXPECT_TRUE(inertia.known);
  EXPECT_EQ(inertia.positive, TypeParam::kFree);
  EXPECT_EQ(inertia.negative, TypeParam::kEquations);
  EXPECT_EQ(inertia.zero, 0);
}

TYPED_TEST(HockSchittkowski, StartsWarmWithAllItsMultipliers) {
  DenseProblem<TypeParam> problem;
  const SolverResult cold =
      solve_with_ipopt(problem, {TypeParam::kStart, {}}, {});

  const SolverResult warm = solve_with_ipopt(problem, cold.point, {});

  EXPECT_EQ(warm.status, Status::Solved) << warm.message;
  EXPECT_LE(warm.iterations, 3) << "cold: " << cold.iterations;
}

/// Where chain and MUMPS are compared.
template <class Problem>
struct Pair {
  Problem problem;
  SolverResult chain, mumps;

  Pair(int num_pieces, bool as_constraints)
      : problem(num_pieces, as_constraints),
        chain(with(LinearSolver::Chain, problem, {problem.start(), {}})),
        mumps(with(LinearSolver::Mumps, problem, {problem.start(), {}})) {}
};

template <class Problem>
void expect_same_way(Pair<Problem>& pair, const std::string& what) {
  EXPECT_EQ(pair.chain.status, Status::Solved) << what << pair.chain.message;
  EXPECT_EQ(pair.mumps.status, Status::Solved) << what << pair.mumps.message;
  EXPECT_EQ(pair.chain.linear_solver, LinearSolver::Chain) << what;
  EXPECT_EQ(pair.mumps.linear_solver, LinearSolver::Mumps) << what;
  EXPECT_EQ(pair.chain.iterations, pair.mumps.iterations) << what;
  const nlp::ActiveSet active = nlp::active_set(pair.problem, pair.mumps.point);
  for (const LinearSolver solver : {LinearSolver::Chain, LinearSolver::Mumps}) {
    const Inertia inertia = kkt_inertia(pair.problem, pair.chain.point, solver);
    EXPECT_TRUE(inertia.known) << what;
    EXPECT_EQ(inertia.positive, active.num_free()) << what;
    EXPECT_EQ(inertia.negative, active.num_equations()) << what;
    EXPECT_EQ(inertia.zero, 0) << what;
  }
}

/// An interior-point solution and both ways to polish it.
template <class Problem>
std::vector<NewtonResult> polished(Pair<Problem>& pair) {
  std::vector<NewtonResult> out;
  for (const LinearSolver solver : {LinearSolver::Chain, LinearSolver::Mumps}) {
    NewtonOptions options;
    options.linear_solver = solver;
    options.to_rounding = true;
    out.push_back(solve_with_newton(pair.problem, pair.chain.point, options));
  }
  return out;
}

constexpr int kPieces[] = {10, 24, 100, 500};
constexpr int kOddPieces[] = {11, 25, 101, 501};

TEST(ObstacleProblem, IsSolvedAlikeByChainAndMumps) {
  for (const int N : kPieces) {
    for (const bool as_constraints : {false, true}) {
      Pair<Obstacle> pair(N, as_constraints);

      expect_same_way(pair,
                      "N = " + std::to_string(N) +
                          (as_constraints ? ", constraints" : ", bounds"));
    }
  }
}

TEST(ObstacleProblem, HasItsClosedFormAfterPolishing) {
  for (const int N : kPieces) {
    for (const bool as_constraints : {false, true}) {
      Pair<Obstacle> pair(N, as_constraints);

      for (const NewtonResult& result : polished(pair)) {
        const std::string what = "N = " + std::to_string(N);
        EXPECT_EQ(result.status, Status::Solved) << what;
        // The inverse of the matrix of second differences over h is below N/8;
        // forces are differences of N y.
        constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
        for (int j = 1; j < N; ++j) {
          const auto i = static_cast<std::size_t>(j);
          const double force = as_constraints ? -result.point.lambda[i - 1]
                                              : result.point.z_lower[i];
          EXPECT_NEAR(result.point.x[i], pair.problem.y(j), N * kEpsilon)
              << what << ", node " << j;
          EXPECT_NEAR(force, pair.problem.force(j), 16.0 * N * kEpsilon)
              << what << ", node " << j;
        }
      }
    }
  }
}

TEST(DoubleIntegratorProblem, IsSolvedAlikeByChainAndMumps) {
  for (const int N : kOddPieces) {
    for (const bool as_constraints : {false, true}) {
      Pair<DoubleIntegrator> pair(N, as_constraints);

      expect_same_way(pair,
                      "N = " + std::to_string(N) +
                          (as_constraints ? ", constraints" : ", bounds"));
    }
  }
}

TEST(DoubleIntegratorProblem, IsBangBangWithTheClosedFormMultipliers) {
  for (const int N : kOddPieces) {
    for (const bool as_constraints : {false, true}) {
      Pair<DoubleIntegrator> pair(N, as_constraints);
      const PrimalDual expected = pair.problem.solution();

      for (const NewtonResult& result : polished(pair)) {
        const std::string what = "N = " + std::to_string(N);
        EXPECT_EQ(result.status, Status::Solved) << what;
        // Sums of N terms of order one.
        const double tolerance =
            4.0 * N * std::numeric_limits<double>::epsilon();
        expect_near(result.point.x, expected.x, tolerance, what + ", x");
        expect_near(result.point.lambda, expected.lambda, tolerance,
                    what + ", lambda");
        expect_near(result.point.z_lower, expected.z_lower, tolerance,
                    what + ", z_lower");
        expect_near(result.point.z_upper, expected.z_upper, tolerance,
                    what + ", z_upper");
      }
    }
  }
}

TEST(DoubleIntegratorProblem, HasDerivativesThatPassIpoptsChecker) {
  for (const bool as_constraints : {false, true}) {
    DoubleIntegrator problem(7, as_constraints);
    IpoptOptions options;
    options.check_derivatives = true;
    options.max_iterations = 0;

    const SolverResult result =
        solve_with_ipopt(problem, {problem.start(), {}}, options);

    EXPECT_THAT(result.log, ::testing::HasSubstr(
                                "No errors detected by derivative checker."));
  }
}

TEST(KktResidualOfInequalities, MeansTheSameOnEveryMesh) {
  // Controls off their bounds by ε: the complementarity is ε times the largest
  // |∫ p_v dt| over the weight 1/N, that of the first piece, which tends to 2
  // ε.
  constexpr double kOff = 1e-3;
  for (const bool as_constraints : {false, true}) {
    for (const int N : {11, 101, 1001}) {
      DoubleIntegrator problem(N, as_constraints);
      PrimalDual point = problem.solution();
      EXPECT_LE(nlp::kkt_residual(problem, point).max(),
                8.0 * N * std::numeric_limits<double>::epsilon());

      for (int j = 0; j < N; ++j) {
        point.x[static_cast<std::size_t>(DoubleIntegrator::u(j))] *= 1.0 - kOff;
      }
      const nlp::KktResidual kkt = nlp::kkt_residual(problem, point);

      const double T = point.x[static_cast<std::size_t>(problem.T())];
      EXPECT_NEAR(kkt.complementarity,
                  kOff * 0.25 * T * T * T * (1.0 - 1.0 / N), 1e-12)
          << N;
    }
  }
}

TEST(NewtonWithInequalities, SaysSoIfOtherInequalitiesHold) {
  // At the start of problem 35 no inequality holds as an equation. Without them
  // the least f is 0 at (1, 1, 1), where x₀ + x₁ + 2 x₂ = 4 > 3.
  DenseProblem<Hs35> problem;

  const NewtonResult result = solve_with_newton(problem, {Hs35::kStart, {0.0}});

  EXPECT_LE(result.residual, 1e-12);
  EXPECT_FALSE(result.active_set_holds);
  EXPECT_EQ(result.status, Status::NotConverged);
}

TEST(NewtonWithInequalities, DoesNotHoldAVariableAgainstItsMultiplier) {
  // x₂ held at 0 in problem 35: f is least at (5/3, 2/3, 0), with ∂f/∂x₂ =
  // −2/3.
  DenseProblem<Hs35> problem;

  const NewtonResult result =
      solve_with_newton(problem, {{1.0, 1.0, 0.0}, {0.0}});

  EXPECT_NEAR(result.point.z_lower[2], -2.0 / 3.0, 1e-12);
  EXPECT_FALSE(result.active_set_holds);
  EXPECT_EQ(result.status, Status::NotConverged);
}

TEST(ChainInIpopt, IsNotUsedWithAnotherReleaseOfIpopt) {
  Obstacle problem(24, false);
  const PrimalDual start{problem.start(), {}};
  IpoptOptions options;
  options.verbose = true;

  const SolverResult right = solve_with_ipopt(problem, start, options);
  const SolverResult other = solve_with_ipopt(problem, start, options, "3.99");
  options.linear_solver = LinearSolver::Chain;
  const SolverResult demanded =
      solve_with_ipopt(problem, start, options, "3.99");

  EXPECT_EQ(right.linear_solver, LinearSolver::Chain);
  EXPECT_EQ(other.status, Status::Solved);
  EXPECT_EQ(other.linear_solver, LinearSolver::Mumps);
  EXPECT_EQ(other.iterations, right.iterations);
  EXPECT_THAT(other.log,
              ::testing::HasSubstr("linear solver mumps, not chain: it works "
                                   "with Ipopt 3.99, and this is " +
                                   ipopt_version()));
  EXPECT_EQ(demanded.status, Status::InternalError);
  EXPECT_THAT(demanded.message,
              ::testing::HasSubstr("this is " + ipopt_version()));
}

}  // namespace
}  // namespace brachisto::testing
