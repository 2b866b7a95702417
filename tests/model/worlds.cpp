// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Fields, drag, and what they are to the Hamiltonian and the start.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "brachisto/model/scene.hpp"
#include "math/portable_random.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "model/units.hpp"
#include "model/world_hamiltonian.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::testing {
namespace {

/// Φ per mass, as section 14 of the theory prints it.
double potential_at(const Scene& scene, Point place) {
  const auto& [centre, R, g_s] = *scene.world.sphere;
  const double d = std::hypot(place.x - centre.x, place.z - centre.z);
  const double of_sphere =
      d > R ? -g_s * R * R / d : 0.5 * g_s * (d * d / R - 3.0 * R);
  return std::lerp(-scene.gravity * place.z, of_sphere,
                   scene.world.field_share);
}

TEST(AField, IsMinusTheGradientOfItsPotential) {
  Scene scene = about_sphere(bead_scene(), around());
  scene.world.sphere->radius = 5.5;  // some of the places are outside
  constexpr double h = 1e-4;
  for (const double share : {0.0, 0.3, 1.0}) {
    scene.world.field_share = share;
    for (const Point at : {Point{0.3, -0.7}, {2.0, 1.0}, {-1.0, 4.0}}) {
      const Pull<double> G = field_at(scene, at.x, at.z);
      const double by_x = (potential_at(scene, {at.x + h, at.z}) -
                           potential_at(scene, {at.x - h, at.z})) /
                          (2.0 * h);
      const double by_z = (potential_at(scene, {at.x, at.z + h}) -
                           potential_at(scene, {at.x, at.z - h})) /
                          (2.0 * h);
      // h² times a third derivative, and rounding of 1e2 over h.
      EXPECT_NEAR(G.x, -by_x, 1e-8);
      EXPECT_NEAR(G.z, -by_z, 1e-8);
    }
  }
}

TEST(AField, FallsInPotentialByTheDifferenceOfPotentials) {
  Scene scene = about_sphere(bead_scene(), around());
  scene.world.sphere->radius = 5.0;
  const Point places[] = {{0.3, -0.7}, {2.0, 1.0}, {-1.0, 4.0}, {0.0, -2.0}};
  for (const double share : {0.0, 0.3, 1.0}) {
    scene.world.field_share = share;
    for (const Point from : places) {
      for (const Point to : places) {
        // Some ulps of potentials up to 1e2.
        EXPECT_NEAR(potential_fall(scene, from, to),
                    potential_at(scene, from) - potential_at(scene, to), 1e-12);
      }
    }
  }
}

TEST(AField, OfASphereIsContinuousAtItsSurfaceAndHasItsStrengthThere) {
  const Sphere sphere = below();
  constexpr double kNext = 1e-12;
  for (const double d : {sphere.radius - kNext, sphere.radius + kNext}) {
    EXPECT_NEAR(sphere.strength_at({sphere.centre.x, sphere.centre.z + d}),
                sphere.surface_gravity, 1e-9);
  }
  EXPECT_NEAR(sphere.strength_at(
                  {sphere.centre.x, sphere.centre.z - 2.0 * sphere.radius}),
              0.25 * sphere.surface_gravity, 1e-13);
}

TEST(WorldsHamiltonian, IsTheOrdinaryOneWhereNothingElseActs) {
  // On the way to a field, where it has no share yet.
  Scene scene = about_sphere(off_centred_scene(-0.5), around());
  scene.world.field_share = 0.0;
  const MovingState state{{0.3, 0.2}, 0.7, 1.3};
  const RollingState rolling{state.theta, state.w};
  const Costates p{-0.4, 0.2, 0.05, -0.3};
  for (const double beta : {-1.0, 0.3, 1.4}) {
    const SlopeHamiltonian ordinary =
        slope_hamiltonian(scene.body, scene.gravity, rolling, p, beta);
    const SlopeHamiltonian any = slope_hamiltonian(scene, state, p, beta);

    // Some ulps of terms up to g.
    constexpr double kRounding = 1e-14;
    EXPECT_NEAR(any.value,
                hamiltonian(scene.body, scene.gravity, rolling, p, beta),
                kRounding);
    EXPECT_NEAR(any.d_beta, ordinary.d_beta, kRounding);
    EXPECT_NEAR(any.d2_beta, ordinary.d2_beta, kRounding);
  }
  const double beta =
      minimising_slope(scene.body, scene.gravity, rolling, p, 0.3);
  EXPECT_NEAR(minimising_slope(scene, state, p, 0.3), beta, 1e-13);
  EXPECT_NEAR(slope_rate(scene, state, p, beta),
              slope_rate(scene.body, scene.gravity, rolling, p, beta), 1e-12);
  EXPECT_NEAR(
      gain_of_other_directions(scene, state, p, 0.3),
      gain_of_other_directions(scene.body, scene.gravity, rolling, p, 0.3),
      1e-13);
}

TEST(StartAngle, InTheFieldOfASphereMakesTheSpeedGrowFastest) {
  for (const Sphere& sphere : {around(), below()}) {
    const Scene scene = about_sphere(off_centred_scene(0.4), sphere);
    const double beta_0 = start_angle(scene);
    const Point centre{scene.body.radius * std::sin(beta_0),
                       -scene.body.radius * std::cos(beta_0)};
    // Between fixed ends: with the start where β₀ puts it.
    const auto growth = [&](double beta) {
      const double root = root_of_inertia(scene.body, scene.body.theta_m, beta);
      return speed_gain(scene, centre.x, centre.z, scene.body.theta_m, 0.0,
                        beta, root) /
             root;
    };

    for (const double other : {-1.0, -1e-3, 1e-3, 1.0}) {
      EXPECT_LT(growth(beta_0 + other), growth(beta_0)) << other;
    }
    // Not the vertical's.
    EXPECT_GT(std::abs(beta_0 - start_angle(scene.body)), 0.01);
  }
}

TEST(NaturalUnits, ScaleWorldsWithTheirScenes) {
  const Scene scene = in_air(
      with_push(about_sphere(off_centred_scene(), around()), 0.7), 0.1, 0.05);
  const Units units = natural_units(scene);
  const Scene natural = in_natural_units(scene);
  const double beta = 0.4, theta = 1.1, w = 2.0;
  const double root = root_of_inertia(scene.body, theta, beta);

  const double here = speed_gain(scene, 0.6, 0.3, theta, w, beta, root);
  const double there =
      speed_gain(natural, 0.6 / units.length, 0.3 / units.length, theta,
                 w / units.speed(), beta, root);

  EXPECT_NEAR(there * units.length / (units.time * units.time), here, 1e-13);
  EXPECT_NEAR(initial_w(natural) * units.speed(), initial_w(scene), 1e-15);
}

bool refused(const Scene& scene, const std::string& key) {
  const std::vector<SceneError> errors = validate(scene);
  return std::any_of(errors.begin(), errors.end(),
                     [&](const SceneError& e) { return e.key == key; });
}

TEST(AWorld, IsRefusedWhereItMeansNothing) {
  const Scene scene = off_centred_scene();
  EXPECT_TRUE(validate(about_sphere(scene, around())).empty());
  EXPECT_TRUE(refused(with_push(scene, -1.0), "scene.start.speed"));
  EXPECT_TRUE(refused(in_air(scene, -1.0, 0.0), "scene.air.linear"));
  EXPECT_TRUE(refused(in_air(scene, 0.0, -1.0), "scene.air.quadratic"));
  Sphere sphere = around();
  sphere.radius = 0.0;
  EXPECT_TRUE(
      refused(about_sphere(scene, sphere), "scene.field.sphere.radius"));
  Scene at_centre = scene;
  at_centre.world.sphere = Sphere{{0.0, 0.0}, 8.0, 9.81};
  EXPECT_TRUE(refused(at_centre, "scene.field.sphere.centre"));
}

TEST(AWorld, PushesNoBodyOutOfACusp) {
  Scene given = in_air(off_centred_scene(), 0.1, 0.0);
  GivenPath path;
  path.shape = GivenPath::Shape::Cycloid;
  given.path = std::make_shared<const GivenPath>(path);
  EXPECT_TRUE(validate(given).empty());
  EXPECT_TRUE(refused(with_push(given, 1.0), "scene.start.speed"));
}

TEST(AWorld, IsRefusedWhereEnergyDoesNotReachTheFinish) {
  // B is farther from the centre than A.
  Scene scene = bead_scene();
  scene.H = 0.1;
  EXPECT_TRUE(
      refused(about_sphere(scene, {{-4.0, 3.0}, 2.0, 9.81}), "scene.finish"));
  EXPECT_FALSE(
      refused(with_push(about_sphere(scene, {{-4.0, 3.0}, 2.0, 9.81}), 8.0),
              "scene.finish"));
}

/// Greatest energy per mass at B, from a grid over the slopes at A and B and
/// over θ_end: ½ v₀² A less potentials, all written down once more.
double greatest_energy_at_finish(const Scene& scene) {
  constexpr int kGrid = 90;
  const Sphere& sphere = *scene.world.sphere;
  const auto potential = [&](double x, double z) {
    const double R = sphere.radius;
    const double d = std::hypot(x - sphere.centre.x, z - sphere.centre.z);
    const double GM = sphere.surface_gravity * R * R;
    return d > R ? -GM / d : GM * (d * d / (R * R * R) - 3.0 / R) / 2.0;
  };
  const Body& body = scene.body;
  const double r = scene.contact == Contact::Centre ? 0.0 : body.radius;
  const double offset = body.radius * body.eta_m;
  const double v = scene.world.start_speed;
  double start = -std::numeric_limits<double>::infinity();
  const auto starts = [&](double beta) {
    const double x = r * std::sin(beta) + offset * std::cos(body.theta_m);
    const double z = -r * std::cos(beta) + offset * std::sin(body.theta_m);
    const double A = 1.0 + body.eta_m * body.eta_m + body.k -
                     2.0 * body.eta_m * std::sin(body.theta_m - beta);
    start = std::max(start, 0.5 * v * v * A + potential(x, z));
  };
  if (v == 0.0) starts(start_angle(scene));
  double end = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kGrid; ++i) {
    const double beta = 2.0 * std::numbers::pi * i / kGrid;
    if (v > 0.0) starts(beta);
    for (int j = 0; j < kGrid; ++j) {
      const double theta = 2.0 * std::numbers::pi * j / kGrid;
      end = std::min(
          end,
          potential(scene.L + r * std::sin(beta) + offset * std::cos(theta),
                    scene.H - r * std::cos(beta) + offset * std::sin(theta)));
    }
  }
  return start - end;
}

