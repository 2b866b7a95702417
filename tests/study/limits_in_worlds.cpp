// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Limits in air, with a push and in a sphere's field: by two methods, and by
// Newton's and Euler's laws.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "support/limited_scenes.hpp"
#include "support/newton_euler.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

struct LimitedRow {
  std::string name;
  Scene scene;
};

std::ostream& operator<<(std::ostream& out, const LimitedRow& row) {
  return out << row.name;
}

/// Loads, humps and valleys bounded: what every contact is well posed with.
PathLimits ride() {
  PathLimits limits = bends(2.7, 4.0);
  limits.normal_min = 0.2;
  limits.normal_max = 5.0;
  return limits;
}

/// Without a least load, which would be touched and held for 1e-10 of U.
PathLimits heavy_ride() {
  PathLimits limits = ride();
  limits.normal_min.reset();
  return limits;
}

PathLimits obstacle(double z) {
  PathLimits limits;
  limits.discs = {{{1.2, z}, 0.15}};
  return limits;
}

Scene in_drag(const Scene& scene) {
  return in_air(scene, 0.3, 0.1);
}

std::vector<LimitedRow> limited_rows() {
  const Scene base = off_centred_scene(), ahead = off_centred_scene(-kPi / 6.0);
  const Scene uniform = uniform_scene(), bead = bead_scene();
  const auto pushed = [](const Scene& scene) { return with_push(scene, 1.0); };
  const auto planet = [](const Scene& scene) {
    return about_sphere(scene, {{1.0, 10.0}, 8.0, 9.81});
  };
  const auto all = [&](const Scene& scene) {
    return planet(pushed(in_air(scene, 0.1, 0.05)));
  };
  Scene level = under(in_drag(base), bends(2.5, 3.0), Contact::EndSlope);
  level.end_slope = 0.0;
  PathLimits loads;
  loads.normal_min = 0.1;
  loads.normal_max = 5.0;
  PathLimits light;
  light.normal_max = 2.5;
  // Both bounds of a slow start: its slope is the one that lets both hold.
  PathLimits corner = least_force(0.6);
  corner.curvature.valley = 2.0;
  corner.curvature.of = CurvatureLimit::Of::Centre;
  const auto slow = [](const Scene& scene) { return with_push(scene, 0.5); };
  return {
      {"floor_in_air", under(in_drag(base), floor_at(1.25))},
      {"friction_in_air", under(in_drag(base), friction(1.0))},
      {"little_friction_in_air", under(in_drag(base), friction(0.4))},
      {"bead_on_a_floor_in_air", under(in_drag(bead), floor_at(1.1))},
      {"incline_in_air", under(in_drag(uniform), friction(0.3))},
      {"given_slope_in_air", level},
      {"disc_in_air", under(in_drag(ahead), obstacle(1.1))},
      {"floor_with_a_push", under(pushed(ahead), floor_at(1.2))},
      {"friction_with_a_push", under(pushed(base), friction(0.6))},
      {"valley_with_a_push", under(pushed(base), bends(2.0, 2.0))},
      {"ride_with_a_push", under(pushed(base), ride(), Contact::Optimal)},
      {"bead_with_a_push", under(pushed(bead), floor_at(1.1))},
      {"load_with_a_push", under(pushed(uniform), light)},
      {"corner_at_A", under(slow(base), corner)},
      {"corner_of_a_given_centre", under(slow(base), corner, Contact::Centre)},
      {"floor_on_a_planet", under(planet(base), floor_at(1.25))},
      {"friction_on_a_planet", under(planet(base), friction(1.0))},
      {"loads_on_a_planet", under(planet(base), loads)},
      {"ride_on_a_planet", under(planet(base), ride(), Contact::Optimal)},
      {"friction_in_a_planet",
       under(about_sphere(ahead, around()), friction(0.8))},
      {"ride_in_all_of_it", under(all(base), heavy_ride(), Contact::Optimal)},
      {"disc_in_all_of_it", under(all(base), obstacle(1.2))},
  };
}

class LimitsInAWorld : public ::testing::TestWithParam<LimitedRow> {};

