// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The linearised equations of arcs against the equations themselves.

#include "extremal/arc_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"
#include "model/units.hpp"
#include "support/random_points.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::testing {
namespace {

using arcs::ArcSystem;

constexpr unsigned kSeed = 20260101;
constexpr int kPieces = 3;

/// The cycloid of a scene as a path to start from.
arcs::Guess cycloid_of(const Scene& natural) {
  const ExtremalGuess guess = cycloid_guess(natural);
  arcs::Guess out;
  out.arcs = {{.held = {}, .duration = guess.rolling_time}};
  out.state = [state = guess.state](std::size_t, double share) {
    const ExtremalState s = state(share);
    return arcs::State{s.x,   s.z,   s.theta, s.w,   s.beta,
                       s.p_x, s.p_z, 0.01,    s.p_w, 0.0};
  };
  return out;
}

double distance(const std::vector<ocp::ChainLink>& a,
                const std::vector<ocp::ChainLink>& b, double h,
                const std::vector<Eigen::VectorXd>& slope) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i].residual - b[i].residual - h * slope[i]).lpNorm<1>();
  }
  return sum;
}

void expect_exact_derivatives(const Scene& si) {
  const Scene natural = in_natural_units(si);
  const ArcSystem system(natural, cycloid_of(natural), kPieces);
  ArcSystem::Point point = system.start(), v = point;
  Random random(kSeed);
  for (Eigen::VectorXd& node : v.nodes) {
    for (double& entry : node) entry = random.uniform(-1.0, 1.0);
  }
  for (double& entry : v.globals) entry = random.uniform(-1.0, 1.0);
  ArcSystem::Linearisation here;
  ASSERT_TRUE(system.evaluate(point, {}, here));
  std::vector<Eigen::VectorXd> slope;
  for (std::size_t i = 0; i < here.links.size(); ++i) {
    const ocp::ChainLink& link = here.links[i];
    slope.emplace_back(link.here * v.nodes[i] + link.globals * v.globals);
    if (i + 1 < here.links.size()) slope.back() += link.next * v.nodes[i + 1];
  }
  const auto remainder = [&](double h) {
    ArcSystem::Linearisation there;
    EXPECT_TRUE(system.evaluate(arcs::moved(point, h, v), {}, there, false));
    return distance(there.links, here.links, h, slope);
  };

  const double order = std::log10(remainder(1e-3) / remainder(1e-4));

  EXPECT_NEAR(order, 2.0, 0.05);
}

TEST(ArcSystem, HasTheDerivativesOfItsResidual) {
  expect_exact_derivatives(base_scene(-0.4));
}

TEST(ArcSystem, HasTheDerivativesOfItsResidualInAllOfTheWorld) {
  expect_exact_derivatives(in_air(
      with_push(about_sphere(base_scene(-0.4), around()), 0.7), 0.1, 0.05));
}

/// Residuals with and without derivatives are the same in every digit.
TEST(ArcSystem, TakesTheSameStepsWithoutDerivatives) {
  const Scene natural = in_natural_units(base_scene(-0.4));
  const ArcSystem system(natural, cycloid_of(natural), kPieces);
  ArcSystem::Linearisation with, without;
  ASSERT_TRUE(system.evaluate(system.start(), {}, with));
  ASSERT_TRUE(system.evaluate(system.start(), {}, without, false));

  EXPECT_EQ(with.steps, without.steps);
  for (std::size_t i = 0; i < with.links.size(); ++i) {
    EXPECT_EQ(with.links[i].residual, without.links[i].residual) << i;
  }
}

}  // namespace
}  // namespace brachisto::testing
