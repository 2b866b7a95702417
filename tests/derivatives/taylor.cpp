// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Values at a distance h against models of first and second order: what a
// correct derivative leaves falls as h² and h³, whatever its size.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "derivatives/problems.hpp"
#include "support/observed_order.hpp"
#include "support/random_points.hpp"

namespace brachisto::testing {
namespace {

/// f, g and their derivatives at one point.
struct Evaluation {
  double f;
  std::vector<double> grad_f, g, jac_g, hess_lag;
};

Evaluation evaluate(RollingTime& problem, const std::vector<double>& x,
                    const std::vector<double>& lambda) {
  Evaluation at_x;
  if (!problem.set_point(x)) {
    ADD_FAILURE() << problem.refusal();
    return at_x;
  }
  at_x.f = problem.eval_f();
  at_x.grad_f.resize(x.size());
  at_x.g.resize(lambda.size());
  at_x.jac_g.resize(problem.jac_g_pattern().num_entries());
  at_x.hess_lag.resize(problem.hess_lag_pattern().num_entries());
  problem.eval_grad_f(at_x.grad_f);
  problem.eval_g(at_x.g);
  problem.eval_jac_g(at_x.jac_g);
  problem.eval_hess_lag(1.0, lambda, at_x.hess_lag);
  return at_x;
}

/// Steps small enough for the next term of the series not to show, and large
/// enough for h³ to stand above rounding.
constexpr std::array kSteps{0x1p-5, 0x1p-6, 0x1p-7, 0x1p-8, 0x1p-9};

/// Relative to the order, the next term bends the slope by a few h.
constexpr double kSlack = 0.15;

class Taylor : public ::testing::TestWithParam<ProblemCase> {
 protected:
  /// Remainders of g and of the Lagrangian per step, root of the sum of their
  /// squares: over rows and, because the coefficient of h³ in one single number
  /// may happen to be small, over several points and directions.
  struct Remainders {
    std::array<double, kSteps.size()> g{}, lagrangian{};
  };

  /// \param start_speed  size of w in the first element; its changes are as
  ///                     small, for w stays positive
  static Remainders remainders(std::uint32_t first_seed, double start_speed) {
    Remainders total;
    for (std::uint32_t seed = first_seed; seed < first_seed + kSeeds; ++seed) {
      add_remainders(seed, start_speed, total);
    }
    for (double& g : total.g) g = std::sqrt(g);
    for (double& l : total.lagrangian) l = std::sqrt(l);
    return total;
  }

 private:
  static constexpr std::uint32_t kSeeds = 10;

  static void add_remainders(std::uint32_t seed, double start_speed,
                             Remainders& squares) {
    Random random(seed);
    RollingTime problem = GetParam().problem();
    const std::vector<double> x = random_point(problem, random, start_speed);
    const std::vector<double> lambda =
        random.vector(problem.num_constraints(), -1.0, 1.0);
    std::vector<double> direction =
        random.vector(problem.num_variables(), -1.0, 1.0);
    for (int n = 0; n <= problem.mesh().degree; ++n) {
      direction[static_cast<std::size_t>(
          problem.layout().state(n, StateComponent::W))] *= start_speed;
    }

    const Evaluation here = evaluate(problem, x, lambda);
    std::vector<double> Jp(lambda.size());
    const auto& jac = problem.jac_g_pattern();
    for (std::size_t e = 0; e < jac.num_entries(); ++e) {
      Jp[static_cast<std::size_t>(jac.rows[e])] +=
          here.jac_g[e] * direction[static_cast<std::size_t>(jac.cols[e])];
    }
    double first = 0.0, second = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      first += here.grad_f[i] * direction[i];
    }
    for (std::size_t i = 0; i < lambda.size(); ++i) first += lambda[i] * Jp[i];
    const auto& hess = problem.hess_lag_pattern();
    for (std::size_t e = 0; e < hess.num_entries(); ++e) {
      const auto row = static_cast<std::size_t>(hess.rows[e]);
      const auto col = static_cast<std::size_t>(hess.cols[e]);
      const double twice = row == col ? 1.0 : 2.0;
      second += twice * here.hess_lag[e] * direction[row] * direction[col];
    }

    for (std::size_t s = 0; s < kSteps.size(); ++s) {
      const double h = kSteps[s];
      std::vector<double> moved = x;
      for (std::size_t i = 0; i < x.size(); ++i) moved[i] += h * direction[i];
      const Evaluation there = evaluate(problem, moved, lambda);
      double change = there.f - here.f;
      for (std::size_t i = 0; i < lambda.size(); ++i) {
        change += lambda[i] * (there.g[i] - here.g[i]);
        squares.g[s] += std::pow(there.g[i] - here.g[i] - h * Jp[i], 2);
      }
      squares.lagrangian[s] +=
          std::pow(change - h * first - 0.5 * h * h * second, 2);
    }
  }
};

TEST_P(Taylor, RemaindersFallAsSquareAndCubeAtRandomPoints) {
  const Remainders remainder = remainders(1, 1.0);

  EXPECT_NEAR(observed_order(kSteps, remainder.g), 2.0, kSlack)
      << "seeds from 1, remainders " << ::testing::PrintToString(remainder.g);
  EXPECT_NEAR(observed_order(kSteps, remainder.lagrangian), 3.0, kSlack)
      << "seeds from 1, remainders "
      << ::testing::PrintToString(remainder.lagrangian);
}

TEST_P(Taylor, RemaindersFallAsSquareAndCubeNextToTheStart) {
  const Remainders remainder = remainders(101, 1e-6);

  EXPECT_NEAR(observed_order(kSteps, remainder.g), 2.0, kSlack)
      << "seeds from 101, remainders " << ::testing::PrintToString(remainder.g);
  EXPECT_NEAR(observed_order(kSteps, remainder.lagrangian), 3.0, kSlack)
      << "seeds from 101, remainders "
      << ::testing::PrintToString(remainder.lagrangian);
}

INSTANTIATE_TEST_SUITE_P(Problems, Taylor,
                         ::testing::ValuesIn(problem_cases(8, 3)),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto::testing
