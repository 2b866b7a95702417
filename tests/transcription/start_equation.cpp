// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/start_equation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "support/observed_order.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::testing {
namespace {

using Linearisation = nlp::TangencyCondition::Linearisation;

double product(const nlp::SparseVector& row, const std::vector<double>& d) {
  double sum = 0.0;
  for (std::size_t e = 0; e < row.index.size(); ++e) {
    sum += row.value[e] * d[static_cast<std::size_t>(row.index[e])];
  }
  return sum;
}

std::vector<double> stepped(std::vector<double> x, double h,
                            const std::vector<double>& d) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * d[i];
  return x;
}

struct StartCase {
  std::string name;
  Scene scene;
};
std::ostream& operator<<(std::ostream& out, const StartCase& row) {
  return out << row.name;
}

std::vector<StartCase> start_cases() {
  const Scene off_centred = with_push(off_centred_scene(-kPi / 6.0), 1.0);
  Scene between_ends = off_centred;
  between_ends.contact = Contact::Centre;
  std::vector<StartCase> cases{
      {"Uniform", with_push(uniform_scene(), 1.0)},
      {"OffCentred", off_centred},
      {"BetweenEnds", between_ends},
      {"InAirAboutASphere",
       in_air(about_sphere(off_centred, around()), 0.3, 0.2)}};
  for (StartCase& row : cases) row.scene = natural(row.scene);
  return cases;
}

class StartEquationOf : public ::testing::TestWithParam<StartCase> {};
INSTANTIATE_TEST_SUITE_P(Scenes, StartEquationOf,
                         ::testing::ValuesIn(start_cases()),
                         [](const auto& test) { return test.param.name; });

TEST_P(StartEquationOf, HasDerivativesOfFirstOrder) {
  // What the linear model leaves falls as h², in x, λ and α together and in x
  // and α alone; in λ alone F is linear.
  constexpr double kSlack = 0.1;  // the next term bends the slope by a few h
  constexpr std::uint32_t kSeeds = 10;
  enum Part { InX, InLambda, InAlpha, InAll };
  std::array<double, 5> steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = std::ldexp(1.0, -7 - static_cast<int>(i));
  }
  for (const Part part : {InX, InLambda, InAlpha, InAll}) {
    std::array<double, steps.size()> remainder{};
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      Random random(seed);
      RollingTime problem(GetParam().scene, uniform_mesh(3, 2), -0.2);
      StartEquation start(problem);
      const std::vector<double> x = random_point(problem, random);
      const std::vector<double> lambda =
          random.vector(problem.num_constraints(), -1.0, 1.0);
      const double alpha = random.uniform(0.5, 2.0);
      // w stays positive between nodes.
      std::vector<double> dx =
          random.vector(problem.num_variables(), -1.0, 1.0);
      std::vector<double> dl =
          random.vector(problem.num_constraints(), -1.0, 1.0);
      double dalpha = random.uniform(0.5, 1.0);
      if (part == InLambda || part == InAlpha) dx.assign(dx.size(), 0.0);
      if (part == InX || part == InAlpha) dl.assign(dl.size(), 0.0);
      if (part == InX || part == InLambda) dalpha = 0.0;
      start.set_parameter(alpha);
      const Linearisation at = start.linearise(x, lambda);
      const double rate = product(at.by_x, dx) + product(at.by_lambda, dl) +
                          at.by_parameter * dalpha;
      for (std::size_t i = 0; i < steps.size(); ++i) {
        const double h = steps[i];
        start.set_parameter(alpha + h * dalpha);
        const double value =
            start.linearise(stepped(x, h, dx), stepped(lambda, h, dl)).residual;
        remainder[i] += std::pow(value - at.residual - h * rate, 2);
      }
    }
    for (double& r : remainder) r = std::sqrt(r);

    if (part == InLambda) {
      EXPECT_LE(remainder.front(), ulps(1000.0));
    } else {
      EXPECT_NEAR(observed_order(steps, remainder), 2.0, kSlack)
          << "part " << part << ": " << remainder.front() << " … "
          << remainder.back();
    }
  }
}

TEST_P(StartEquationOf, MovesTheStartAtTheRatesItTells) {
  RollingTime problem(GetParam().scene, uniform_mesh(3, 2), -0.2);
  StartEquation start(problem);
  for (const double alpha : {0.3, 1.2, 2.0}) {
    // Central differences: their error is h²/6 times numbers of order one.
    constexpr double kStep = 1e-4;
    const auto values = [&](double at) {
      start.set_parameter(at);
      std::vector<double> out;
      for (int i = 0; i < problem.num_variables(); ++i) {
        out.push_back(problem.variable_range(i).lower);
      }
      return out;
    };
    const std::vector<double> after = values(alpha + kStep);
    const std::vector<double> before = values(alpha - kStep);
    start.set_parameter(alpha);
    std::vector<double> rates(after.size());
    const nlp::SparseVector& told = start.fixed_rates();
    for (std::size_t e = 0; e < told.index.size(); ++e) {
      rates[static_cast<std::size_t>(told.index[e])] = told.value[e];
    }

    for (std::size_t i = 0; i < rates.size(); ++i) {
      if (!problem.variable_range(static_cast<int>(i)).single()) continue;
      EXPECT_NEAR((after[i] - before[i]) / (2.0 * kStep), rates[i],
                  kStep * kStep)
          << problem.variable_name(static_cast<int>(i)) << " at " << alpha;
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
