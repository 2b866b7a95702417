// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation on KKT matrices of rolling_time, against dense
// methods and MUMPS.

#include "solvers/chain_ldlt.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "solvers/chain_matrix.hpp"
#include "solvers/small_problem.hpp"
#include "support/refined_solution.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

/// The KKT matrix of a problem at some point: dense in the free unknowns, and
/// the two arrays of values.
struct Kkt {
  std::vector<double> hess, jac;
  std::vector<int> free;  ///< unknowns of the matrix
  Eigen::MatrixXd dense;

  [[nodiscard]] bool factorise(ChainLdlt& ldlt) const {
    const std::array<std::span<const double>, 2> values = {hess, jac};
    return ldlt.factorise(values);
  }
};

Kkt kkt_at(RollingTime& problem, const std::vector<double>& x,
           const std::vector<double>& lambda) {
  EXPECT_TRUE(problem.set_point(x));
  Kkt kkt;
  kkt.hess.resize(problem.hess_lag_pattern().num_entries());
  kkt.jac.resize(problem.jac_g_pattern().num_entries());
  problem.eval_hess_lag(1.0, lambda, kkt.hess);
  problem.eval_jac_g(kkt.jac);
  const int n = problem.num_variables();
  const int size = n + problem.num_constraints();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  const auto add = [&](int i, int j, double value) {
    all(i, j) += value;
    if (i != j) all(j, i) += value;
  };
  for (std::size_t e = 0; e < kkt.hess.size(); ++e) {
    add(problem.hess_lag_pattern()[e].row, problem.hess_lag_pattern()[e].col,
        kkt.hess[e]);
  }
  for (std::size_t e = 0; e < kkt.jac.size(); ++e) {
    add(n + problem.jac_g_pattern()[e].row, problem.jac_g_pattern()[e].col,
        kkt.jac[e]);
  }
  for (int i = 0; i < size; ++i) {
    if (i < n && problem.variable_range(i).single()) continue;
    kkt.free.push_back(i);
  }
  kkt.dense = all(kkt.free, kkt.free);
  return kkt;
}

struct ChainCase {
  Scene scene;
  const char* name;
};

std::vector<ChainCase> chain_cases() {
  return {{natural(bead_scene()), "bead"},
          {natural(uniform_scene()), "uniform"},
          {natural(off_centred_scene(-0.5)), "off-centred"}};
}

TEST(ChainKkt, HasTheInertiaOfTheEigenvaluesAndOfMumps) {
  // Random multipliers: most of these points are no minima.
  int minima = 0;
  int others = 0;
  int by_mumps = 0;
  for (const ChainCase& c : chain_cases()) {
    for (int degree = 1; degree <= 8; ++degree) {
      for (const int elements : {1, 3, 10}) {
        Random random(static_cast<std::uint32_t>(100 * degree + elements));
        RollingTime problem(c.scene, uniform_mesh(degree, elements), 0.2);
        const std::vector<double> x = random_point(problem, random);
        const double size = degree % 2 == 0 ? 1.0 : 0.01;
        const std::vector<double> lambda =
            random.vector(problem.num_constraints(), -size, size);
        const Kkt kkt = kkt_at(problem, x, lambda);
        const auto ldlt =
            make_chain_ldlt(problem, nlp::equations_only(problem));
        ASSERT_NE(ldlt, nullptr);

        ASSERT_TRUE(kkt.factorise(*ldlt));

        const std::string what = std::string(c.name) +
                                 ", p = " + std::to_string(degree) +
                                 ", N = " + std::to_string(elements);
        // What an eigenvalue solver leaves undecided.
        const double blur = static_cast<double>(kkt.dense.rows()) * kRoundoff *
                            kkt.dense.cwiseAbs().rowwise().sum().maxCoeff();
        const Inertia expected = by_eigenvalues(kkt.dense, blur);
        ASSERT_EQ(expected.zero, 0) << what;
        const Inertia mumps =
            kkt_inertia(problem, {x, lambda}, LinearSolver::Mumps);
        EXPECT_EQ(ldlt->inertia().zero, 0) << what;
        EXPECT_EQ(ldlt->inertia().negative, expected.negative) << what;
        EXPECT_EQ(ldlt->inertia().positive, expected.positive) << what;
        // On a few of these random matrices MUMPS runs out of its workspace
        // and says so.
        if (mumps.known) {
          ++by_mumps;
          EXPECT_EQ(ldlt->inertia().negative, mumps.negative) << what;
        }
        const bool minimum = expected.negative == problem.num_constraints();
        ++(minimum ? minima : others);
      }
    }
  }
  EXPECT_GT(others, minima);
  EXPECT_GE(by_mumps, 3 * (minima + others) / 4);
}

