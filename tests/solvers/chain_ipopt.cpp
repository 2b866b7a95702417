// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ipopt and Newton's method with the chain factorisation and with the general
// solvers: the same iterations to the same points.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "brachisto/solvers/program_solvers.hpp"
#include "model/cycloid.hpp"
#include "solvers/newton_solver.hpp"
#include "solvers/small_problem.hpp"
#include "support/scenes.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto::testing {
namespace {

// Both runs end with KKT residuals below 1e-12; the inverse of the KKT matrix
// on these meshes is below 1e4, so their points differ by less than this.
constexpr double kSamePoint = 1e-8;

double largest_difference(const std::vector<double>& a,
                          const std::vector<double>& b) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

struct Case {
  Scene scene;
  const char* name;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {natural(bead_scene()), "bead"},
      {natural(uniform_scene()), "uniform"},
      {natural(off_centred_scene()), "off-centred"},
      {natural(off_centred_scene(-kPi / 6.0)), "off-centred, starting back"}};
  return all;
}

PrimalDual first_point(const RollingTime& problem, double phi) {
  const Scene& scene = problem.scene();
  return cycloid_guess(problem, *cycloid_between(start_of_centre(scene),
                                                 end_of_centre(scene, phi)));
}

TEST(ChainInIpopt, TakesTheIterationsOfMumps) {
  constexpr double kPhi = -0.1;
  for (const Case& c : cases()) {
    for (int degree = 1; degree <= 8; ++degree) {
      for (const int elements : {4, 24}) {
        RollingTime problem(c.scene, uniform_mesh(degree, elements), kPhi);
        const PrimalDual start = first_point(problem, kPhi);

        const SolverResult chain = with(LinearSolver::Chain, problem, start);
        const SolverResult mumps = with(LinearSolver::Mumps, problem, start);

        const std::string what = std::string(c.name) +
                                 ", p = " + std::to_string(degree) +
                                 ", N = " + std::to_string(elements);
        EXPECT_EQ(chain.linear_solver, LinearSolver::Chain) << what;
        EXPECT_EQ(mumps.linear_solver, LinearSolver::Mumps) << what;
        EXPECT_EQ(chain.status, mumps.status) << what;
        EXPECT_EQ(chain.iterations, mumps.iterations) << what;
        EXPECT_LE(largest_difference(chain.point.x, mumps.point.x), kSamePoint)
            << what;
        EXPECT_LE(largest_difference(chain.point.lambda, mumps.point.lambda),
                  kSamePoint)
            << what;
      }
    }
  }
}

TEST(ChainInIpopt, CorrectsTheInertiaWhereItIsWrong) {
  // Started far off, where the Hessian is indefinite on the null space of the
  // Jacobian, Ipopt has to perturb the matrix until its inertia is right.
  RollingTime problem(natural(off_centred_scene()), uniform_mesh(3, 12), -0.1);
  PrimalDual start = first_point(problem, -0.1);
  for (int c = 0; c < problem.layout().num_points(); ++c) {
    start.x[static_cast<std::size_t>(problem.layout().beta(c))] +=
        c % 2 == 0 ? 1.5 : -1.5;
  }
  IpoptOptions options;
  options.verbose = true;
  const auto run = [&](LinearSolver solver) {
    options.linear_solver = solver;
    return solve_with_ipopt(problem, start, options);
  };

  const SolverResult chain = run(LinearSolver::Chain);
  const SolverResult mumps = run(LinearSolver::Mumps);

  EXPECT_EQ(chain.status, Status::Solved) << chain.message;
  EXPECT_EQ(mumps.status, Status::Solved) << mumps.message;
  EXPECT_EQ(chain.iterations, mumps.iterations);
  EXPECT_LE(largest_difference(chain.point.x, mumps.point.x), kSamePoint);
  // Column lg(rg) of the log: the size of the perturbation.
  EXPECT_NE(chain.log.find("lg(rg)"), std::string::npos);
}

