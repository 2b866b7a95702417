// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Values, gradient, Jacobian and Hessian of arc_length problems against jets of
// the formulas written down again; the sparsity against their zeros; no
// allocation.

#include "transcription/arc_length.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "brachisto/math/jet.hpp"
#include "derivatives/arc_length_problems.hpp"
#include "derivatives/counting_new.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

constexpr int kPieces = 5;
constexpr int kMaxVariables = 3 * kPieces + 1;
using Jet = math::Jet2<double, kMaxVariables>;

/// T and the constraints with angles, lengths and times as one would say them:
/// reads the unknowns and writes the constraints in their documented order.
struct Literal {
  Jet f;
  std::vector<Jet> g;

  Literal(const Scene& scene, const std::vector<double>& values) {
    const Body& body = scene.body;
    const bool has_theta = body.eta_m != 0.0;
    const std::size_t stride = has_theta ? 3 : 2;
    std::vector<Jet> v;
    for (std::size_t i = 0; i < values.size(); ++i) {
      v.push_back(Jet::variable(values[i], static_cast<int>(i)));
    }
    const Jet S = v.back();
    const auto sigma = [](int j) { return j / static_cast<double>(kPieces); };
    const auto theta = [&](int j) {
      const Jet turned =
          j == 0 ? Jet(0.0) : v[static_cast<std::size_t>(j - 1) * stride + 2];
      return Jet(body.theta_m) + turned;
    };
    const auto coordinate = [&](int j, std::size_t which) {
      return j == 0 ? Jet(0.0)
                    : v[static_cast<std::size_t>(j - 1) * stride + which];
    };
    const auto speed = [&](int j) {
      Jet E = coordinate(j, 1);
      if (has_theta) {
        E += body.radius * body.eta_m *
             (sin(theta(j)) - Jet(std::sin(body.theta_m)));
      }
      return sqrt(2.0 * scene.gravity * E);
    };
    for (int j = 1; j <= kPieces; ++j) {
      const Jet dx = coordinate(j, 0) - coordinate(j - 1, 0);
      const Jet dz = coordinate(j, 1) - coordinate(j - 1, 1);
      const double share = sigma(j) * sigma(j) - sigma(j - 1) * sigma(j - 1);
      Jet length = share * S;
      Jet A(1.0 + body.k);
      if (has_theta) {
        length = body.radius * (theta(j) - theta(j - 1));
        const double middle = 0.5 * (sigma(j) + sigma(j - 1));
        const double t =
            (middle * middle - sigma(j - 1) * sigma(j - 1)) / share;
        const Jet between = (1.0 - t) * theta(j - 1) + t * theta(j);
        A = Jet(1.0 + body.eta_m * body.eta_m + body.k) -
            2.0 * body.eta_m *
                (sin(between) * (dx / length) - cos(between) * (dz / length));
      }
      const Jet before = j == 1 ? Jet(0.0) : speed(j - 1);
      f += length * sqrt(A) / (0.5 * (before + speed(j)));
      const double straight = std::hypot(scene.L, scene.H) * share;
      g.push_back((dx * dx + dz * dz - length * length) / Jet(2.0 * straight));
      if (has_theta) {
        g.push_back(body.radius * (theta(j) - Jet(body.theta_m)) -
                    S * Jet(sigma(j) * sigma(j)));
      }
    }
  }
};

/// Rounding of entries that are sums of a dozen products; the largest entry of
/// a matrix is the size of the terms.
double rounding(double size) {
  return ulps(64.0, 1.0 + size);
}

class ArcLengthDerivatives : public ::testing::TestWithParam<ArcLengthCase> {};
INSTANTIATE_TEST_SUITE_P(Bodies, ArcLengthDerivatives,
                         ::testing::ValuesIn(arc_length_cases()),
                         [](const auto& row) { return row.param.name; });

