// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/units.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/cycloid.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

TEST(NaturalUnits, MakeTheLargerDistanceAndTwiceGravityOne) {
  Scene wide = off_centred_scene();
  wide.L = 30.0;
  wide.H = 4.0;
  Scene deep = wide;
  deep.H = 120.0;

  for (const Scene& scene : {wide, deep}) {
    const Scene natural = in_natural_units(scene);
    const Units units = natural_units(scene);

    EXPECT_EQ(std::max(natural.L, natural.H), 1.0);
    EXPECT_EQ(2.0 * natural.gravity, 1.0);
    // g in the new units.
    EXPECT_NEAR(scene.gravity * units.time * units.time / units.length,
                natural.gravity, ulps(2.0));
    EXPECT_DOUBLE_EQ(units.speed(), units.length / units.time);
  }
}

TEST(NaturalUnits, KeepShapesAndAnglesAndMeaning) {
  Scene scene = off_centred_scene(-0.4);
  scene.body.mass = 2.0;
  scene.contact = Contact::Centre;

  const Scene natural = in_natural_units(scene);

  EXPECT_TRUE(validate(natural).empty());
  EXPECT_EQ(natural.body.shape, scene.body.shape);
  EXPECT_EQ(natural.body.eta_m, scene.body.eta_m);
  EXPECT_EQ(natural.body.theta_m, scene.body.theta_m);
  EXPECT_EQ(natural.body.k, scene.body.k);
  EXPECT_EQ(natural.body.mass, scene.body.mass);
  EXPECT_EQ(natural.contact, scene.contact);
  EXPECT_NEAR(natural.L / natural.H, scene.L / scene.H, ulps(4.0, 3.0));
  EXPECT_NEAR(natural.body.radius / natural.H, scene.body.radius / scene.H,
              ulps(2.0));
}

TEST(NaturalUnits, MakeAnswersFreeOfUnitsAndGravity) {
  const Scene scene = uniform_scene();
  const CycloidArc arc = *axisymmetric_optimum(scene);
  for (const double scale : {1e-3, 1.0, 2.5e4}) {
    for (const double gravity : {1.62, 9.81, 274.0}) {
      Scene other = scene;
      other.L *= scale;
      other.H *= scale;
      other.body.radius *= scale;
      other.gravity = gravity;

      const CycloidArc natural_arc =
          *axisymmetric_optimum(in_natural_units(other));

      // The optimum is found to 16 ε in numbers of order one.
      const Units units = natural_units(other);
      const double tau = natural_arc.rolling_time(0.5) * units.time *
                         std::sqrt(gravity / scale);
      EXPECT_NEAR(tau, arc.rolling_time(1.0), ulps(32.0, tau))
          << "scale " << scale << " g " << gravity;
      EXPECT_NEAR(natural_arc.psi_end, arc.psi_end, ulps(32.0, 4.0));
      EXPECT_NEAR(natural_arc.a * units.length, arc.a * scale,
                  ulps(32.0, arc.a * scale));
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