TEST_P(LimitsInAWorld, AreKeptByBothMethodsAndTheLawsHold) {
  const Scene& scene = GetParam().scene;
  SolveOptions shooting;
  shooting.method = Shooting{};
  const Solution program = solve(scene, {});
  const Solution shot = solve(scene, shooting);
  ASSERT_TRUE(program.verified())
      << program.message
      << ::testing::PrintToString(program.not_verified_because());
  ASSERT_TRUE(shot.verified())
      << shot.message << ::testing::PrintToString(shot.not_verified_because());

  EXPECT_NEAR(program.motion()->tau() / shot.motion()->tau(), 1.0,
              *program.estimated_error + *shot.estimated_error);
  EXPECT_LE(*program.estimated_error, 1e-9);
  EXPECT_LE(*shot.estimated_error, 1e-9);

  const LeftOver left = left_over(*program.motion(), rigid_body_of(scene));
  EXPECT_LE(left.largest(), allowed_along(program)) << left;
}

class PricesInAWorld : public ::testing::TestWithParam<LimitedRow> {};

/// Of whole solves, whose T is right to some 1e-12, over steps of 1e-4: to the
/// square of that step times a third derivative of order one and more.
TEST_P(PricesInAWorld, AndSensitivitiesAreSlopesOfTheTime) {
  constexpr double kStep = 1e-4, kAllowed = 1e-6;
  const Scene& scene = GetParam().scene;
  SolveOptions options;
  options.method = [] {
    Collocation program;
    program.sensitivities = SensitivityOrder::First;
    return program;
  }();
  const Solution solution = solve(scene, options);
  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_TRUE(solution.sensitivities);
  const auto slope = [&](const std::function<void(Scene&, double)>& move) {
    const auto tau_at = [&](double by) {
      Scene moved = scene;
      move(moved, by);
      const Solution there = solve(moved, {});
      return there.verified() ? there.motion()->tau() : std::nan("");
    };
    return (tau_at(kStep) - tau_at(-kStep)) / (2.0 * kStep);
  };

  EXPECT_NEAR(solution.sensitivities->by[SceneParameter::EtaM].tau,
              slope([](Scene& s, double by) { s.body.eta_m += by; }), kAllowed);
  int active = 0;
  for (const LimitOnPath& limit : solution.limits) {
    ASSERT_TRUE(limit.price);
    if (limit.active.empty()) continue;
    ++active;
    EXPECT_NEAR(*limit.price, slope([&](Scene& s, double by) {
      if (limit.name == "floor") *s.limits.floor += by;
      if (limit.name == "friction") *s.limits.friction += by;
      if (limit.name == "normal_force.min") *s.limits.normal_min += by;
      if (limit.name == "curvature.valley") {
        *s.limits.curvature.valley += by;
      }
    }),
                kAllowed)
        << limit.name;
  }
  EXPECT_GE(active, 1);
}

std::vector<LimitedRow> priced() {
  std::vector<LimitedRow> out;
  for (const LimitedRow& row : limited_rows()) {
    if (row.name == "floor_in_air" || row.name == "friction_on_a_planet" ||
        row.name == "valley_with_a_push" || row.name == "corner_at_A" ||
        row.name == "corner_of_a_given_centre") {
      out.push_back(row);
    }
  }
  return out;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PricesInAWorld, ::testing::ValuesIn(priced()),
                         [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(Scenes, LimitsInAWorld,
                         ::testing::ValuesIn(limited_rows()),
                         [](const auto& row) { return row.param.name; });

/// Where its greatest load gives way to friction both hold, and costates jump:
/// twice.
TEST(LimitsFromOppositeSides, BothHoldAtAJunction) {
  Scene scene;
  scene.L = 2.876;
  scene.H = 1.0;
  scene.body = Body::cylinder(0.2389, 0.503, -51.02 * kPi / 180.0, 0.487);
  scene.limits.friction = 0.233;
  scene.limits.normal_max = 1.642;
  scene = in_air(scene, 0.16, 0.069);

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  // By multiple shooting.
  EXPECT_NEAR(solution.motion()->tau(), 6.04104416534, 1e-9);
  const std::vector<ActiveArc>& friction = solution.limits[0].active;
  const std::vector<ActiveArc>& load = solution.limits[1].active;
  ASSERT_EQ(friction.size(), 3U);
  ASSERT_EQ(load.size(), 4U);
  EXPECT_EQ(load[0].sigma.to, friction[1].sigma.from);
  EXPECT_EQ(load[2].sigma.to, friction[2].sigma.from);
}

}  // namespace
}  // namespace brachisto
