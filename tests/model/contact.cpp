// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/start_angle.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

TEST(Contact, CentreAndTrackAreEachOthersInverse) {
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int sample = 0; sample < 100; ++sample) {
    const Point contact{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
    const double radius = random.uniform(0.0, 2.0);
    const double beta = random.uniform(-kPi, kPi);

    const Point back =
        track_below(centre_above(contact, radius, beta), radius, beta);

    // Four roundings of numbers below 8.
    EXPECT_NEAR(back.x, contact.x, ulps(2.0, 8.0)) << "sample " << sample;
    EXPECT_NEAR(back.z, contact.z, ulps(2.0, 8.0)) << "sample " << sample;
  }
}

TEST(Contact, CentreLiesOneRadiusAlongTheNormalAboveTheTrack) {
  const double radius = 0.5;

  const Point above_level = centre_above({1.0, 2.0}, radius, 0.0);
  const Point beside_wall = centre_above({1.0, 2.0}, radius, 0.5 * kPi);

  // z points down; a body that falls along a wall has the wall on its left.
  EXPECT_DOUBLE_EQ(above_level.x, 1.0);
  EXPECT_DOUBLE_EQ(above_level.z, 1.5);
  EXPECT_DOUBLE_EQ(beside_wall.x, 1.5);
  EXPECT_NEAR(beside_wall.z, 2.0, ulps(1.0, 2.0));
}

TEST(Contact, StartTouchesA) {
  for (const double theta_m : {-kPi / 6.0, 0.0, 1.0}) {
    const Scene scene = off_centred_scene(theta_m);

    const Point contact = track_below(start_of_centre(scene), scene.body.radius,
                                      start_angle(scene.body));

    EXPECT_EQ(contact.x, 0.0);
    EXPECT_EQ(contact.z, 0.0);
  }
}

TEST(Contact, EndTouchesBWithAnySlope) {
  const Scene scene = uniform_scene();
  for (const double phi : {-1.2, 0.0, 0.4}) {
    const Point contact =
        track_below(end_of_centre(scene, phi), scene.body.radius, phi);

    EXPECT_NEAR(contact.x, scene.L, ulps(2.0, scene.L));
    EXPECT_NEAR(contact.z, scene.H, ulps(2.0, scene.H));
  }
}

TEST(Contact, OfTheCentrePutsTheCentreAtAAndB) {
  Scene scene = off_centred_scene(-1.0);
  scene.contact = Contact::Centre;

  const Point start = start_of_centre(scene);
  const Point end = end_of_centre(scene, 0.7);

  EXPECT_EQ(start.x, 0.0);
  EXPECT_EQ(start.z, 0.0);
  EXPECT_EQ(end.x, scene.L);
  EXPECT_EQ(end.z, scene.H);
}

}  // namespace
}  // namespace brachisto::testing
