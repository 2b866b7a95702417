// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Hamilton's equations in other worlds.

#include "extremal/world_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/units.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::testing {
namespace {

using namespace worlds;

Scene all_of_them() {
  return in_natural_units(
      in_air(with_push(about_sphere(off_centred_scene(0.4), around()), 0.7),
             0.1, 0.05));
}
const State kState{0.1, 0.2, 0.5, 0.6, -0.8, 0.1, 0.02, -0.9};

TEST(WorldFlow, KeepsTheHamiltonian) {
  const Scene scene = all_of_them();
  const WorldFlow flow(scene);
  double beta = 0.8;
  PhaseJet before, after;
  ASSERT_TRUE(flow.find_slope(kState, beta, before));
  ArcEnd end;
  double step = 0.0;

  ASSERT_TRUE(integrate_arc(flow, kState, beta, 0.7, {}, step, end));

  ASSERT_TRUE(flow.find_slope(end.y, end.beta, after));
  // Steps of 1e-13 each.
  EXPECT_NEAR(after.value, before.value, 1e-11);
}

void expect_derivatives_of_its_arcs(const Scene& scene) {
  const WorldFlow flow(scene);
  constexpr double h = 1e-5;
  ArcEnd end;
  double step = 0.0;
  ASSERT_TRUE(integrate_arc(flow, kState, 0.8, 0.7, {}, step, end));

  for (std::size_t j = 0; j < kSize; ++j) {
    ArcEnd more, less;
    State moved = kState;
    moved[j] += h;
    ASSERT_TRUE(integrate_arc(flow, moved, 0.8, 0.7, {}, step, more));
    moved[j] -= 2.0 * h;
    ASSERT_TRUE(integrate_arc(flow, moved, 0.8, 0.7, {}, step, less));
    const auto column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i < kSize; ++i) {
      const double difference = (more.y[i] - less.y[i]) / (2.0 * h);
      // h² times third derivatives of some hundred.
      EXPECT_NEAR(end.by_start(static_cast<Eigen::Index>(i), column),
                  difference, 1e-7 * (1.0 + std::abs(difference)))
          << i << " by " << j;
    }
    EXPECT_NEAR(end.time_by_start(column), (more.t - less.t) / (2.0 * h), 1e-7);
  }
}

TEST(WorldFlow, HasTheDerivativesOfItsArcs) {
  expect_derivatives_of_its_arcs(all_of_them());
}

/// The costates' rates jump where a surface is passed, and a neighbour passes
/// it sooner or later.
TEST(WorldFlow, HasTheDerivativesOfArcsThroughASurface) {
  Scene scene = all_of_them();
  const auto height_at_end = [&] {
    ArcEnd end;
    double step = 0.0;
    const WorldFlow flow(scene);
    EXPECT_TRUE(integrate_arc(flow, kState, 0.8, 0.7, {}, step, end));
    return flow.height(end.y);
  };
  // The surface lies half-way between the heights of its ends.
  scene.world.sphere->radius +=
      0.5 * (WorldFlow(scene).height(kState) + height_at_end());
  ASSERT_LT(WorldFlow(scene).height(kState) * height_at_end(), 0.0);

  expect_derivatives_of_its_arcs(scene);
}

}  // namespace
}  // namespace brachisto::testing
