// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A ball on two rails or in a groove: where it touches by plain geometry, and
// its forces by Newton's and Euler's laws in space, with two contacts.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "brachisto/model/kinematics.hpp"
#include "brachisto/model/scene.hpp"
#include "model/field.hpp"
#include "model/moving.hpp"
#include "model/path_inequality.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

constexpr double kGeometryRounding = 1e-14;

Ball on_thin_rails(double R, double gauge) {
  return {.radius = R, .k = 0.4, .gauge = gauge};
}
Ball on_round_rails(double R, double gauge, double rail_radius) {
  return {.radius = R, .k = 0.4, .gauge = gauge, .rail_radius = rail_radius};
}
Ball in_a_groove(double R, double angle) {
  return {.radius = R, .k = 0.4, .groove = angle};
}

/// The ball 25 mm across whose edges are 15 mm apart, a triangle of 3, 4 and 5.
TEST(BallOnThinRails, RollsOnItsDistanceFromTheirEdges) {
  const Body body = Body::rolling_ball(on_thin_rails(0.0125, 0.015), 0.3);

  EXPECT_NEAR(body.radius, 0.01, kGeometryRounding);
  EXPECT_NEAR(body.k, 0.625, kGeometryRounding);
  EXPECT_NEAR(body.wall_ratio, 1.25, kGeometryRounding);
  EXPECT_NEAR(body.outer_radius(), 0.0125, kGeometryRounding);
  EXPECT_EQ(body.folding_distance(), body.radius);
  EXPECT_EQ(body.theta_m, 0.3);
  EXPECT_TRUE(body.rolls());
}

/// The contact lies on the line from the centre to the axis of a rail, R away.
TEST(BallOnRoundRails, TouchesThemOnTheWayToTheirAxes) {
  const double R = 0.8, rho = 0.35, gauge = 1.1;
  const Eigen::Vector2d axis(
      0.5 * gauge, std::sqrt((R + rho) * (R + rho) - 0.25 * gauge * gauge));
  const Eigen::Vector2d contact = R * axis.normalized();

  const Ball ball = on_round_rails(R, gauge, rho);

  EXPECT_NEAR(ball.rolling_radius(), contact.y(), kGeometryRounding);
  EXPECT_NEAR(ball.folding_distance(), axis.y(), kGeometryRounding);
  // Thin rails where the contacts are do the same.
  EXPECT_NEAR(ball.rolling_radius(),
              on_thin_rails(R, 2.0 * contact.x()).rolling_radius(),
              kGeometryRounding);
}

/// The contact is the foot of the perpendicular on a wall.
TEST(BallInAGroove, TouchesItsWallsAtTheFeetOfPerpendiculars) {
  const double R = 0.8, gamma = 0.6;
  const Ball ball = in_a_groove(R, 2.0 * gamma);
  const double bottom = ball.folding_distance();
  const Eigen::Vector2d wall(std::sin(gamma), -std::cos(gamma));  // upwards
  const Eigen::Vector2d at_bottom(0.0, bottom);

  const Eigen::Vector2d foot = at_bottom - at_bottom.dot(wall) * wall;

  EXPECT_NEAR(foot.norm(), R, kGeometryRounding);
  EXPECT_NEAR(ball.rolling_radius(), foot.y(), kGeometryRounding);
}

TEST(BallOnAPlainTrack, IsACylinderOfItsRadius) {
  const Body body = Body::rolling_ball({.radius = 0.3, .k = 0.4}, 0.0);

  EXPECT_EQ(body.radius, 0.3);
  EXPECT_EQ(body.k, 0.4);
  EXPECT_EQ(body.wall_ratio, 1.0);
}

/// Each wall's forces, per mass.
struct LawsInSpace {
  double v_dot, across, along;
};

