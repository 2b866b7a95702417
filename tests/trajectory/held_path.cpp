// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/held_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "model/centre_curve.hpp"
#include "trajectory/prescribed_motion.hpp"

namespace brachisto {
namespace {

Scene rolling_scene(double eta_m, double start_speed) {
  Scene scene;
  scene.body.radius = 1.0 / 3.0;
  scene.body.k = 0.5;
  scene.body.eta_m = eta_m;
  scene.body.theta_m = -std::numbers::pi / 6.0;
  scene.L = 3.0;
  scene.H = 1.0;
  scene.world.start_speed = start_speed;
  return scene;
}

/// The path is of the fourth order in a thousand places, on each arc by itself,
/// and T is stationary about an extremal.
TEST(HeldPath, IsThatOfTheAnswer) {
  Scene bead;
  bead.body = Body::bead();
  bead.L = 2.0;
  bead.H = 1.0;
  Scene bent = rolling_scene(2.0 / 3.0, 0.0);  // at A by a bound on valleys
  bent.limits.curvature = {3.0, 3.0, CurvatureLimit::Of::Centre};
  constexpr double kOfT = 1e-10, kOfLength = 1e-9;
  for (const Scene& scene : {bead, rolling_scene(2.0 / 3.0, 0.0),
                             rolling_scene(2.0 / 3.0, 1.0), bent}) {
    const Solution answer = solve(scene);
    ASSERT_TRUE(answer.verified());

    const PrescribedMotion held(scene,
                                centre_curve(on_its_path(*answer.motion())));

    ASSERT_FALSE(held.stall());
    EXPECT_NEAR(held.transit_time() / answer.motion()->transit_time(), 1.0,
                kOfT);
    EXPECT_NEAR(held.centre_path_length(),
                answer.motion()->centre_path_length(), kOfLength);
    // Forces go with the curvature, which is of the third order: slopes change
    // within a thirtieth of the way, in 30 steps. Where arcs meet it jumps, and
    // a spline that does not would overshoot by a part of the jump.
    constexpr double kOfForces = 1.0 / (30.0 * 30.0 * 30.0);
    const PathDiagnostics of_held = held.diagnose(),
                          of_answer = answer.motion()->diagnose();
    EXPECT_NEAR(of_held.max_normal_force.value,
                of_answer.max_normal_force.value, kOfForces);
    EXPECT_NEAR(of_held.normal_force_after_rise.value,
                of_answer.normal_force_after_rise.value, kOfForces);
    const Point end = held.at(1.0).motion.contact;
    EXPECT_NEAR(end.x, scene.L, 1e-12);
    EXPECT_NEAR(end.z, scene.H, 1e-12);
  }
}

/// At A the track of a body from rest turns as sharply as the body fits, and
/// no spline through points of the track can lead it there. Smaller bodies are
/// led along a path that is smooth in √q in place of q.
TEST(HeldPath, LeadsOtherBodiesOnTheTrack) {
  const Scene first = rolling_scene(0.0, 0.0);
  const Solution answer = solve(first);
  ASSERT_TRUE(answer.verified());
  auto path = std::make_shared<GivenPath>();
  path->track_of = std::make_shared<Scene>(on_its_path(*answer.motion()));
  const PrescribedMotion of_first(first, centre_curve(*path->track_of));

  for (const double radius : {1.0 / 3.0, 0.2, 0.01}) {
    Scene scene = rolling_scene(1.0 / 3.0, 0.0);
    scene.body.radius = radius;
    scene.path = path;
    const PrescribedMotion other(scene, centre_curve(scene));

    ASSERT_FALSE(other.stall());
    EXPECT_LT(other.error_estimate(), 1e-11);
    for (const double q : {0.0, 0.3, 1.0}) {
      const Point here = other.at(q).motion.contact;
      const double own = radius < first.body.radius ? q * q : q;
      const Point there = of_first.at(own).motion.contact;
      EXPECT_NEAR(here.x, there.x, 1e-12) << radius << " " << q;
      EXPECT_NEAR(here.z, there.z, 1e-12) << radius << " " << q;
    }
  }
  // Beside a path of nearly the same radius, too: T is a smooth function of it.
  std::vector<double> times;
  for (const double less : {0.0, 1e-16, 1e-9, 3e-8, 1e-6}) {
    Scene scene = first;
    scene.body.radius -= less;
    scene.path = path;
    const PrescribedMotion other(scene, centre_curve(scene));
    ASSERT_FALSE(other.stall()) << less;
    EXPECT_LT(other.error_estimate(), 1e-11) << less;
    times.push_back(other.transit_time());
    EXPECT_NEAR(times.back(), times.front(), 10.0 * less + 1e-12) << less;
  }
  Scene larger = first;
  larger.body.radius = 0.4;
  larger.path = path;
  const PrescribedMotion stuck(larger, centre_curve(larger));
  ASSERT_TRUE(stuck.stall());
  EXPECT_EQ(stuck.stall()->reason, Stall::Reason::DoesNotFit);
}

}  // namespace
}  // namespace brachisto