TEST(ChainInIpopt, EndsWhereItsWorkIsUsedUp) {
  constexpr double kPhi = -0.1;
  RollingTime problem(natural(off_centred_scene()), uniform_mesh(4, 24), kPhi);
  const PrimalDual start = first_point(problem, kPhi);
  IpoptOptions options;
  options.linear_solver = LinearSolver::Chain;

  const SolverResult whole = solve_with_ipopt(problem, start, options);
  ASSERT_EQ(whole.status, Status::Solved) << whole.message;
  // Each iteration factorises a matrix at least once.
  EXPECT_GE(whole.effort,
            whole.iterations * static_cast<double>(problem.num_constraints()));

  options.most_effort = 0.5 * whole.effort;
  const SolverResult half = solve_with_ipopt(problem, start, options);
  EXPECT_EQ(half.status, Status::IterationLimit) << half.message;
  EXPECT_LT(half.iterations, whole.iterations);
  EXPECT_GT(half.effort, options.most_effort);
  EXPECT_EQ(half.point.x.size(), whole.point.x.size());

  options.most_effort = whole.effort;
  const SolverResult same = solve_with_ipopt(problem, start, options);
  EXPECT_EQ(same.status, Status::Solved) << same.message;
  EXPECT_EQ(same.effort, whole.effort);
}

TEST(ChainInIpopt, GoesByItsOwnNameInTheLog) {
  RollingTime problem(natural(off_centred_scene()), uniform_mesh(3, 12), -0.1);
  const PrimalDual start = first_point(problem, -0.1);
  IpoptOptions options;
  options.verbose = true;
  const auto log = [&](LinearSolver solver) {
    options.linear_solver = solver;
    return solve_with_ipopt(problem, start, options).log;
  };

  const std::string chain = log(LinearSolver::Chain);
  const std::string mumps = log(LinearSolver::Mumps);

  // Ipopt knows it as MA97, into whose place it is put.
  for (const char* other : {"ma97", "MA97", "Ma97"}) {
    EXPECT_EQ(chain.find(other), std::string::npos) << chain;
  }
  EXPECT_NE(chain.find("running with linear solver chain."), std::string::npos)
      << chain;
  EXPECT_NE(chain.find("that name is replaced"), std::string::npos) << chain;
  // Ipopt 3.14 tells the release too.
  EXPECT_TRUE(mumps.find("linear solver mumps.") != std::string::npos ||
              mumps.find("linear solver MUMPS ") != std::string::npos)
      << mumps;
  EXPECT_EQ(mumps.find("replaced"), std::string::npos) << mumps;
}

TEST(ChainInIpopt, IsWhatAutoTakesForAChain) {
  RollingTime problem(natural(bead_scene()), uniform_mesh(3, 10), -0.1);

  const SolverResult result =
      with(LinearSolver::Auto, problem, first_point(problem, -0.1));

  EXPECT_EQ(result.status, Status::Solved);
  EXPECT_EQ(result.linear_solver, LinearSolver::Chain);
}

TEST(ChainInIpopt, LeavesOtherProblemsToMumpsAndSaysSo) {
  HockSchittkowski7 problem;

  IpoptOptions options;
  options.verbose = true;

  const SolverResult result =
      solve_with_ipopt(problem, {{2.0, 2.0}, {}}, options);

  EXPECT_EQ(result.status, Status::Solved);
  EXPECT_EQ(result.linear_solver, LinearSolver::Mumps);
  EXPECT_NE(result.log.find("the problem states no chain structure"),
            std::string::npos)
      << result.log;
}

TEST(ChainInIpopt, DemandedInVainIsAnError) {
  HockSchittkowski7 problem;

  const SolverResult result =
      with(LinearSolver::Chain, problem, {{2.0, 2.0}, {}});

  EXPECT_EQ(result.status, Status::InternalError);
  EXPECT_EQ(result.message,
            "linear_solver chain cannot be used: the problem states no chain "
            "structure");
}

/// Minimises the distance to the origin on x₀ + x₁ = 1, and states that its
/// unknowns are far from each other.
class FalseChain final : public SmallProblem {
 public:
  FalseChain() : SmallProblem(2) {}
  [[nodiscard]] nlp::ChainStructure chain_structure() const override {
    nlp::ChainStructure chain;
    chain.num_links = 1000;
    chain.block = {0, 1000, 2000};
    return chain;
  }