/// The laws in space: x to the right, z down, y = x × z across the track. The
/// walls touch at R n_i from the centre, with n_i = (−r_e n ± h y)/R, and press
/// with N each along −n_i and grip with T each along t. A wall resists rolling
/// with the moment c R N, as a plane does the ball that rolls on it, along the
/// part of the rotation in its own plane, y − (y·n_i) n_i.
LawsInSpace by_laws_in_space(const Scene& scene, const Moving& at) {
  using Vector = Eigen::Vector3d;
  const Ball& ball = *scene.body.ball;
  const double R = ball.radius, r_m = R * ball.eta_m;
  const double h = ball.groove ? R * std::cos(0.5 * *ball.groove)
                               : 0.5 * *ball.gauge /
                                     (1.0 + ball.rail_radius.value_or(0.0) / R);
  const double r_e = std::sqrt(R * R - h * h);
  const double c = scene.world.losses.rolling;
  const Vector t(std::cos(at.beta), std::sin(at.beta), 0.0);
  const Vector n(std::sin(at.beta), -std::cos(at.beta), 0.0);
  const Vector y(0.0, 0.0, 1.0);
  const Vector e(std::cos(at.theta), std::sin(at.theta), 0.0);
  const Vector e_turned(-e.y(), e.x(), 0.0);
  const double omega = at.v / r_e;

  // ẍ_cm = v̇ (t + r_m/r_e e⊥) − v β̇ n − r_m ω² e.
  const Vector by_v_dot = t + r_m / r_e * e_turned;
  const Vector rest = -at.v * at.turning * n - r_m * omega * omega * e -
                      Vector(0.0, scene.gravity, 0.0);
  Vector press = Vector::Zero(), grip = Vector::Zero();
  Vector moment_of_press = Vector::Zero(), moment_of_grip = Vector::Zero();
  for (const double side : {-1.0, 1.0}) {
    const Vector wall = (-r_e * n + side * h * y) / R;
    const Vector arm = R * wall - r_m * e;
    const Vector rolling = y - y.dot(wall) * wall;
    press += -wall;
    grip += t;
    moment_of_press += arm.cross(-wall) - c * R * rolling.normalized();
    moment_of_grip += arm.cross(t);
  }
  Eigen::Matrix3d matrix;
  Vector right;
  matrix.row(0) << by_v_dot.dot(t), -press.dot(t), -grip.dot(t);
  matrix.row(1) << by_v_dot.dot(n), -press.dot(n), -grip.dot(n);
  matrix.row(2) << ball.k * R * R / r_e, -moment_of_press.z(),
      -moment_of_grip.z();
  right << -rest.dot(t), -rest.dot(n), 0.0;
  const Vector found = matrix.partialPivLu().solve(right);
  return {found[0], found[1], found[2]};
}

std::vector<Ball> random_balls(std::mt19937& random, int count) {
  const auto in = [&](double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random);
  };
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i) {
    const double R = in(0.1, 1.0);
    Ball ball = i % 3 == 0   ? in_a_groove(R, in(0.8, 3.0))
                : i % 3 == 1 ? on_thin_rails(R, R * in(0.2, 1.7))
                             : on_round_rails(R, R * in(0.8, 1.7), R * 0.3);
    ball.eta_m = in(0.0, 0.9) * ball.rolling_radius() / R;
    ball.k = in(0.05, 1.0) * (1.0 - ball.eta_m * ball.eta_m);
    balls.push_back(ball);
  }
  return balls;
}

/// Sums of a dozen terms of order one to a hundred.
constexpr double kOfSums = 1e-11;

TEST(ForcesOnABall, AreThoseOfTheLawsWithTwoContacts) {
  std::mt19937 random(36);
  const auto in = [&](double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random);
  };
  for (const Ball& ball : random_balls(random, 300)) {
    Scene scene = scene_of(Body::rolling_ball(ball, 0.0));
    scene.world.losses.rolling = in(0.0, 0.1);
    const Moving at{in(-9.0, 9.0), in(-3.0, 3.0), in(0.2, 3.0), in(-5.0, 5.0)};
    const TurningPoint<double> state = state_of(scene, at);

    const LawsInSpace laws = by_laws_in_space(scene, at);
    const Kinematics motion = kinematics(
        scene, {{0.0, 0.0}, state.theta, state.beta, state.w, state.q});

    const double scale = 1.0 + std::abs(laws.across) + std::abs(laws.along);
    const double g = scene.gravity;
    // Both walls in sum.
    EXPECT_NEAR(g * motion.R_n * scene.body.wall_ratio, 2.0 * laws.across,
                kOfSums * scale);
    EXPECT_NEAR(g * motion.R_t, 2.0 * laws.along, kOfSums * scale);
    EXPECT_NEAR(motion.omega * scene.body.radius, at.v, kOfSums);
    // |T| ≤ μ N at each of them.
    Scene gripped = scene;
    gripped.limits.friction = 0.3;
    const auto limits = inequalities(gripped.body, gripped.limits);
    EXPECT_NEAR(g * value_of(limits[0], gripped, state),
                2.0 * (0.3 * laws.across - laws.along), kOfSums * scale);
    EXPECT_NEAR(g * value_of(limits[1], gripped, state),
                2.0 * (0.3 * laws.across + laws.along), kOfSums * scale);
  }
}

