// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The fastest orientation is where τ is stationary and smallest.

#include "reproduction/faster_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reproduction/cases.hpp"
#include "reproduction/no_signal.hpp"

namespace brachisto::reproduction {
namespace {

using testing::kNoSignal;

TEST(FastestOrientation, IsStationaryAndAMinimum) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;

  const Orientation found = fastest_orientation(scene, -0.5, kNoSignal);

  EXPECT_LT(found.theta_m.error, 1e-6);
  const auto tau = [&](double offset) {
    scene.body.theta_m = found.theta_m.value + offset;
    return verified_tau(scene, kNoSignal);
  };
  constexpr double h = 0.02;
  const double left = tau(-h);
  const double right = tau(h);
  const double here = tau(0.0);
  EXPECT_LT(here, left);
  EXPECT_LT(here, right);
  EXPECT_NEAR(found.tau, here, 1e-9);
  // A fourth-order difference of the slope vanishes up to h⁴ τ⁗'/30 with τ of
  // order one, and noise of 1e-11 / h: 1e-8 in all; τ'' is about 0.3.
  const double slope =
      (8.0 * (right - left) - (tau(2 * h) - tau(-2 * h))) / (12.0 * h);
  const double bend = (left - 2.0 * here + right) / (h * h);
  EXPECT_NEAR(slope / bend, 0.0, 1e-6);
}

TEST(FastestOrientation, DoesNotDependOnTheGuess) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 0.3, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  const Orientation near = fastest_orientation(scene, -0.5, kNoSignal);
  const Orientation far = fastest_orientation(scene, 0.3, kNoSignal);
  EXPECT_NEAR(near.theta_m.value, far.theta_m.value,
              near.theta_m.error + far.theta_m.error + 1e-8);
}

}  // namespace
}  // namespace brachisto::reproduction
