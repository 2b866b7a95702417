// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/contact_equation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "derivatives/arc_length_problems.hpp"
#include "derivatives/problems.hpp"
#include "support/observed_order.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"

namespace brachisto::testing {
namespace {

using Linearisation = nlp::TangencyCondition::Linearisation;

/// Σ rate_i d_i over the nonzeros.
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

/// A transcription and where it is defined.
struct ContactCase {
  std::string name;
  std::function<std::unique_ptr<Transcription>()> problem;
  std::function<std::vector<double>(const Transcription&, Random&)> point;
  bool linear_in_x;  ///< F without θ, w being an unknown
  double step;       ///< short of where the next term matters
};

std::ostream& operator<<(std::ostream& out, const ContactCase& row) {
  return out << row.name;
}

std::vector<ContactCase> contact_cases() {
  std::vector<ContactCase> cases;
  for (const ProblemCase& row : problem_cases(3, 2)) {
    cases.push_back(
        {row.name,
         [row] { return std::make_unique<RollingTime>(row.problem()); },
         [](const Transcription& problem, Random& random) {
           return random_point(dynamic_cast<const RollingTime&>(problem),
                               random);
         },
         !row.problem().layout().has_theta() && !row.scene.world.sphere,
         0x1p-5});
  }
  // Far less than the shortest piece.
  constexpr double kShort = 0.1 * 0x1p-9;
  for (const ArcLengthCase& row : arc_length_cases()) {
    cases.push_back(
        {"Pieces" + row.name,
         [row] { return std::make_unique<ArcLength>(row.scene, 6, -0.2); },
         [](const Transcription& problem, Random& random) {
           return random_point(dynamic_cast<const ArcLength&>(problem), random);
         },
         false, kShort});
  }
  return cases;
}

class ContactEquationOf : public ::testing::TestWithParam<ContactCase> {};
INSTANTIATE_TEST_SUITE_P(Bodies, ContactEquationOf,
                         ::testing::ValuesIn(contact_cases()),
                         [](const auto& test) { return test.param.name; });

TEST_P(ContactEquationOf, EveryProblemHasDerivativesOfFirstOrder) {
  // What the linear model leaves falls as h², in x, λ and φ together, and in
  // each alone.
  constexpr double kSlack = 0.1;  // the next term bends the slope by a few h
  constexpr std::uint32_t kSeeds = 10;
  std::array<double, 5> steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = std::ldexp(GetParam().step, -static_cast<int>(i));
  }
  for (int part = 0; part < 4; ++part) {
    // F is linear in λ and, without θ, in x alone: nothing is left to fall.
    const bool linear = part == 1 || (part == 0 && GetParam().linear_in_x);
    std::array<double, steps.size()> remainder{};
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      Random random(seed);
      const auto problem = GetParam().problem();
      ContactEquation contact(*problem);
      const std::vector<double> x = GetParam().point(*problem, random);
      const std::vector<double> lambda =
          random.vector(problem->num_constraints(), -1.0, 1.0);
      const double phi = random.uniform(-1.0, 1.0);
      std::vector<double> dx = random.vector(problem->num_variables(), -1., 1.);
      std::vector<double> dl =
          random.vector(problem->num_constraints(), -1.0, 1.0);
      double dphi = random.uniform(0.5, 1.0);
      if (part == 1 || part == 2) std::fill(dx.begin(), dx.end(), 0.0);
      if (part == 0 || part == 2) std::fill(dl.begin(), dl.end(), 0.0);
      if (part == 0 || part == 1) dphi = 0.0;
      contact.set_parameter(phi);
      const Linearisation at = contact.linearise(x, lambda);
      const double rate =
          along(at.by_x, dx) + along(at.by_lambda, dl) + at.by_parameter * dphi;
      for (std::size_t i = 0; i < steps.size(); ++i) {
        const double h = steps[i];
        contact.set_parameter(phi + h * dphi);
        const double value =
            contact.linearise(moved(x, h, dx), moved(lambda, h, dl)).residual;
        remainder[i] += std::pow(value - at.residual - h * rate, 2);
      }
    }
    for (double& r : remainder) r = std::sqrt(r);

    if (linear) {
      EXPECT_LE(remainder.front(), ulps(1000.0)) << "part " << part;
    } else {
      EXPECT_NEAR(observed_order(steps, remainder), 2.0, kSlack)
          << "part " << part << ": " << remainder.front() << " … "
          << remainder.back();
    }
  }
}

TEST_P(ContactEquationOf, EveryProblemMovesItsEndPointAtTheRatesItTells) {
  const auto problem = GetParam().problem();
  ContactEquation contact(*problem);
  for (const double phi : {-1.2, -0.3, 0.0, 0.9}) {
    // Central differences: their error is h²/6 times r.
    constexpr double kStep = 1e-4;
    const auto values = [&](double at) {
      contact.set_parameter(at);
      std::vector<double> out;
      for (int i = 0; i < problem->num_variables(); ++i) {
        out.push_back(problem->variable_range(i).lower);
      }
      return out;
    };
    const std::vector<double> after = values(phi + kStep);
    const std::vector<double> before = values(phi - kStep);
    contact.set_parameter(phi);
    std::vector<double> rates(after.size());
    const nlp::SparseVector& told = contact.fixed_rates();
    for (std::size_t e = 0; e < told.index.size(); ++e) {
      rates[static_cast<std::size_t>(told.index[e])] = told.value[e];
    }

    for (std::size_t i = 0; i < rates.size(); ++i) {
      if (!problem->variable_range(static_cast<int>(i)).single()) continue;
      EXPECT_NEAR((after[i] - before[i]) / (2.0 * kStep), rates[i],
                  kStep * kStep)
          << problem->variable_name(static_cast<int>(i)) << " at phi = " << phi;
    }
  }
}

TEST(ContactEquation, VanishesWhereTheEndSlopeReproducesItself) {
  // F is ∂𝓗/∂β at φ and β_end its root next to φ: F = 0 iff β_end = φ, and F
  // to first order ∂²𝓗/∂β² (φ − β_end).
  const Scene scene = natural(off_centred_scene());
  for (const double phi : {-0.1, 0.05}) {
    SolvedProblem solution = solved(scene, uniform_mesh(4, 12), phi);
    ContactEquation contact(solution.problem);
    const double slope =
        solution.problem.end_slope(solution.point.x, solution.point.lambda);

    contact.set_parameter(phi);
    const Linearisation open =
        contact.linearise(solution.point.x, solution.point.lambda);
    contact.set_parameter(slope);
    const Linearisation at_slope =
        contact.linearise(solution.point.x, solution.point.lambda);

    EXPECT_NEAR(at_slope.residual, 0.0, ulps(100.0)) << phi;
    EXPECT_GT(at_slope.by_parameter, 0.0) << phi;
    EXPECT_GT(open.residual * (phi - slope), 0.0) << phi;
  }
}

}  // namespace
}  // namespace brachisto::testing
