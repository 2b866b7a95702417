// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What an extremal is, seen from outside: through the public path alone.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/hamiltonian.hpp"
#include "extremal/scenes.hpp"

namespace brachisto {
namespace {

using testing::base_scene;

/// Positions that are no steps of the integration.
constexpr int kSamples = 97;

class Extremal : public ::testing::TestWithParam<double> {
 protected:
  Extremal() : scene_(base_scene(GetParam())), found_(solve_extremal(scene_)) {}

  [[nodiscard]] Costates costates(const ExtremalState& s) const {
    return {found_.p_x, found_.p_z, s.p_theta, s.p_w};
  }

  Scene scene_;
  ExtremalSolution found_;
};

TEST_P(Extremal, KeepsTheHamiltonianZeroAndMinimal) {
  ASSERT_TRUE(found_.solved()) << found_.message;
  for (int i = 0; i <= kSamples; ++i) {
    const ExtremalState s = found_.path.at(1.0 * i / kSamples);
    const RollingState state{s.theta, s.w};

    const double value =
        hamiltonian(scene_.body, scene_.gravity, state, costates(s), s.beta);
    const SlopeHamiltonian slope = slope_hamiltonian(
        scene_.body, scene_.gravity, state, costates(s), s.beta);

    EXPECT_NEAR(value, 0.0, 1e-12) << "sample " << i;
    EXPECT_NEAR(slope.d_beta, 0.0, 1e-12) << "sample " << i;
    EXPECT_GT(slope.d2_beta, 0.1) << "sample " << i;
    EXPECT_LE(gain_of_other_directions(scene_.body, scene_.gravity, state,
                                       costates(s), s.beta),
              1e-12)
        << "sample " << i;
  }
}

TEST_P(Extremal, ConservesEnergyAndRollsWithoutSlip) {
  ASSERT_TRUE(found_.solved()) << found_.message;
  const ExtremalState start = found_.path.at(0.0);
  for (int i = 0; i <= kSamples; ++i) {
    const ExtremalState s = found_.path.at(1.0 * i / kSamples);

    const double height = energy_height(scene_.body, s.z - start.z, s.theta);

    EXPECT_NEAR(s.w * s.w, 2.0 * scene_.gravity * height, 1e-12)
        << "sample " << i;
  }
  EXPECT_NEAR(found_.rotation * scene_.body.radius, found_.centre_path_length,
              1e-13);
}

TEST_P(Extremal, EndsTransversallyAndTangentially) {
  ASSERT_TRUE(found_.solved()) << found_.message;
  const double r = scene_.body.radius;

  const ExtremalState end = found_.path.at(1.0);

  EXPECT_NEAR(end.p_theta, 0.0, 1e-12);
  EXPECT_NEAR(end.p_w, 0.0, 1e-12);
  EXPECT_NEAR(end.beta, found_.phi, 1e-12);
  EXPECT_NEAR(end.x, scene_.L + r * std::sin(end.beta), 1e-12);
  EXPECT_NEAR(end.z, scene_.H - r * std::cos(end.beta), 1e-12);
  EXPECT_NEAR(end.t, found_.transit_time, 1e-12);
}

TEST_P(Extremal, StartsAtRestInTheDirectionOfTheStartAngle) {
  ASSERT_TRUE(found_.solved()) << found_.message;
  const double r = scene_.body.radius;

  const ExtremalState start = found_.path.at(0.0);

  EXPECT_EQ(start.w, 0.0);
  EXPECT_NEAR(start.beta, found_.start_angle, 1e-12);
  EXPECT_NEAR(start.x, r * std::sin(found_.start_angle), 1e-12);
  EXPECT_NEAR(start.z, -r * std::cos(found_.start_angle), 1e-12);
}

TEST_P(Extremal, PathIsSmoothBetweenTheStepsOfTheIntegration) {
  constexpr double h = 1e-4;
  ASSERT_TRUE(found_.solved()) << found_.message;
  const double U = found_.rolling_time;
  for (int i = 1; i < kSamples; ++i) {
    const double sigma = 1.0 * i / kSamples;
    const ExtremalState before = found_.path.at(sigma - h);
    const ExtremalState here = found_.path.at(sigma);
    const ExtremalState after = found_.path.at(sigma + h);

    // Central differences of x' = w cos β and z' = w sin β: h² U² x'''/6.
    const double dx = (after.x - before.x) / (2.0 * h * U);
    const double dz = (after.z - before.z) / (2.0 * h * U);

    EXPECT_NEAR(dx, here.w * std::cos(here.beta), 1e-5) << "sample " << i;
    EXPECT_NEAR(dz, here.w * std::sin(here.beta), 1e-5) << "sample " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(ThetaM, Extremal,
                         ::testing::Values(-std::numbers::pi / 2.0, 0.0,
                                           std::numbers::pi / 3.0));

TEST(Costate, IsMinusTheGradientOfTheLeastTime) {
  constexpr double h = 1e-4;
  Scene scene = base_scene(-0.3);
  scene.contact = Contact::Centre;
  const auto time = [&](double dx, double dz) {
    Scene other = scene;
    other.L += dx;
    other.H += dz;
    return solve_extremal(other).transit_time;
  };

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  // The error is h² times third derivatives of T, which are of order one.
  EXPECT_NEAR(-found.p_x, (time(h, 0.0) - time(-h, 0.0)) / (2.0 * h), 1e-7);
  EXPECT_NEAR(-found.p_z, (time(0.0, h) - time(0.0, -h)) / (2.0 * h), 1e-7);
}

TEST(SmoothContact, IsTheExtremalBetweenItsOwnFixedCentres) {
  const Scene smooth = base_scene(-0.3);
  const ExtremalSolution answer = solve_extremal(smooth);
  const ExtremalState start = answer.path.at(0.0);
  const ExtremalState end = answer.path.at(1.0);
  Scene fixed = smooth;
  fixed.contact = Contact::Centre;
  fixed.L = end.x - start.x;
  fixed.H = end.z - start.z;

  const ExtremalSolution found = solve_extremal(fixed);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.transit_time / answer.transit_time, 1.0, 1e-13);
  EXPECT_NEAR(found.phi, answer.phi, 1e-12);
}

}  // namespace
}  // namespace brachisto