TEST(AWorld, IsRefusedForEnergyOnlyWhereItDoesNotSuffice) {
  SplitMix64 random(7);
  int refusals = 0, others = 0;
  for (int i = 0; i < 400; ++i) {
    Scene scene;
    const double eta = i % 3 == 0 ? 0.0 : random.uniform(0.1, 0.7);
    const double r = random.uniform(0.02, 0.4);
    scene.body = Body::cylinder(r, eta, random.uniform(-3.0, 3.0),
                                0.9 * (1.0 - eta * eta));
    scene.contact = i % 2 == 0 ? Contact::Smooth : Contact::Centre;
    scene.L = random.uniform(0.5, 4.0);
    scene.H = random.uniform(0.05, 1.0);
    const double x = random.uniform(-5.0, 5.0), z = random.uniform(-5.0, 5.0);
    scene = about_sphere(scene, {{x, z}, random.uniform(0.3, 3.0), 9.81});
    if (i % 4 > 0) scene = with_push(scene, random.uniform(0.0, 6.0));
    if (i % 5 == 0) scene = in_air(scene, 0.1, 0.0);

    const double energy = greatest_energy_at_finish(scene);

    const bool is_refused = refused(scene, "scene.finish");
    ++(is_refused ? refusals : others);
    if (is_refused) {
      EXPECT_LE(energy, 0.0) << i;
    }
    // Of a centred body the bound is attained. At each end the grid misses
    // the best slope by 1° at most, and with it r (1 − cos 1°) < 1e-4 m under
    // a pull of 9.81 m/s².
    if (eta == 0.0 && energy < -2e-3) {
      EXPECT_TRUE(is_refused) << i;
    }
  }
  EXPECT_GT(refusals, 40);
  EXPECT_GT(others, 40);
}

