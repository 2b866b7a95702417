// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/energy.hpp"
#include "model/start_angle.hpp"

namespace brachisto {
namespace {

constexpr double kGravity = 9.81;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scene scene_with_only(const Body& body) {
  Scene scene;
  scene.body = body;
  return scene;
}

PathState leaving(double beta) {
  PathState start;
  start.beta = beta;
  return start;
}

/// The motion a little later on a path β = β₀ + β′ u: w = g a u to the first
/// order.
Kinematics shortly_after(const Body& body, double beta_0, double beta_rate,
                         double u) {
  PathState state;
  state.w = kGravity * energy_slope(body, body.theta_m, beta_0) * u;
  state.theta = body.theta_m + 0.5 * state.w * u / body.radius;
  state.beta = beta_0 + beta_rate * u;
  state.beta_rate = beta_rate;
  return kinematics(body, kGravity, state);
}

TEST(StartLimits, AreWhatTheMotionTendsTo) {
  for (const double theta_m : {-2.9, -0.5, 0.0, 1.2}) {
    for (const double beta_rate : {-3.0, 0.7}) {
      const Body body = Body::cylinder(0.4, 0.7, theta_m, 0.3);
      const double beta_0 = start_angle(body);

      const StartLimits limits = start_limits(body, beta_0, beta_rate);

      EXPECT_EQ(limits.normal_force, 0.0);
      // What is left out is of the next order in u, with constants of some
      // (g/r)^(3/2), 100.
      constexpr double kStep = 1e-7;
      const Kinematics next = shortly_after(body, beta_0, beta_rate, kStep);
      EXPECT_NEAR(next.R_n / kStep, limits.normal_force_rate, 1e-4)
          << "theta_m = " << theta_m << ", beta' = " << beta_rate;
      EXPECT_NEAR(next.kappa_b, limits.curvature, 1e-3);
      EXPECT_EQ(limits.fold_margin, beta_rate > 0.0 ? -kInfinity : kInfinity);
      EXPECT_EQ(std::signbit(next.fold_margin),
                std::signbit(limits.fold_margin));
      EXPECT_EQ(limits.lifts_off(), beta_rate > 0.0);
    }
  }
}

TEST(StartLimits, OfAUniformCylinderAreInClosedForm) {
  // R_n = (2 + k)/(1 + k) sin ψ/2 on a cycloid, on which β = (π − ψ)/2.
  const double k = 0.5;
  const Body body = Body::cylinder(0.25, 0.0, 0.0, k);
  const double psi_rate = 1.7;

  const StartLimits limits =
      start_limits(body, start_angle(body), -0.5 * psi_rate);

  EXPECT_NEAR(limits.normal_force_rate, (2.0 + k) / (1.0 + k) * 0.5 * psi_rate,
              1e-14);
  EXPECT_DOUBLE_EQ(limits.curvature, -4.0);
}

TEST(StartLimits, OfABeadHaveNoBound) {
  const StartLimits limits =
      start_limits(Body::bead(), start_angle(Body::bead()), -1.0);

  EXPECT_EQ(limits.curvature, -kInfinity);
  EXPECT_EQ(limits.fold_margin, 1.0);
  EXPECT_FALSE(limits.lifts_off());
}

TEST(StartLimits, OnAnInclineAreThoseOfAWeightOnIt) {
  // From rest on a straight line at β: R_n = cos β − η cos δ · a/A.
  const Body uniform = Body::cylinder(0.5, 0.0, 0.0, 0.5);
  const Body heavy_in_front = Body::cylinder(0.5, 0.8, 0.0, 0.1);
  const double beta = 0.3;
  const double A = 1.0 + 0.64 + 0.1 + 1.6 * std::sin(beta);
  const double a = std::sin(beta) + 0.8;

  EXPECT_NEAR(
      start_limits_of_curvature(scene_with_only(uniform), leaving(beta), 0.0)
          .normal_force,
      std::cos(beta), 1e-15);
  EXPECT_NEAR(start_limits_of_curvature(scene_with_only(heavy_in_front),
                                        leaving(beta), 0.0)
                  .normal_force,
              std::cos(beta) - 0.8 * std::cos(beta) * a / A, 1e-15);
}

TEST(StartLimits, WithAFiniteCurvatureTheTrackIsAParallelCurve) {
  // A path of radius 2 m about a hump, the track below of radius 1.5 m.
  const StartLimits limits = start_limits_of_curvature(
      scene_with_only(Body::cylinder(0.5, 0.0, 0.0, 0.5)), leaving(0.3), 0.5);

  EXPECT_DOUBLE_EQ(limits.fold_margin, 0.75);
  EXPECT_DOUBLE_EQ(limits.curvature, 1.0 / 1.5);
}

}  // namespace
}  // namespace brachisto
