// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation on KKT matrices of limited_time, with limits as
// equations and as inequalities, against dense methods, MUMPS and KLU.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "brachisto/solvers/program_solvers.hpp"
#include "nlp/active_set.hpp"
#include "solvers/bordered_chain.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/chain_matrix.hpp"
#include "solvers/inertia.hpp"
#include "solvers/kkt_system.hpp"
#include "solvers/sparse_lu.hpp"
#include "support/limited_answer.hpp"
#include "support/limited_problems.hpp"

namespace brachisto::testing {
namespace {

constexpr const char* kRows[] = {"friction_0.6", "floor_0.9", "optimal_K2"};

TEST(LimitedKkt, OfAnswersHasTheInertiaOfAMinimumByChainAndMumps) {
  for (const char* name : kRows) {
    const LimitedCurve curve = solved_curve(limited_reference(name).scene);
    LimitedTime fitted = curve.problem();
    const nlp::ActiveSet active = nlp::active_set(fitted, curve.point());

    const Inertia chain =
        kkt_inertia(fitted, curve.point(), LinearSolver::Chain);
    const Inertia mumps =
        kkt_inertia(fitted, curve.point(), LinearSolver::Mumps);

    ASSERT_TRUE(chain.known && mumps.known) << name;
    EXPECT_EQ(chain.positive, active.num_free()) << name;
    EXPECT_EQ(chain.negative, active.num_equations()) << name;
    EXPECT_EQ(chain.zero, 0) << name;
    EXPECT_EQ(mumps.positive, chain.positive) << name;
    EXPECT_EQ(mumps.negative, chain.negative) << name;
    EXPECT_EQ(mumps.zero, chain.zero) << name;
  }
}

/// Steps of Newton's method by the bordered chain and by KLU. Both refine with
/// residuals in long double, so that each residual is of the rounding of its
/// solution; the matrices on these meshes have inverses below 1e6.
TEST(LimitedKkt, OfAnswersIsSolvedAsByKlu) {
  for (const char* name : {"friction_1", "floor_0.9", "uniform_floor_1.1"}) {
    const LimitedCurve curve = solved_curve(limited_reference(name).scene);
    LimitedTime fitted = curve.problem();
    KktSystem system(fitted, nullptr, nlp::active_set(fitted, curve.point()));
    ASSERT_TRUE(system.evaluate(curve.point().x, curve.point().lambda, 0.0));
    system.evaluate_jacobian();
    Random random(1);
    const std::vector<double> b = random.vector(system.size(), -1.0, 1.0);
    std::vector<double> by_chain(b.size());
    auto chain = BorderedChain::make(system);
    SparseLu lu(system.pattern(), system.elimination_order());
    std::vector<double> values;
    system.jacobian(values);

    ASSERT_TRUE(chain && chain->factorise()) << name;
    ASSERT_TRUE(chain->solve(b, by_chain)) << name;
    ASSERT_TRUE(lu.factorise(values)) << name;
    const std::vector<double> by_klu = lu.solve(b);

    double size = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i) {
      size = std::max(size, std::abs(by_klu[i]));
      difference = std::max(difference, std::abs(by_klu[i] - by_chain[i]));
    }
    EXPECT_LE(difference, 1e6 * kRoundoff * size) << name;
    EXPECT_EQ(chain->determinant_sign(), lu.determinant_sign()) << name;
  }
}

/// With multipliers of any sign, each limit held on one element; most of these
/// points are no minima. Limits of places on elements side by side would give
/// more equations than there are unknowns.
TEST(LimitedKkt, AtRandomPointsHasTheInertiaOfTheEigenvalues) {
  int minima = 0, others = 0, by_mumps = 0;
  for (const Scene& scene : {natural(bead_scene()), natural(uniform_scene()),
                             natural(off_centred_scene(-0.5))}) {
    const auto limits = limits_of_all_kinds(scene.body);
    for (const int degree : {2, 3}) {
      for (const bool free : {false, true}) {
        const Mesh mesh = uniform_mesh(degree, 17);
        LimitedEnds ends;
        ends.phi = -0.2;
        ends.free_contacts = free;
        LimitedTime problem(scene, limits, mesh, ends,
                            held_in_turn(mesh, limits, 1));
        Random random(static_cast<std::uint32_t>(10 * degree + free));
        const double size = degree == 3 ? 1.0 : 0.01;
        const PrimalDual point{
            random_point(problem, random),
            random.vector(problem.num_constraints(), -size, size),
            {},
            {}};
        const nlp::ActiveSet active = nlp::active_set(problem, point);
        const std::string what = std::to_string(degree) + ", " +
                                 std::to_string(free) + ", r " +
                                 std::to_string(scene.body.radius);
        ASSERT_TRUE(problem.set_point(point.x));
        std::vector<double> hess(problem.hess_lag_pattern().num_entries());
        std::vector<double> jac(problem.jac_g_pattern().num_entries());
        problem.eval_hess_lag(1.0, point.lambda, hess);
        problem.eval_jac_g(jac);
        const int n = problem.num_variables();
        const int all = n + problem.num_constraints();
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(all, all);
        const auto add = [&](int i, int j, double value) {
          K(i, j) += value;
          if (i != j) K(j, i) += value;
        };
        for (std::size_t e = 0; e < hess.size(); ++e) {
          add(problem.hess_lag_pattern()[e].row,
              problem.hess_lag_pattern()[e].col, hess[e]);
        }
        for (std::size_t e = 0; e < jac.size(); ++e) {
          add(n + problem.jac_g_pattern()[e].row,
              problem.jac_g_pattern()[e].col, jac[e]);
        }
        std::vector<int> kept;
        for (int i = 0; i < all; ++i) {
          const auto u = static_cast<std::size_t>(i);
          const bool in =
              i < n ? active.variables[u] == nlp::Held::No
                    : active.constraints[u - static_cast<std::size_t>(n)] !=
                          nlp::Held::No;
          if (in) kept.push_back(i);
        }
        const Eigen::MatrixXd dense = K(kept, kept);
        const double blur = static_cast<double>(dense.rows()) * kRoundoff *
                            dense.cwiseAbs().rowwise().sum().maxCoeff();
        const Inertia expected = by_eigenvalues(dense, blur);
        ASSERT_EQ(expected.zero, 0) << what;

        const Inertia chain = kkt_inertia(problem, point, LinearSolver::Chain);
        const Inertia mumps = kkt_inertia(problem, point, LinearSolver::Mumps);

        ASSERT_TRUE(chain.known) << what;
        EXPECT_EQ(chain.positive, expected.positive) << what;
        EXPECT_EQ(chain.negative, expected.negative) << what;
        EXPECT_EQ(chain.zero, 0) << what;
        if (mumps.known) {
          ++by_mumps;
          EXPECT_EQ(mumps.negative, expected.negative) << what;
        }
        ++(expected.negative == active.num_equations() ? minima : others);
      }
    }
  }
  EXPECT_GT(others, minima);
  EXPECT_GE(by_mumps, 3 * (minima + others) / 4);
}

/// Limits as inequalities: Ipopt, started on the answer of fixed contacts that
/// follow from it, with either solver of its linear systems.
TEST(LimitedKkt, OfInequalitiesLeadsIpoptToTheSamePointAsMumps) {
  // Complementarity of 1e-10 leaves its square root between two points where a
  // multiplier and its slack vanish together, at junctions.
  constexpr double kSamePoint = 1e-5, kSameTime = 1e-8;
  for (const char* name : {"valley_2", "optimal_K2", "uniform_friction_0.5"}) {
    const LimitedCurve curve = solved_curve(limited_reference(name).scene);
    LimitedTime problem(curve.problem().scene(), curve.problem().limits(),
                        uniform_mesh(4, 24), curve.problem().ends());
    const PrimalDual start = prolong(curve, problem);
    IpoptOptions options;
    options.tolerance = 1e-8;
    options.complementarity = 1e-10;
    options.max_iterations = 300;
    const auto run = [&](LinearSolver solver) {
      options.linear_solver = solver;
      return solve_with_ipopt(problem, start, options);
    };

    const SolverResult chain = run(LinearSolver::Chain);
    const SolverResult mumps = run(LinearSolver::Mumps);

    ASSERT_EQ(chain.status, Status::Solved) << name << ": " << chain.message;
    ASSERT_EQ(mumps.status, Status::Solved) << name << ": " << mumps.message;
    EXPECT_EQ(chain.linear_solver, LinearSolver::Chain);
    EXPECT_EQ(mumps.linear_solver, LinearSolver::Mumps);
    double difference = 0.0;
    for (std::size_t i = 0; i < chain.point.x.size(); ++i) {
      difference =
          std::max(difference, std::abs(chain.point.x[i] - mumps.point.x[i]));
    }
    EXPECT_LE(difference, kSamePoint) << name;
    ASSERT_TRUE(problem.set_point(chain.point.x));
    const double T = problem.eval_f();
    ASSERT_TRUE(problem.set_point(mumps.point.x));
    EXPECT_NEAR(problem.eval_f(), T, kSameTime) << name;
    const Inertia one = kkt_inertia(problem, chain.point, LinearSolver::Chain);
    const Inertia other =
        kkt_inertia(problem, chain.point, LinearSolver::Mumps);
    ASSERT_TRUE(one.known && other.known) << name;
    EXPECT_EQ(one.positive, other.positive) << name;
    EXPECT_EQ(one.negative, other.negative) << name;
  }
}

}  // namespace
}  // namespace brachisto::testing