TEST(AWorld, IsNotRefusedJustAboveTheSpeedThatItTakes) {
  // Up from d = 5 in the field G M/d² of a sphere: v² = 2 G M (1/5 − 1/d_B).
  Scene scene = bead_scene();
  scene.H = 0.1;
  scene = about_sphere(scene, {{-4.0, 3.0}, 2.0, 9.81});
  const double GM = 9.81 * 4.0;
  const double there = std::hypot(scene.L + 4.0, scene.H - 3.0);
  const double speed = std::sqrt(2.0 * GM * (1.0 / 5.0 - 1.0 / there));

  EXPECT_TRUE(refused(with_push(scene, speed * (1.0 - 1e-9)), "scene.finish"));
  EXPECT_FALSE(refused(with_push(scene, speed * (1.0 + 1e-9)), "scene.finish"));
  const std::string told = validate(scene).front().message;
  EXPECT_NE(told.find(fmt::format("more than {:.6g} m/s", speed)),
            std::string::npos)
      << told;
}

TEST(AWorld, IsRefusedWithoutASpeedWhereNoneIsKnown) {
  // A body that is thrown may start at another slope than one at rest, with
  // more potential than B has.
  const Scene scene = about_sphere(
      scene_of(Body::cylinder(1.0 / 3.0, 0.5, std::numbers::pi / 9.0, 0.5)),
      {{-3.0, 9.0}, 9.9, 9.81});

  ASSERT_TRUE(refused(scene, "scene.finish"));
  EXPECT_FALSE(refused(with_push(scene, 1e-3), "scene.finish"));
  const std::string told = validate(scene).front().message;
  EXPECT_NE(told.find("a start.speed can help"), std::string::npos) << told;
  EXPECT_EQ(told.find("more than"), std::string::npos) << told;
}

}  // namespace
}  // namespace brachisto::testing
