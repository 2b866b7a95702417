// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "brachisto/transcription/arc_contact.hpp"
#include "derivatives/arc_length_problems.hpp"
#include "support/observed_order.hpp"

namespace brachisto::testing {
namespace {

double along(const nlp::SparseVector& rates, const std::vector<double>& d) {
  double sum = 0.0;
  for (std::size_t e = 0; e < rates.index.size(); ++e) {
    sum += rates.value[e] * d[static_cast<std::size_t>(rates.index[e])];
  }
  return sum;
}

std::vector<double> moved(std::vector<double> x, double h,
                          const std::vector<double>& d) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * d[i];
  return x;
}

class ArcContactOf : public ::testing::TestWithParam<ArcLengthCase> {};
INSTANTIATE_TEST_SUITE_P(Bodies, ArcContactOf,
                         ::testing::ValuesIn(arc_length_cases()),
                         [](const auto& row) { return row.param.name; });

TEST_P(ArcContactOf, HasDerivativesOfFirstOrder) {
  // What the linear model leaves falls as h², in x, λ and φ together; the next
  // term bends the slope by a few h.
  constexpr std::array kSteps{0x1p-9, 0x1p-10, 0x1p-11, 0x1p-12, 0x1p-13};
  constexpr double kSlack = 0.1;
  std::array<double, kSteps.size()> remainder{};
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    ArcLength problem(GetParam().scene, 6, -0.2);
    ArcContactEquation contact(problem);
    const std::vector<double> x = random_point(problem, random);
    const std::vector<double> lambda =
        random.vector(problem.num_constraints(), -1.0, 1.0);
    const double phi = random.uniform(-1.0, 1.0);
    const std::vector<double> dx =
        random.vector(problem.num_variables(), -1.0, 1.0);
    const std::vector<double> dl =
        random.vector(problem.num_constraints(), -1.0, 1.0);
    const double dphi = random.uniform(0.5, 1.0);
    contact.set_parameter(phi);
    const nlp::ClosingEquation::Linearisation at = contact.linearise(x, lambda);
    const double rate =
        along(at.by_x, dx) + along(at.by_lambda, dl) + at.by_parameter * dphi;
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      // Far less than the shortest piece.
      const double h = 0.1 * kSteps[i];
      contact.set_parameter(phi + h * dphi);
      const double value =
          contact.linearise(moved(x, h, dx), moved(lambda, h, dl)).residual;
      remainder[i] += std::pow(value - at.residual - h * rate, 2);
    }
  }
  for (double& r : remainder) r = std::sqrt(r);

  EXPECT_NEAR(observed_order(kSteps, remainder), 2.0, kSlack)
      << remainder.front() << " … " << remainder.back();
}

TEST_P(ArcContactOf, MovesTheEndPointAtTheRatesItTells) {
  ArcLength problem(GetParam().scene, 6, -0.2);
  ArcContactEquation contact(problem);
  // Central differences: their error is h²/6 times r.
  constexpr double kStep = 1e-4;
  contact.set_parameter(0.3 + kStep);
  const std::vector<double> after(problem.lower().begin(),
                                  problem.lower().end());
  contact.set_parameter(0.3 - kStep);
  const std::vector<double> before(problem.lower().begin(),
                                   problem.lower().end());
  contact.set_parameter(0.3);
  const nlp::SparseVector& told = contact.fixed_rates();

  for (std::size_t e = 0; e < told.index.size(); ++e) {
    const auto i = static_cast<std::size_t>(told.index[e]);
    EXPECT_NEAR((after[i] - before[i]) / (2.0 * kStep), told.value[e],
                kStep * kStep);
  }
}

}  // namespace
}  // namespace brachisto::testing
