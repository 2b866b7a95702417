// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>

#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"
#include "model/hamiltonian.hpp"
#include "support/numbers.hpp"

namespace brachisto {
namespace {

using testing::base_scene;
using testing::kPi;
using testing::scene_of;

constexpr double kTolerance = 1e-12;

TEST(ClosedForm, OfTheBeadIsFound) {
  const ExtremalSolution found = solve_extremal(scene_of(Body::bead(), 3.0));

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau, 4.510563136746752, kTolerance);
  EXPECT_NEAR(found.centre_path_length, 3.568103861440848, kTolerance);
  EXPECT_NEAR(found.phi, -0.4550176852636491, kTolerance);
  EXPECT_EQ(found.rotation, 0.0);
}

TEST(ClosedForm, OfTheUniformCylinderIsFound) {
  const Scene scene = scene_of(Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5), 3.0);

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau, 5.115100653579787, kTolerance);
  EXPECT_NEAR(found.centre_path_length, 2.959968909164491, kTolerance);
  EXPECT_NEAR(found.phi, -0.5434543352906646, kTolerance);
  EXPECT_NEAR(found.rotation, 3.0 * found.centre_path_length, kTolerance);
}

TEST(ClosedForm, OfHalfAnArchIsPiTimesARoot) {
  // The centre falls 2 and advances π: T = π √(1 + k)/√g, free of r.
  constexpr double r = 0.2;
  Scene scene = scene_of(Body::cylinder(r, 0.0, 0.3, 0.5), r + kPi);
  scene.H = r + 2.0;

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  const double expected = kPi * std::sqrt(3.0 / (2.0 * scene.gravity));
  EXPECT_NEAR(found.transit_time / expected, 1.0, kTolerance);
  EXPECT_NEAR(found.phi, 0.0, kTolerance);
}

TEST(ClosedForm, BetweenFixedCentresIsTheCycloid) {
  Scene scene = scene_of(Body::cylinder(0.2, 0.0, 0.0, 0.5), kPi);
  scene.H = 2.0;
  scene.contact = Contact::Centre;

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  const double expected = kPi * std::sqrt(3.0 / (2.0 * scene.gravity));
  EXPECT_NEAR(found.transit_time / expected, 1.0, kTolerance);
}

TEST(CycloidGuess, SatisfiesPontryaginsConditionsWithoutOffset) {
  Scene scene = base_scene();
  scene.body.eta_m = 0.0;

  const ExtremalGuess guess = cycloid_guess(scene);

  for (const double sigma : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const ExtremalState s = guess.state(sigma);
    const RollingState state{s.theta, s.w};
    const Costates p{s.p_x, s.p_z, s.p_theta, s.p_w};
    EXPECT_NEAR(hamiltonian(scene.body, scene.gravity, state, p, s.beta), 0.0,
                1e-14);
    EXPECT_NEAR(
        slope_hamiltonian(scene.body, scene.gravity, state, p, s.beta).d_beta,
        0.0, 1e-14);
  }
  EXPECT_NEAR(guess.state(1.0).p_w, 0.0, 1e-15);
}

}  // namespace
}  // namespace brachisto
