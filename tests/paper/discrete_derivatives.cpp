// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Exact derivatives of the discrete system, and the two ways of Newton's step.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "paper/discrete_paths.hpp"
#include "paper/newton_steps.hpp"
#include "support/observed_order.hpp"

namespace brachisto {
namespace {

using testing::discrete_cases;
using testing::DiscreteCase;
using testing::kDiscreteNodes;
using testing::observed_order;

/// Taylor's theorem gives 2; the next order shows at the larger distances.
constexpr double kOrderTolerance = 0.1;

DiscreteVariations exact(const DiscreteCase& one) {
  DiscreteReading reading = one.reading;
  reading.epsilon = 0.0;
  return {one.scene, kDiscreteNodes, reading};
}

double norm(const std::vector<double>& v) {
  double sum = 0.0;
  for (const double value : v) sum += value * value;
  return std::sqrt(sum);
}

TEST(DiscreteDerivatives, AreTheLimitOfCentralDifferences) {
  for (DiscreteCase one : discrete_cases()) {
    const DiscreteVariations limit = exact(one);
    const std::vector<double> u = testing::shaken(limit, 2);
    std::vector<double> F(u.size()), G(u.size());
    ASSERT_TRUE(limit.residual(u, F)) << one.name;
    const std::array epsilon{2e-3, 1e-3, 5e-4, 2.5e-4};
    std::array<double, epsilon.size()> error{};

    for (std::size_t i = 0; i < epsilon.size(); ++i) {
      one.reading.epsilon = epsilon[i];
      ASSERT_TRUE(DiscreteVariations(one.scene, kDiscreteNodes, one.reading)
                      .residual(u, G));
      for (std::size_t j = 0; j < u.size(); ++j) G[j] -= F[j];
      error[i] = norm(G);
    }

    EXPECT_NEAR(observed_order(epsilon, error), 2.0, kOrderTolerance)
        << one.name;
  }
}

/// ‖F(u + h step) − (1 − h) F(u)‖ for step = −F'⁻¹ F falls like h².
template <class Step>
void expect_newton_step(const DiscreteCase& one, std::uint32_t seed) {
  const DiscreteVariations system = exact(one);
  const std::vector<double> u = testing::shaken(system, seed);
  std::vector<double> F(u.size()), G(u.size()), step(u.size()), v(u.size());
  ASSERT_TRUE(system.residual(u, F)) << one.name;
  Step newton(system);
  ASSERT_TRUE(newton(u, F, step)) << one.name;
  // Steps are as long as 1/h for the steps of x and z to be small.
  const double unit = 1e-3 / norm(step);
  std::array<double, 4> h{}, error{};

  for (std::size_t i = 0; i < h.size(); ++i) {
    h[i] = unit * std::pow(0.5, static_cast<double>(i));
    for (std::size_t j = 0; j < u.size(); ++j) v[j] = u[j] + h[i] * step[j];
    ASSERT_TRUE(system.residual(v, G)) << one.name;
    for (std::size_t j = 0; j < u.size(); ++j) G[j] -= (1.0 - h[i]) * F[j];
    error[i] = norm(G);
  }

  EXPECT_NEAR(observed_order(h, error), 2.0, kOrderTolerance) << one.name;
}

TEST(DenseNewtonStep, SolvesTheLinearisedSystem) {
  for (const DiscreteCase& one : discrete_cases()) {
    expect_newton_step<paper::DenseNewtonStep>(one, 3);
  }
}

TEST(LiftedNewtonStep, SolvesTheLinearisedSystem) {
  for (const DiscreteCase& one : discrete_cases()) {
    expect_newton_step<paper::LiftedNewtonStep>(one, 4);
  }
}

TEST(LiftedNewtonStep, IsTheDenseOne) {
  // Condition numbers are some 1e3 (2e2 of the base case): 1e-13 of rounding,
  // and room for another matrix and other pivots.
  constexpr double kRelative = 1e-11;
  for (const DiscreteCase& one : discrete_cases()) {
    const DiscreteVariations system = exact(one);
    paper::LiftedNewtonStep lifted(system);
    for (const std::uint32_t seed : {5U, 6U}) {
      const std::vector<double> u = testing::shaken(system, seed);
      std::vector<double> F(u.size()), a(u.size()), b(u.size());
      ASSERT_TRUE(system.residual(u, F)) << one.name;

      ASSERT_TRUE(paper::DenseNewtonStep(system)(u, F, a)) << one.name;
      ASSERT_TRUE(lifted(u, F, b)) << one.name;

      for (std::size_t i = 0; i < a.size(); ++i) b[i] -= a[i];
      EXPECT_LE(norm(b), kRelative * norm(a)) << one.name;
    }
  }
}

TEST(LiftedNewtonStep, TakesLinearMemory) {
  const auto bytes = [](int nodes) {
    DiscreteReading reading;
    reading.epsilon = 0.0;
    const DiscreteVariations system(testing::off_centred_scene(), nodes,
                                    reading);
    const std::vector<double> u = system.cycloid_guess().value();
    std::vector<double> F(u.size()), step(u.size());
    EXPECT_TRUE(system.residual(u, F));
    paper::LiftedNewtonStep lifted(system);
    EXPECT_TRUE(lifted(u, F, step));
    return lifted.memory_bytes();
  };

  // Doubling n doubles it but for what does not depend on n; fill would
  // quadruple it.
  EXPECT_LT(bytes(1600), 2.2 * bytes(800));
}

}  // namespace
}  // namespace brachisto
