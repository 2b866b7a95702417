// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What validate() says of limits and of the contacts that need them.

#include "model/scene_checker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/numbers.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Which body, and what is asked of it.
struct Asked {
  const char* name;
  Scene scene;
  void (*ask)(Scene&);
  const char* key;      ///< "": nothing is refused
  const char* message;  ///< part of it
};

void PrintTo(const Asked& asked, std::ostream* out) {
  *out << asked.name;
}

std::string name_of(const ::testing::TestParamInfo<Asked>& row) {
  return row.param.name;
}

void no_limit(Scene&) {}

Scene optimal(Scene scene) {
  scene.contact = Contact::Optimal;
  return scene;
}

Scene with_end_slope(Scene scene, double slope) {
  scene.contact = Contact::EndSlope;
  scene.end_slope = slope;
  return scene;
}

Scene between_centres(Scene scene) {
  scene.contact = Contact::Centre;
  return scene;
}

class AskedLimits : public ::testing::TestWithParam<Asked> {};

TEST_P(AskedLimits, AreTakenOrRefusedWithTheReason) {
  Scene scene = GetParam().scene;
  GetParam().ask(scene);

  const std::vector<SceneError> errors = validate(scene);

  if (*GetParam().key == '\0') {
    for (const SceneError& error : errors) {
      ADD_FAILURE() << error.key << ": " << error.message;
    }
    return;
  }
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].key, GetParam().key);
  EXPECT_THAT(errors[0].message, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, AskedLimits,
    ::testing::Values(
        Asked{"NoFriction", uniform_scene(),
              [](Scene& s) { s.limits.friction = 0.0; },
              "scene.limits.friction", "0 is not allowed: it must be > 0"},
        Asked{"FrictionNaN", uniform_scene(),
              [](Scene& s) { s.limits.friction = kNaN; },
              "scene.limits.friction", "not a finite number"},
        Asked{"NoLoad", uniform_scene(),
              [](Scene& s) { s.limits.normal_max = 0.0; },
              "scene.limits.normal_force.max", "0 m g is not allowed"},
        Asked{"InfiniteLoad", uniform_scene(),
              [](Scene& s) {
                s.limits.normal_min = -std::numeric_limits<double>::infinity();
              },
              "scene.limits.normal_force.min", "not a finite number"},
        Asked{"LeastIsGreatest", off_centred_scene(),
              [](Scene& s) { s.limits.normal_min = s.limits.normal_max = 0.2; },
              "scene.limits.normal_force.min", "less than max = 0.2 m g"},
        Asked{"Hump", uniform_scene(),
              [](Scene& s) { s.limits.curvature.hump = -2.0; },
              "scene.limits.curvature.hump", "-2 1/m is not allowed"},
        Asked{"Valley", uniform_scene(),
              [](Scene& s) { s.limits.curvature.valley = 0.0; },
              "scene.limits.curvature.valley", "0 1/m is not allowed"},
        Asked{"NegativeMargin", uniform_scene(),
              [](Scene& s) { s.limits.fold_margin = -0.1; },
              "scene.limits.fold_margin", "-0.1 is not allowed: 0 ≤ m < 1"},
        Asked{"WholeMargin", uniform_scene(),
              [](Scene& s) { s.limits.fold_margin = 1.0; },
              "scene.limits.fold_margin", "1 is not allowed: 0 ≤ m < 1"},
        Asked{"DiscWithoutSize", uniform_scene(),
              [](Scene& s) {
                s.limits.discs = {{{1.0, 2.0}, 0.0}};
              },
              "scene.limits.clear_of", "the radius of a disc is a length"},
        Asked{"PlaceTooFar", uniform_scene(),
              [](Scene& s) {
                s.limits.half_planes = {{{0.0, -1e51}, 0.0}};
              },
              "scene.limits.clear_of", "at most 1e+50"},
        Asked{"SlopeTooSteep", with_end_slope(uniform_scene(), -3.2), no_limit,
              "scene.contact.end_slope",
              "-3.2 rad is not allowed: it must be from −π"},
        Asked{"SlopeMissing", uniform_scene(),
              [](Scene& s) { s.contact = Contact::EndSlope; },
              "scene.contact.end_slope", "missing"},
        Asked{"SlopeNotAskedFor", uniform_scene(),
              [](Scene& s) { s.end_slope = 0.1; }, "scene.contact.end_slope",
              "only a contact of a given slope"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Bodies, AskedLimits,
    ::testing::Values(
        Asked{"BeadWithFriction", bead_scene(),
              [](Scene& s) { s.limits.friction = 0.5; },
              "scene.limits.friction", "not allowed of a bead"},
        Asked{"BeadWithMargin", bead_scene(),
              [](Scene& s) { s.limits.fold_margin = 0.5; },
              "scene.limits.fold_margin", "not allowed of a bead"},
        Asked{"BeadWithTheRest", bead_scene(),
              [](Scene& s) {
                s.limits.normal_min = 0.5;
                s.limits.normal_max = 2.0;
                s.limits.curvature = {2.0, 50.0};
                s.limits.floor = 1.0;
              },
              "", ""},
        // A body of radius r fits a valley of the track whose own radius is
        // more than r: 1/κ_b > r.
        Asked{"ValleySharperThanTheBody", uniform_scene(),
              [](Scene& s) { s.limits.curvature.valley = 3.0; },
              "scene.limits.curvature.valley", "less than 1/r"},
        Asked{"ValleyOfTheCentre", uniform_scene(),
              [](Scene& s) {
                s.limits.curvature = {{}, 3.0, CurvatureLimit::Of::Centre};
              },
              "", ""},
        Asked{"WeightOnASlope", uniform_scene(),
              [](Scene& s) { s.limits.normal_min = 1.0; },
              "scene.limits.normal_force.min", "less than 1 without an offset"},
        Asked{"NearlyTheWeightOnASlope", uniform_scene(),
              [](Scene& s) { s.limits.normal_min = 0.99; }, "", ""},
        Asked{"BeadOfItsWeight", bead_scene(),
              [](Scene& s) { s.limits.normal_min = 1.0; },
              "scene.limits.normal_force.min", "less than 1 without an offset"},
        Asked{"OffCentredPressingHard", off_centred_scene(),
              [](Scene& s) { s.limits.normal_min = 3.0; },
              "scene.limits.normal_force.min", "would press less on it"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Contacts, AskedLimits,
    ::testing::Values(
        Asked{"OptimalWithoutHump", optimal(uniform_scene()),
              [](Scene& s) { s.limits.curvature.valley = 2.0; },
              "scene.contact", "fold into a kink"},
        Asked{"OptimalWithAHumpThatFolds", optimal(uniform_scene()),
              [](Scene& s) {
                s.limits.curvature = {3.1, 2.0, CurvatureLimit::Of::Centre};
              },
              "scene.contact", "fold into a kink"},
        Asked{"OptimalWithNoMargin", optimal(uniform_scene()),
              [](Scene& s) {
                s.limits.fold_margin = 0.0;
                s.limits.normal_max = 5.0;
              },
              "scene.contact", "fold into a kink"},
        Asked{"OptimalWithoutValley", optimal(uniform_scene()),
              [](Scene& s) { s.limits.fold_margin = 0.1; }, "scene.contact",
              "turns upwards"},
        Asked{"OptimalWithFrictionAlone", optimal(uniform_scene()),
              [](Scene& s) {
                s.limits.fold_margin = 0.1;
                s.limits.friction = 0.5;
              },
              "scene.contact", "turns upwards"},
        Asked{"OptimalWithALoad", optimal(uniform_scene()),
              [](Scene& s) {
                s.limits.fold_margin = 0.1;
                s.limits.normal_max = 5.0;
              },
              "", ""},
        Asked{"OptimalBetweenCurvatures", optimal(off_centred_scene()),
              [](Scene& s) {
                s.limits.curvature = {2.0, 2.0};
              },
              "", ""},
        Asked{"OptimalBead", optimal(bead_scene()), no_limit, "", ""},
        Asked{"SlopeWithoutLimits", with_end_slope(uniform_scene(), -0.1),
              no_limit, "scene.contact.end_slope", "a kink at B"},
        Asked{"SlopeWithALoad", with_end_slope(uniform_scene(), -0.1),
              [](Scene& s) {
                s.limits.curvature.hump = 2.0;
                s.limits.normal_max = 5.0;
              },
              "scene.contact.end_slope", "a kink at B"},
        Asked{"SlopeOfABead", with_end_slope(bead_scene(), -0.1),
              [](Scene& s) { s.limits.curvature.valley = 2.0; },
              "scene.contact.end_slope", "a kink at B"},
        Asked{"SlopeBetweenCurvatures", with_end_slope(uniform_scene(), -0.1),
              [](Scene& s) {
                s.limits.curvature = {2.0, 2.0};
              },
              "", ""},
        Asked{"CentreWithLimits", between_centres(off_centred_scene()),
              [](Scene& s) { s.limits.friction = 1.0; }, "", ""}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Places, AskedLimits,
    ::testing::Values(
        Asked{"FloorAboveB", uniform_scene(),
              [](Scene& s) { s.limits.floor = 0.99; }, "scene.limits.floor",
              "0.99 m is not allowed: it must be more than H = 1 m"},
        Asked{"FloorAtB", uniform_scene(),
              [](Scene& s) { s.limits.floor = 1.0; }, "scene.limits.floor",
              "1 m is not allowed: it must be more than H = 1 m"},
        Asked{"FloorBelowB", uniform_scene(),
              [](Scene& s) { s.limits.floor = 1.01; }, "", ""},
        Asked{"FloorAboveTheEndOfABead", bead_scene(),
              [](Scene& s) { s.limits.floor = 0.99; }, "scene.limits.floor",
              "0.99 m is not allowed: it must be at least 1 m"},
        Asked{"FloorOfTheCentre", between_centres(uniform_scene()),
              [](Scene& s) { s.limits.floor = 1.3; }, "scene.limits.floor",
              "1.3 m is not allowed: it must be at least 1.3333"},
        Asked{"FloorUnderTheCentre", between_centres(uniform_scene()),
              [](Scene& s) { s.limits.floor = 4.0 / 3.0; }, "", ""},
        Asked{"FloorAtALevelEnd", with_end_slope(uniform_scene(), 0.0),
              [](Scene& s) {
                s.limits.curvature = {2.0, 2.0};
                s.limits.floor = 1.0;
              },
              "", ""},
        // Lowest point H + r (1 − cos φ) = 1 + 1/6 at φ = 60°.
        Asked{"FloorAtASteepEnd", with_end_slope(uniform_scene(), -kPi / 3.0),
              [](Scene& s) {
                s.limits.curvature = {2.0, 2.0};
                s.limits.floor = 1.166;
              },
              "scene.limits.floor",
              "1.166 m is not allowed: it must be at least 1.1666"},
        // A body that starts straight down reaches r below A.
        Asked{"FloorAboveTheStart", uniform_scene(),
              [](Scene& s) {
                s.H = 0.2;
                s.limits.floor = 0.3;
              },
              "scene.limits.floor", "which the body reaches at the start"},
        Asked{"DiscAroundA", uniform_scene(),
              [](Scene& s) {
                s.limits.discs = {{{0.1, 0.0}, 0.11}};
              },
              "scene.limits.clear_of",
              "disc number 1 is not allowed: A = (0, 0) lies in it"},
        Asked{"DiscAroundB", uniform_scene(),
              [](Scene& s) {
                s.limits.discs = {{{0.1, 2.0}, 0.1}, {{3.0, 1.5}, 0.6}};
              },
              "scene.limits.clear_of",
              "disc number 2 is not allowed: B = (3, 1) lies in it"},
        Asked{"DiscBesideB", uniform_scene(),
              [](Scene& s) {
                s.limits.discs = {{{3.0, 1.5}, 0.4}};
              },
              "", ""},
        Asked{"DiscWithinReachOfTheCentre", between_centres(uniform_scene()),
              [](Scene& s) {
                s.limits.discs = {{{3.0, 1.5}, 0.4}};
              },
              "scene.limits.clear_of", "B = (3, 1) lies within r of it"},
        Asked{"HalfPlaneBeforeB", uniform_scene(),
              [](Scene& s) {
                s.limits.half_planes = {{{2.9, 0.0}, kPi}};
              },
              "scene.limits.clear_of",
              "half_plane number 1 is not allowed: B = (3, 1) lies in it"},
        Asked{"EdgeThroughB", uniform_scene(),
              [](Scene& s) {
                s.limits.half_planes = {{{0.0, 1.0}, -0.5 * kPi}};
              },
              "scene.limits.clear_of",
              "half_plane number 1 is not allowed: B = (3, 1) lies 0 m from "
              "its edge; it must be more than 0 m"},
        Asked{"EdgeThroughBAlongTheTrack", with_end_slope(uniform_scene(), 0.0),
              [](Scene& s) {
                s.limits.half_planes = {{{0.0, 1.0}, -0.5 * kPi}};
                s.limits.curvature = {1.0, 1.0};
              },
              "", ""},
        Asked{"HalfPlaneBehindB", uniform_scene(),
              [](Scene& s) {
                s.limits.half_planes = {{{3.1, 0.0}, kPi}};
              },
              "", ""}),
    name_of);

// On an incline of slope β a body of moment k needs the friction
// k/(1 + k) tan β, the third of tan β for a solid cylinder; with the moment
// c r R_n against its rotation c/(1 + k) more.
TEST(LimitsOfFriction, HaveToCarryABodyWithoutOffsetToB) {
  for (const auto& [k, c] : {std::pair(0.25, 0.0), std::pair(0.5, 0.0),
                             std::pair(1.0, 0.0), std::pair(0.5, 0.03)}) {
    Scene scene = scene_of(Body::cylinder(0.2, 0.0, 0.0, k));
    scene.world.losses.rolling = c;
    const double incline = (k * scene.H / scene.L + c) / (1.0 + k);
    for (const Contact contact : {Contact::Smooth, Contact::Centre}) {
      scene.contact = contact;
      scene.limits.friction = incline;
      EXPECT_THAT(validate(scene), IsEmpty()) << k;
      scene.limits.friction = 0.999 * incline;
      const auto errors = validate(scene);
      ASSERT_EQ(errors.size(), 1U) << k;
      EXPECT_EQ(errors[0].key, "scene.limits.friction");
      EXPECT_THAT(errors[0].message, HasSubstr(c > 0.0 ? "(k H/L + c)/(1 + k)"
                                                       : "(k/(1 + k)) H/L"));
    }
  }
}

/// The least friction without slip from rest in some direction that leads
/// down: with F = R_n A, |k a − η cos δ F| ≤ μ (1 − η sin δ) F, which follows
/// from the angular momentum about the centre of mass.
double least_friction_at_rest(const Body& body) {
  double least = std::numeric_limits<double>::infinity();
  const double eta = body.eta_m;
  for (double beta = -kPi; beta < kPi; beta += 1e-5) {
    const double delta = body.theta_m - beta;
    const double a = std::sin(beta) + eta * std::cos(body.theta_m);
    const double A = 1.0 + eta * eta + body.k - 2.0 * eta * std::sin(delta);
    const double F = A * std::cos(beta) - a * eta * std::cos(delta);
    if (a <= 0.0 || F <= 0.0) continue;
    const double slip = std::abs(body.k * a - eta * std::cos(delta) * F);
    least = std::min(least, slip / ((1.0 - eta * std::sin(delta)) * F));
  }
  return least;
}

// With the centre of mass on the left the weight, too, pulls the body back.
TEST(LimitsOfFriction, HaveToHoldAnOffCentredBodyAtRest) {
  for (const double theta_m : {-2.8, -2.6, 2.6, 2.8, 3.1}) {
    Scene scene = off_centred_scene(theta_m);
    const double least = least_friction_at_rest(scene.body);
    SCOPED_TRACE(::testing::Message() << theta_m << ", μ ≥ " << least);
    ASSERT_GT(least, 0.1);
    scene.limits.friction = 1.05 * least;
    EXPECT_THAT(validate(scene), IsEmpty());
    scene.limits.friction = 0.99 * least;
    const auto errors = validate(scene);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].key, "scene.limits.friction");
    EXPECT_THAT(errors[0].message, HasSubstr("the body would slip at rest"));
  }
}

TEST(LimitsAndAGivenPath, ExcludeEachOther) {
  Scene scene = uniform_scene();
  scene.path = std::make_shared<const GivenPath>();
  EXPECT_THAT(validate(scene), IsEmpty());
  scene.contact = Contact::Optimal;
  scene.limits.friction = 0.5;

  std::vector<std::string> keys;
  for (const SceneError& error : validate(scene)) keys.push_back(error.key);

  EXPECT_THAT(keys, ElementsAre("scene.limits", "scene.contact"));
}

// Of numbers that are wrong in themselves no more is asked.
TEST(Limits, AreHeldAgainstEachOtherOnlyIfTheyAreSound) {
  Scene scene = uniform_scene();
  scene.contact = Contact::Optimal;
  scene.limits.curvature = {kNaN, 2.0};
  const auto errors = validate(scene);

  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].key, "scene.limits.curvature.hump");
}

}  // namespace
}  // namespace brachisto::testing
