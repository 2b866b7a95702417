// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/stated_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/path_inequality.hpp"
#include "trajectory/feasibility.hpp"
#include "trajectory/self_crossing.hpp"

namespace brachisto {
namespace {

Scene with_all_limits() {
  Scene scene;
  scene.body = Body::cylinder(0.25, 0.5, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  scene.limits.friction = 0.5;
  scene.limits.normal_min = 0.125;
  scene.limits.normal_max = 4.0;
  scene.limits.curvature = {2.0, 3.0, CurvatureLimit::Of::Track};
  scene.limits.fold_margin = 0.25;
  scene.limits.floor = 2.0;
  scene.limits.discs = {{{4.0, 4.0}, 0.5}, {{1.0, 4.0}, 1.0}};
  scene.limits.half_planes = {{{4.0, 0.0}, std::numbers::pi}};
  return scene;
}

/// Of given curvature of the centre's path, the centre at (1, 1).
TrajectoryPoint turning(double r, double kappa_c) {
  TrajectoryPoint p;
  p.centre = {1.0, 1.0};
  p.motion.R_n = 1.0;
  p.motion.R_t = -0.125;
  p.motion.fold_margin = 1.0 - r * kappa_c;
  p.motion.kappa_b = kappa_c / p.motion.fold_margin;
  return p;
}

const StatedLimit& named(const std::vector<StatedLimit>& limits,
                         const std::string& name) {
  for (const StatedLimit& limit : limits) {
    if (limit.name == name) return limit;
  }
  throw std::out_of_range(name);
}

TEST(StatedLimits, HaveTheirBoundsAndSlacks) {
  const Scene scene = with_all_limits();
  const auto limits = stated_limits(scene);
  // κ_c = 1, 1 − r κ_c = 3/4, κ_b = 4/3.
  const TrajectoryPoint p = turning(scene.body.radius, 1.0);
  struct Expected {
    std::string name;
    std::optional<double> bound;
    double slack;
  };

  const std::vector<Expected> expected{
      {"friction", 0.5, 0.375},
      {"normal_force.min", 0.125, 0.875},
      {"normal_force.max", 4.0, 3.0},
      {"curvature.hump", 2.0, 2.0 / 3.0},
      {"curvature.valley", 3.0, 13.0 / 3.0},
      {"fold_margin", 0.25, 0.5},
      {"floor", 2.0, 0.75},
      {"clear_of.disc.1", 0.5, std::sqrt(18.0) - 0.75},
      {"clear_of.disc.2", 1.0, 1.75},
      {"clear_of.half_plane", {}, 2.75}};

  ASSERT_EQ(limits.size(), expected.size());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    EXPECT_EQ(limits[i].name, expected[i].name);
    EXPECT_EQ(limits[i].bound, expected[i].bound) << limits[i].name;
    EXPECT_NEAR(limits[i].slack(p), expected[i].slack, 1e-14) << limits[i].name;
  }
}

TEST(StatedLimits, OfTheCentresPathBoundItsCurvature) {
  Scene scene = with_all_limits();
  scene.limits.curvature.of = CurvatureLimit::Of::Centre;
  const auto limits = stated_limits(scene);
  const TrajectoryPoint p = turning(scene.body.radius, 1.0);

  EXPECT_NEAR(named(limits, "curvature.hump").slack(p), 1.0, 1e-14);
  EXPECT_NEAR(named(limits, "curvature.valley").slack(p), 4.0, 1e-14);
}

// Curvature bounds of the track are converted to the centre's path elsewhere.
TEST(StatedLimits, AreReachedWhereTheConvertedOnesAre) {
  for (const auto of :
       {CurvatureLimit::Of::Track, CurvatureLimit::Of::Centre}) {
    Scene scene = with_all_limits();
    scene.limits.fold_margin.reset();
    scene.limits.curvature.of = of;
    const auto limits = stated_limits(scene);
    const double r = scene.body.radius;
    const double hump = hump_of_centre(scene.body, scene.limits);
    const double valley = valley_of_centre(scene.body, scene.limits);

    EXPECT_NEAR(named(limits, "curvature.hump").slack(turning(r, hump)), 0.0,
                1e-14);
    EXPECT_NEAR(named(limits, "curvature.valley").slack(turning(r, -valley)),
                0.0, 1e-14);
  }
}

TEST(StatedLimits, OfADiscOrHalfPlaneThatIsAloneHaveNoNumber) {
  Scene scene = with_all_limits();
  scene.limits.discs.resize(1);
  scene.limits.half_planes.resize(2);
  const auto limits = stated_limits(scene);

  EXPECT_NO_THROW((void)named(limits, "clear_of.disc"));
  EXPECT_NO_THROW((void)named(limits, "clear_of.half_plane.2"));
}

PathDiagnostics lifting_off() {
  PathDiagnostics path;
  path.min_normal_force = {-0.5, 1.25};
  path.min_fold_margin = {1.0, 0.0};
  return path;
}

TEST(Feasibility, NamesTheLimitThatForbidsLiftOff) {
  Scene scene = with_all_limits();
  scene.limits = {};
  scene.limits.curvature.valley = 2.0;
  constexpr const char* kRemedy = "normal_force: {min: 0} under scene.limits";

  const auto reasons = infeasible_because(scene, lifting_off());

  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_NE(reasons[0].find("would lift off: R_n = -0.5 m g"),
            std::string::npos);
  EXPECT_NE(reasons[0].find(kRemedy), std::string::npos);

  scene.limits = {};
  const auto free = infeasible_because(scene, lifting_off());
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].find(kRemedy), std::string::npos);
}