TEST(ChainKkt, SolvesToRounding) {
  for (const ChainCase& c : chain_cases()) {
    for (int degree = 1; degree <= 8; ++degree) {
      Random random(static_cast<std::uint32_t>(degree));
      RollingTime problem(c.scene, uniform_mesh(degree, 60 / degree), 0.2);
      const Kkt kkt =
          kkt_at(problem, random_point(problem, random),
                 random.vector(problem.num_constraints(), -0.1, 0.1));
      const auto ldlt = make_chain_ldlt(problem, nlp::equations_only(problem));
      ASSERT_TRUE(kkt.factorise(*ldlt));
      const int size = problem.num_variables() + problem.num_constraints();
      const std::vector<double> b = random.vector(size, -1.0, 1.0);

      const std::vector<double> x = refined_solution(*ldlt, b, 3);

      const auto reduced = [&](const std::vector<double>& v) {
        return Eigen::VectorXd(
            Eigen::Map<const Eigen::VectorXd>(v.data(), size)(kkt.free));
      };
      // As in the tests of ChainLdlt: the rounding of x, and as much again.
      EXPECT_LE(backward_error(kkt.dense, reduced(x), reduced(b)),
                2.0 * kRoundoff)
          << c.name << ", p = " << degree;
    }
  }
}

TEST(ChainKkt, StructureFitsThePatterns) {
  for (const ChainCase& c : chain_cases()) {
    for (int degree = 1; degree <= 8; ++degree) {
      for (const int elements : {1, 2, 3, 17}) {
        const RollingTime problem(c.scene, uniform_mesh(degree, elements), 0.2);
        EXPECT_NE(make_chain_ldlt(problem, nlp::equations_only(problem)),
                  nullptr)
            << c.name << ", p = " << degree << ", N = " << elements;
      }
    }
  }
}

TEST(ChainKkt, OfAProblemThatStatesNoStructureIsNone) {
  const HockSchittkowski7 problem;

  EXPECT_EQ(make_chain_ldlt(problem, nlp::equations_only(problem)), nullptr);
}

TEST(ChainKkt, SeesARankDeficientJacobian) {
  // Without the entries of one constraint its multiplier is free.
  for (const int row : {0, 13, 57, 119}) {
    Random random(5);
    RollingTime problem(natural(off_centred_scene()), uniform_mesh(3, 10), 0.2);
    const auto x = random_point(problem, random);
    const auto lambda = random.vector(problem.num_constraints(), -0.1, 0.1);
    Kkt kkt = kkt_at(problem, x, lambda);
    for (std::size_t e = 0; e < kkt.jac.size(); ++e) {
      if (problem.jac_g_pattern()[e].row == row) kkt.jac[e] = 0.0;
    }
    const auto ldlt = make_chain_ldlt(problem, nlp::equations_only(problem));

    ASSERT_TRUE(kkt.factorise(*ldlt));

    EXPECT_EQ(ldlt->inertia().zero, 1) << "row " << row;
  }
}

}  // namespace
}  // namespace brachisto::testing
