// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a body's own turns load the track with, against Newton's law.

#include "model/turning_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "model/energy.hpp"

namespace brachisto {
namespace {

double in(std::mt19937& random, double from, double to) {
  return std::uniform_real_distribution<>(from, to)(random);
}

/// R_n by Newton's law at a depth with the mass on a side, on a track that
/// bends by κ.
double load_at(const Scene& scene, double side, double drop, double beta,
               double kappa) {
  const double theta = beta + side * 0.5 * std::numbers::pi;
  const double E = energy_height(scene.body, drop, theta);
  if (!(E >= 0.0)) return std::nan("");  // it does not come there
  const double w = fall_speed(scene.gravity, E);
  return contact_force(
             scene, TurningPoint<double>{0.0, drop, theta, w, beta, kappa * w})
      .normal;
}

TEST(TurningLoad, IsWithinNewtonsLawWhateverTheSlopeAndTheBend) {
  constexpr int kScenes = 200, kPlaces = 200;
  constexpr double kRounding = 1e-10;
  std::mt19937 random(7);
  for (int i = 0; i < kScenes; ++i) {
    Scene scene;
    const double eta = in(random, 0.05, 0.8);
    scene.body = Body::cylinder(in(random, 0.01, 0.1), eta,
                                in(random, -1.5, 1.5), in(random, 0.05, 0.19));
    const double bend = in(random, 0.0, 1.0) * eta / scene.body.radius;
    const double least = in(random, 0.0, 1.0);
    for (int k = 0; k < kPlaces; ++k) {
      const double drop = least + in(random, 0.0, 1.0);
      const double beta = in(random, -1.0, 1.0) * std::numbers::pi;
      const double kappa = in(random, -1.0, 1.0) * bend;
      const double above = load_at(scene, -1.0, drop, beta, kappa);
      const double below = load_at(scene, 1.0, drop, beta, kappa);
      if (std::isfinite(above)) {
        EXPECT_LE(above, 1.0 - turning_load(scene.body, -1.0, least, bend) +
                             kRounding * std::abs(above));
      }
      if (std::isfinite(below)) {
        EXPECT_GE(below, turning_load(scene.body, 1.0, least, bend) - 1.0 -
                             kRounding * std::abs(below));
      }
    }
  }
}

Scene small_body(double radius) {
  Scene scene;
  scene.L = 1.4;
  scene.H = 1.0;
  scene.body = Body::cylinder(radius, 0.66, -0.5, 0.34);
  return scene;
}
bool bears(const Scene& scene) {
  return can_bear_turns(scene, inequalities(scene.body, scene.limits));
}

TEST(TurningLoad, OfASmallBodyIsMoreThanItsWeight) {
  Scene scene = small_body(0.03);
  EXPECT_TRUE(bears(scene));
  scene.limits.friction = 0.6;
  EXPECT_TRUE(bears(scene));  // where valleys may press it down
  scene.limits.curvature.valley = 3.0;
  EXPECT_FALSE(bears(scene));
  scene.limits.friction.reset();
  EXPECT_TRUE(bears(scene));  // a track with two sides holds it
  scene.limits.normal_min = 0.0;
  EXPECT_FALSE(bears(scene));
  scene.world.losses.rolling = 0.02;
  EXPECT_TRUE(bears(scene));  // energy is lost
}

TEST(TurningLoad, IsBoundedFromAboveOnHumps) {
  Scene scene = small_body(0.02);
  scene.limits.normal_max = 3.0;
  EXPECT_TRUE(bears(scene));
  scene.limits.curvature.hump = 3.0;
  EXPECT_FALSE(bears(scene));
}

/// H at which the mass, furthest from the track, takes just the weight: from
/// 1 = (2E/A)(η/r − K), with E at the end of 4 π r less all that a body that
/// starts with its mass at θ_m may be higher there.
TEST(TurningLoad, IsTakenWhereTheBodyHasTurnedAtLatest) {
  constexpr double r = 0.03, eta = 0.66, theta = -0.5, k = 0.34, K = 3.0;
  const double A = (1.0 + eta) * (1.0 + eta) + k;
  const double E = A / (2.0 * (eta / r - K));
  const double turned = 4.0 * std::numbers::pi * r;
  const double lifted = r * eta * (1.0 + std::sin(theta));
  Scene scene = small_body(r);
  scene.limits.normal_min = 0.0;
  scene.limits.curvature.valley = K;
  scene.limits.curvature.of = CurvatureLimit::Of::Centre;
  for (const Contact contact : {Contact::Smooth, Contact::Centre}) {
    scene.contact = contact;
    const double between = contact == Contact::Smooth ? 2.0 * r : 0.0;
    const double H = E + turned + lifted + between;
    scene.H = H * (1.0 - 1e-9);
    EXPECT_TRUE(bears(scene));
    scene.H = H * (1.0 + 1e-9);
    EXPECT_FALSE(bears(scene));
  }
}

TEST(TurningLoad, SaysNothingOfWhatNeedNotTurnOrHasItsMassOnItsAxis) {
  Scene scene = small_body(0.2);
  scene.limits.normal_min = 0.5;
  scene.limits.curvature.valley = 1.0;
  EXPECT_TRUE(bears(scene));
  scene = small_body(0.03);
  scene.body.eta_m = 0.0;
  scene.limits.normal_min = 0.0;
  scene.limits.curvature.valley = 3.0;
  EXPECT_TRUE(bears(scene));
}

}  // namespace
}  // namespace brachisto