/// On a hump of radius ρ the bottom of the groove has the radius ρ − R/sin γ,
/// and its length is to that of the path as these are.
TEST(BallInAGroove, FoldsItsBottomFirst) {
  const Body body = Body::rolling_ball(in_a_groove(0.1, kPi / 2.0), 0.0);
  const double bottom = 0.1 * std::sqrt(2.0);
  for (const double radius : {0.5, 0.2, 0.12, 0.08}) {
    const double w = 2.0;

    const Kinematics motion =
        kinematics(body, 9.81, {{0.0, 0.0}, 0.0, 0.4, w, w / radius});

    EXPECT_NEAR(motion.fold_margin, (radius - bottom) / radius,
                kGeometryRounding);
    EXPECT_NEAR(motion.kappa_b, 1.0 / (radius - body.radius),
                kGeometryRounding * std::abs(motion.kappa_b) * 10.0);
    EXPECT_NEAR(curvature_of_centre(body, motion), 1.0 / radius, 1e-13);
  }
  PathLimits limits;
  limits.fold_margin = 0.25;
  EXPECT_NEAR(hump_of_centre(body, limits), 0.75 / bottom, 1e-13);
}

TEST(ObstaclesOfABall, SeeAllOfIt) {
  const Body body = Body::rolling_ball(on_thin_rails(0.5, 0.6), 0.0);
  Scene scene = scene_of(body);
  scene.limits.floor = 2.0;
  scene.limits.discs.push_back({{1.0, 3.0}, 0.2});
  scene.limits.half_planes.push_back({{0.0, 2.5}, -kPi / 2.0});
  const TurningPoint<double> at{1.0, 1.5, 0.0, 1.0, 0.0, 0.0};

  const auto limits = inequalities(body, scene.limits);

  ASSERT_EQ(limits.size(), 3u);
  EXPECT_NEAR(value_of(limits[0], scene, at), 2.0 - 0.5 - 1.5,
              kGeometryRounding);
  EXPECT_NEAR(value_of(limits[1], scene, at), 1.5 - 0.2 - 0.5,
              kGeometryRounding);
  EXPECT_NEAR(value_of(limits[2], scene, at), 1.0 - 0.5, kGeometryRounding);
}

TEST(NumbersOfABall, GoThereAndBack) {
  Ball ball = on_round_rails(0.4, 0.5, 0.1);
  ball.eta_m = 0.3;
  Body body = Body::rolling_ball(ball, 0.7);
  body.mass = 2.0;

  const Body stated = as_stated(body);
  const Body again = as_it_rolls(stated);

  EXPECT_EQ(stated.radius, 0.4);
  EXPECT_EQ(stated.eta_m, 0.3);
  EXPECT_EQ(stated.k, 0.4);
  EXPECT_EQ(again.radius, body.radius);
  EXPECT_EQ(again.eta_m, body.eta_m);
  EXPECT_EQ(again.k, body.k);
  EXPECT_EQ(again.mass, 2.0);
}

/// All mass on the great circle in the middle plane: k = 1 − η², in R. In r_e
/// that is more than 1 − η_e².
TEST(InertiaOfABall, IsBoundByItsOwnRadius) {
  Ball ball = on_thin_rails(0.5, 0.6);
  ball.eta_m = 0.6;
  ball.k = 0.64;
  Scene scene = scene_of(Body::rolling_ball(ball, 0.0));

  EXPECT_TRUE(validate(scene).empty());
  EXPECT_GT(scene.body.k, largest_k(scene.body.eta_m));

  ball.k = 0.65;
  scene.body = Body::rolling_ball(ball, 0.0);
  const auto errors = validate(scene);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors.front().key, "scene.body.k");
}

}  // namespace
}  // namespace brachisto