TEST_P(ArcLengthDerivatives, AreThoseOfTheFormulasAndFillThePattern) {
  ArcLength problem(GetParam().scene, kPieces, -0.2);
  const int n = problem.num_variables(), m = problem.num_constraints();
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const std::vector<double> x = random_point(problem, random);
    const std::vector<double> lambda = random.vector(m, -1.0, 1.0);
    const double factor = random.uniform(0.5, 1.5);
    ASSERT_TRUE(problem.set_point(x)) << problem.refusal();

    const Literal literal(GetParam().scene, x);

    EXPECT_NEAR(problem.eval_f(), literal.f.value, rounding(literal.f.value));
    std::vector<double> grad(x.size()), g(lambda.size());
    std::vector<double> jac(problem.jac_g_pattern().num_entries());
    std::vector<double> hess(problem.hess_lag_pattern().num_entries());
    problem.eval_grad_f(grad);
    problem.eval_g(g);
    problem.eval_jac_g(jac);
    problem.eval_hess_lag(factor, lambda, hess);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(m, n);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t e = 0; e < jac.size(); ++e) {
      J(problem.jac_g_pattern()[e].row, problem.jac_g_pattern()[e].col) +=
          jac[e];
    }
    for (std::size_t e = 0; e < hess.size(); ++e) {
      ASSERT_GE(problem.hess_lag_pattern()[e].row,
                problem.hess_lag_pattern()[e].col);
      H(problem.hess_lag_pattern()[e].row, problem.hess_lag_pattern()[e].col) +=
          hess[e];
    }
    ASSERT_EQ(literal.g.size(), g.size());
    Jet lagrangian = factor * literal.f;
    double largest = 1.0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      EXPECT_NEAR(g[i], literal.g[i].value, rounding(4.0))
          << problem.constraint_name(static_cast<int>(i));
      lagrangian += lambda[i] * literal.g[i];
      for (int c = 0; c < n; ++c) {
        const double expected =
            literal.g[i].gradient[static_cast<std::size_t>(c)];
        EXPECT_NEAR(J(static_cast<int>(i), c), expected, rounding(10.0))
            << problem.constraint_name(static_cast<int>(i)) << " by "
            << problem.variable_name(c);
      }
    }
    for (const double h : lagrangian.hessian) {
      largest = std::max(largest, std::abs(h));
    }
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_NEAR(grad[at], literal.f.gradient[at], rounding(10.0))
          << problem.variable_name(i);
      for (int c = 0; c <= i; ++c) {
        EXPECT_NEAR(H(i, c), lagrangian.hessian[Jet::pair(i, c)],
                    rounding(largest))
            << problem.variable_name(i) << " and " << problem.variable_name(c);
      }
    }
  }
}

TEST_P(ArcLengthDerivatives, AreEvaluatedWithoutAllocation) {
  ArcLength problem(GetParam().scene, kPieces, -0.2);
  Random random(1);
  const std::vector<double> x = random_point(problem, random);
  const std::vector<double> lambda =
      random.vector(problem.num_constraints(), -1.0, 1.0);
  std::vector<double> grad(x.size()), g(lambda.size());
  std::vector<double> jac(problem.jac_g_pattern().num_entries());
  std::vector<double> hess(problem.hess_lag_pattern().num_entries());
  const long before = num_allocations();

  const bool evaluable = problem.set_point(x);
  const double f = evaluable ? problem.eval_f() : 0.0;
  problem.eval_grad_f(grad);
  problem.eval_g(g);
  problem.eval_jac_g(jac);
  problem.eval_hess_lag(1.0, lambda, hess);

  EXPECT_EQ(num_allocations() - before, 0);
  EXPECT_GT(f, 0.0);
}

TEST_P(ArcLengthDerivatives, ARefusalNamesItsReasonAndNode) {
  ArcLength problem(GetParam().scene, kPieces, -0.2);
  Random random(1);
  std::vector<double> x = random_point(problem, random);
  x[static_cast<std::size_t>(problem.layout().state(3, StateComponent::Z))] =
      -5.0;

  EXPECT_FALSE(problem.set_point(x));
  EXPECT_EQ(problem.refusal(), "the energy E is not positive at node 3 of 5");

  x = random_point(problem, random);
  x.back() = -1.0;

  EXPECT_FALSE(problem.set_point(x));
  EXPECT_EQ(problem.refusal(), "the arc length S is not positive");
}

}  // namespace
}  // namespace brachisto::testing