// Limits of a path that knows no arcs hold at points; what is between them may
// contradict the limit, and no verdict is to hide it.
TEST(Feasibility, TellsWhatIsBeyondALimitBetweenPoints) {
  Scene scene = with_all_limits();
  scene.limits = {};
  scene.limits.normal_min = 0.2;
  scene.limits.fold_margin = 0.1;
  PathDiagnostics path;
  path.min_normal_force = {0.2 - 1e-7, 1.25};
  path.min_fold_margin = {0.1, 0.0};
  EXPECT_TRUE(undecided_because(scene, path).empty());

  path.min_normal_force.value = 0.2 - 7e-5;
  path.min_fold_margin.value = -7e5;
  EXPECT_TRUE(infeasible_because(scene, path).empty());
  const auto reasons = undecided_because(scene, path);
  ASSERT_EQ(reasons.size(), 2U);
  EXPECT_EQ(reasons[0],
            "R_n is 7e-05 m g below its bound 0.2 at x_b = 1.25, between "
            "points of this mesh");
  EXPECT_NE(reasons[1].find("below its bound 0.1"), std::string::npos);

  // κ_c ≤ 3 of the centre, and −2 ≤ κ_b of the track.
  scene.limits = {};
  scene.limits.curvature.hump = 3.0;
  scene.limits.curvature.of = CurvatureLimit::Of::Centre;
  const double margin = 1.0 - 3.0 * scene.body.radius;
  path = {};
  path.min_fold_margin = {margin, 0.0};
  EXPECT_TRUE(undecided_because(scene, path).empty());
  path.min_fold_margin.value = margin - 1e-4;
  EXPECT_EQ(undecided_because(scene, path).size(), 1U);
  scene.limits.curvature = {};
  scene.limits.curvature.valley = 2.0;
  path.min_curvature = {-2.0 - 1e-9, 0.5};
  EXPECT_TRUE(undecided_because(scene, path).empty());
  path.min_curvature.value = -7.84;
  ASSERT_EQ(undecided_because(scene, path).size(), 1U);
  EXPECT_EQ(undecided_because(scene, path)[0],
            "κ_b is 5.8 1/m below its bound -2 at x_b = 0.5, between points of "
            "this mesh");
  // Of a track that folds κ_b says nothing.
  path.min_fold_margin.value = -0.1;
  path.min_curvature.value = -std::numeric_limits<double>::infinity();
  for (const std::string& reason : undecided_because(scene, path)) {
    EXPECT_EQ(reason.find("κ_b"), std::string::npos);
  }
  // A thousandth of all lengths is the same path.
  scene.body.radius *= 1e-3;
  scene.limits.curvature.valley = 2e3;
  path = {};
  path.min_fold_margin = {1.0, 0.0};
  path.min_curvature = {-2e3 * (1.0 + 2e-8), 0.5};
  EXPECT_TRUE(undecided_because(scene, path).empty());
  path.min_curvature.value = -2e3 * (1.0 + 2e-6);
  EXPECT_EQ(undecided_because(scene, path).size(), 1U);

  scene.limits = {};
  scene.limits.friction = 0.4;
  path = {};
  path.min_fold_margin = {1.0, 0.0};
  path.min_normal_force = {-7e-5, 1.25};
  EXPECT_EQ(undecided_because(scene, path).size(), 1U);
  scene.body = Body::bead();
  EXPECT_EQ(undecided_because(scene, path).size(), 1U);
}

// R_n = 0 along an arc is what its limit allows, and in floating point about as
// often a little less.
TEST(Feasibility, LeavesLiftOffToTheLimitThatForbidsIt) {
  Scene scene = with_all_limits();
  PathDiagnostics path = lifting_off();
  path.min_normal_force.value = -1e-12;
  const auto feasible_with = [&](std::optional<double> friction,
                                 std::optional<double> least) {
    scene.limits = {};
    scene.limits.curvature.valley = 2.0;
    scene.limits.friction = friction;
    scene.limits.normal_min = least;
    return infeasible_because(scene, path).empty();
  };

  EXPECT_TRUE(feasible_with({}, 0.0));
  EXPECT_TRUE(feasible_with(0.5, {}));
  EXPECT_FALSE(feasible_with({}, {}));
  EXPECT_FALSE(feasible_with({}, -0.25));
}

// The same of 1 − r κ_c = 0; the certificate says whether its limit is kept.
TEST(Feasibility, LeavesFoldsToTheLimitThatForbidsThem) {
  Scene scene = with_all_limits();
  PathDiagnostics path;
  path.min_normal_force = {0.5, 1.25};
  path.min_fold_margin = {-1e-12, 1.25};

  scene.limits = {};
  const double shortest = kShortestFold * std::hypot(scene.L, scene.H);
  path.folds_back = 0.9 * shortest;
  EXPECT_TRUE(infeasible_because(scene, path).empty());
  path.folds_back = 1.1 * shortest;
  EXPECT_EQ(infeasible_because(scene, path).size(), 1u);
  scene.limits.fold_margin = 0.0;
  EXPECT_TRUE(infeasible_because(scene, path).empty());
}

}  // namespace
}  // namespace brachisto
