// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Whether there is a way at all, against widths that can be said in advance.

#include "model/passage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/contact.hpp"

namespace brachisto {
namespace {

/// A uniform cylinder between a disc, about (1.5, 0.4), and the floor.
bool open_beneath(double floor, double radius) {
  Scene scene;
  scene.L = 3.0;
  scene.H = 1.0;
  scene.body = Body::cylinder(0.25, 0.0, 0.0, 0.5);
  scene.limits.floor = floor;
  scene.limits.discs = {{{1.5, 0.4}, radius}};
  return way_is_open(scene, inequalities(scene.body, scene.limits));
}

/// It starts from rest at (r, 0), rises no higher and so does not pass above
/// the disc; below it passes if floor − 0.4 − radius ≥ 2 r.
TEST(Passage, IsOpenIfTheBodyFitsThrough) {
  constexpr double kSquare = 3.0 * 3.0 / 400.0;
  const double widest = 1.3 - 0.4 - 0.5;
  EXPECT_TRUE(open_beneath(1.3, widest - kSquare));
  EXPECT_TRUE(open_beneath(1.3, widest));
  EXPECT_FALSE(open_beneath(1.3, widest + 2.0 * kSquare));
  EXPECT_TRUE(open_beneath(1.3 + 3.0 * kSquare, widest + 2.0 * kSquare));
}

/// An off-centred body may rise while its mass comes down; a push lifts too.
TEST(Passage, AboveIsLeftOpenWhereEnergyMayReach) {
  Scene scene;
  scene.L = 3.0;
  scene.H = 1.0;
  scene.body = Body::cylinder(0.25, 0.0, 0.0, 0.5);
  scene.limits.floor = 1.3;
  scene.limits.discs = {{{1.5, 0.4}, 0.45}};
  const auto open = [&] {
    return way_is_open(scene, inequalities(scene.body, scene.limits));
  };
  EXPECT_FALSE(open());
  scene.world.start_speed = 5.0;
  EXPECT_TRUE(open());
  scene.world.start_speed = 0.0;
  scene.body = Body::cylinder(0.25, 0.7, -0.5 * std::numbers::pi, 0.5);
  scene.limits.discs.front().centre.z = 0.6;
  EXPECT_TRUE(open());
}

/// It starts with its mass below its centre, and has to lift it by 2 r η on the
/// way, which a floor leaves it the energy for if the centre may sink by as
/// much.
struct TurningOver {
  static constexpr double kSquare = 3.0 * 6.5 / 400.0;
  Scene scene;

  TurningOver() {
    scene.L = 6.0;
    scene.H = 0.5;
    scene.body = Body::cylinder(0.5, 0.4, 0.5 * std::numbers::pi, 0.5);
  }
  /// \param more  that the floor leaves
  [[nodiscard]] bool is_open(double more) {
    const double lowest = start_of_centre(scene).z + 2.0 * 0.5 * 0.4;
    scene.limits.floor = lowest + scene.body.radius + more;
    return way_is_open(scene, inequalities(scene.body, scene.limits));
  }
};

/// It may sink first: B is two turns away. Where the body is as large as that
/// the squares are fewer and up to 1.3 times as wide.
TEST(Passage, IsShutIfTheBodyCannotTurnOver) {
  TurningOver body;
  EXPECT_TRUE(body.is_open(0.0));
  EXPECT_TRUE(body.is_open(1.0));
  EXPECT_FALSE(body.is_open(-3.0 * TurningOver::kSquare));
  body.scene.L = 1.2;  // it does not come so far round
  EXPECT_TRUE(body.is_open(-3.0 * TurningOver::kSquare));
}

/// From rest it comes no further from the centre of a sphere than it began. On
/// a circle about that centre through A, B is reached with nothing left; a
/// floor keeps the centre from passing B below.
TEST(Passage, IsShutWhereBLiesHigherInTheFieldOfASphere) {
  Scene scene;
  scene.L = 4.0;
  scene.H = 1.0;
  scene.body = Body::cylinder(0.4, 0.0, 0.0, 0.5);
  scene.limits.floor = 1.0;  // above B the centre is 0.4 higher, φ = 0
  const auto open = [&](double x) {
    scene.world.sphere = Sphere{{x, 15.0}, 6.0, 60.0};
    return way_is_open(scene, inequalities(scene.body, scene.limits));
  };
  // It starts at (0.4, 0) and ends at (4, 0.6): the same height where
  // (x − 0.4)² + 15² = (4 − x)² + 14.4².
  const double level =
      (4.0 * 4.0 + 14.4 * 14.4 - 0.4 * 0.4 - 15.0 * 15.0) / (2.0 * (4.0 - 0.4));
  constexpr double kSquare = 3.0 * 4.4 / 400.0;
  // For energy, floor and circle about B half a diagonal of a square is left
  // each, 2.1 squares in all; within the slack h = 1.4 squares of the floor φ
  // may be √(2 h/r) = 0.48, which takes the centre 0.19 to the left and 0.24
  // times as much down in this field, 1.4 squares. A step lets B rise by 4.
  const double step = 4.0 * kSquare * 15.0 / (4.0 - 0.4);
  EXPECT_TRUE(open(level));
  EXPECT_TRUE(open(level + 1.0));
  EXPECT_FALSE(open(level - step));
  scene.world.air.linear = 0.1;  // takes energy alone
  EXPECT_FALSE(open(level - step));
  scene.world.start_speed = 3.0;
  EXPECT_TRUE(open(level - step));
}

/// A sphere as large as that is a uniform field, for an off-centred body too.
TEST(Passage, IsShutInALargeSphereWhereItIsInAUniformField) {
  TurningOver body;
  body.scene.world.sphere = Sphere{{0.0, 1e7}, 1e7, body.scene.gravity};
  EXPECT_TRUE(body.is_open(0.0));
  EXPECT_FALSE(body.is_open(-3.0 * TurningOver::kSquare));
}

TEST(Passage, IsOpenWithoutObstacles) {
  Scene scene;
  scene.body = Body::cylinder(0.25, 0.5, 0.0, 0.5);
  scene.limits.friction = 0.1;
  EXPECT_TRUE(way_is_open(scene, inequalities(scene.body, scene.limits)));
}

}  // namespace
}  // namespace brachisto