 private:
  [[nodiscard]] double f() const override {
    return 0.5 * (x_[0] * x_[0] + x_[1] * x_[1]);
  }
  void grad_f(std::span<double> values) const override {
    values[0] = x_[0];
    values[1] = x_[1];
  }
  [[nodiscard]] double g() const override { return x_[0] + x_[1] - 1.0; }
  void grad_g(std::span<double> values) const override {
    values[0] = values[1] = 1.0;
  }
  void hess_lag(double factor, double /*lambda*/,
                std::span<double> values) const override {
    values[0] = values[2] = factor;
    values[1] = 0.0;
  }
};

TEST(ChainInIpopt, SeesThroughAFalseStatement) {
  FalseChain problem;
  const PrimalDual start{{2.0, 2.0}, {}};

  const SolverResult automatic = with(LinearSolver::Auto, problem, start);
  const SolverResult demanded = with(LinearSolver::Chain, problem, start);

  EXPECT_EQ(automatic.status, Status::Solved) << automatic.message;
  EXPECT_EQ(automatic.linear_solver, LinearSolver::Mumps);
  EXPECT_EQ(demanded.status, Status::InternalError);
  EXPECT_NE(demanded.message.find("not the chain"), std::string::npos)
      << demanded.message;
}

TEST(ChainInNewton, MakesTheStepsOfSparseLu) {
  for (const Case& c : cases()) {
    for (const int degree : {1, 2, 5, 8}) {
      constexpr double kPhi = -0.1;
      RollingTime problem(c.scene, uniform_mesh(degree, 16), kPhi);
      const PrimalDual near =
          with(LinearSolver::Mumps, problem, first_point(problem, kPhi)).point;
      const auto run = [&](LinearSolver solver) {
        ContactEquation contact(problem);
        NewtonOptions options;
        options.linear_solver = solver;
        return NewtonSolver(problem, &contact).solve(near, kPhi, options);
      };

      const NewtonResult chain = run(LinearSolver::Chain);
      const NewtonResult lu = run(LinearSolver::Mumps);

      const std::string what =
          std::string(c.name) + ", p = " + std::to_string(degree);
      EXPECT_EQ(chain.status, lu.status) << what;
      // Where sparse LU loses digits, as it does on the uniform cylinder with
      // p = 1, it needs a step more.
      EXPECT_LE(chain.iterations, lu.iterations) << what;
      EXPECT_EQ(chain.chain_steps, chain.iterations) << what;
      EXPECT_EQ(lu.chain_steps, 0) << what;
      EXPECT_EQ(chain.determinant_sign, lu.determinant_sign) << what;
      EXPECT_NEAR(chain.phi, lu.phi, kSamePoint) << what;
      EXPECT_LE(largest_difference(chain.point.x, lu.point.x), kSamePoint)
          << what;
      EXPECT_LE(largest_difference(chain.point.lambda, lu.point.lambda),
                kSamePoint)
          << what;
    }
  }
}

TEST(ChainInNewton, MakesTheStepsOfSparseLuBetweenFixedEnds) {
  RollingTime problem(natural(off_centred_scene()), uniform_mesh(4, 16), -0.1);
  const PrimalDual near =
      with(LinearSolver::Mumps, problem, first_point(problem, -0.1)).point;
  problem.set_end_angle(-0.12);
  const auto run = [&](LinearSolver solver) {
    NewtonOptions options;
    options.linear_solver = solver;
    return solve_with_newton(problem, near, options);
  };

  const NewtonResult chain = run(LinearSolver::Chain);
  const NewtonResult lu = run(LinearSolver::Mumps);

  EXPECT_EQ(chain.status, Status::Solved);
  EXPECT_EQ(chain.iterations, lu.iterations);
  EXPECT_GT(chain.chain_steps, 0);
  EXPECT_EQ(chain.determinant_sign, lu.determinant_sign);
  EXPECT_LE(largest_difference(chain.point.x, lu.point.x), kSamePoint);
}

}  // namespace
}  // namespace brachisto::testing
