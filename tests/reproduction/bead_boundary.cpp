// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Bodies as fast as the bead, against closed forms.

#include "reproduction/faster_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reproduction/no_signal.hpp"

namespace brachisto::reproduction {
namespace {

using testing::kNoSignal;

Scene paper_scene() {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 0.0, -std::numbers::pi / 6.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

TEST(BeadBoundary, OfAUniformCylinderIsInClosedForm) {
  // The uniform cylinder's time grows with √(1 + k). Closed forms at k = 1/2
  // and for the bead, both with 30 digits:
  const double uniform = 5.115100653579787;
  const double bead = 4.510563136746752;
  const double k = 1.5 * std::pow(bead / uniform, 2) - 1.0;

  const auto boundary =
      bead_boundary(paper_scene(), {0.0, 0.98}, false, kNoSignal);

  // Times to 1e-12 relative leave 2 (1 + k) 2e-12 < 5e-12 in k; the iteration
  // stops below 1e-9, which a secant step then has squared.
  ASSERT_EQ(boundary.size(), 2U);
  EXPECT_NEAR(boundary.front().k, k, 1e-11);
}

TEST(BeadBoundary, EndsOnTheRimWithABodyAsFastAsTheBead) {
  const auto boundary =
      bead_boundary(paper_scene(), {0.9, 0.95}, false, kNoSignal);

  const BoundaryBody& last = boundary.back();
  EXPECT_GT(last.eta_m, 0.9);
  EXPECT_LT(last.eta_m, 0.95);
  EXPECT_NEAR(last.k, 1.0 - last.eta_m * last.eta_m, 1e-15);
  Scene scene = paper_scene();
  scene.body.eta_m = last.eta_m;
  scene.body.k = last.k;
  EXPECT_NEAR(verified_tau(scene, kNoSignal), 4.510563136746752, 1e-10);
}

TEST(BeadBoundary, TheFastestOrientationAdmitsMoreInertia) {
  const auto fixed =
      bead_boundary(paper_scene(), {0.9, 0.95}, false, kNoSignal);
  const auto best = bead_boundary(paper_scene(), {0.9, 0.95}, true, kNoSignal);
  EXPECT_GT(best.front().k, fixed.front().k);
}

TEST(BeadBoundary, OnTheRimTooTheOrientationIsTheBest) {
  const auto best = bead_boundary(paper_scene(), {0.9, 0.95}, true, kNoSignal);

  ASSERT_EQ(best.size(), 2U);
  for (const BoundaryBody& body : best) {
    Scene scene = paper_scene();
    scene.body.eta_m = body.eta_m;
    scene.body.k = body.k;
    const auto tau = [&](double offset) {
      scene.body.theta_m = body.theta_m.value + offset;
      return verified_tau(scene, kNoSignal);
    };
    // A fourth-order difference of the slope: its error is h⁴ τ⁗'/30, with τ of
    // order one below 1e-8, and noise of 1e-11 / h below 1e-9.
    constexpr double h = 0.02;
    const double left = tau(-h);
    const double right = tau(h);
    const double slope =
        (8.0 * (right - left) - (tau(2 * h) - tau(-2 * h))) / (12.0 * h);
    const double bend = (left - 2.0 * tau(0.0) + right) / (h * h);
    EXPECT_GT(bend, 0.0);
    EXPECT_NEAR(slope / bend, 0.0, 1e-6) << body.eta_m;
    EXPECT_LT(body.theta_m.error, 1e-6);
    EXPECT_NEAR(tau(0.0), 4.510563136746752, 1e-9);
  }
}

}  // namespace
}  // namespace brachisto::reproduction
