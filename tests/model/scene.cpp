// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "support/numbers.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// One way to spoil a good scene, and what is to be said about it.
struct Spoiled {
  const char* name;
  Scene scene;
  const char* key;
  const char* message;
};

template <class Spoil>
Spoiled spoil(const char* name, Scene scene, Spoil&& change, const char* key,
              const char* message) {
  change(scene);
  return {name, scene, key, message};
}

void PrintTo(const Spoiled& spoiled, std::ostream* out) {
  *out << spoiled.name;
}

class Validate : public ::testing::TestWithParam<Spoiled> {};

TEST_P(Validate, NamesTheKeyTheValueAndTheBound) {
  const std::vector<SceneError> errors = validate(GetParam().scene);

  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].key, GetParam().key);
  EXPECT_EQ(errors[0].message, GetParam().message);
}

constexpr const char* kBeadHasNone =
    "a bead is a point mass and has no such property";

INSTANTIATE_TEST_SUITE_P(
    Scenes, Validate,
    ::testing::Values(
        spoil(
            "ZeroRadius", uniform_scene(),
            [](Scene& s) { s.body.radius = 0.0; }, "scene.body.radius",
            "0 m is not allowed: it must be > 0, for the radius of a cylinder "
            "is a length"),
        spoil(
            "NegativeOffset", uniform_scene(),
            [](Scene& s) { s.body.eta_m = -0.25; }, "scene.body.eta_m",
            "-0.25 is not allowed: 0 ≤ η_m ≤ 1, for the centre of mass lies "
            "inside the cylinder"),
        spoil(
            "OffsetBeyondTheRim", uniform_scene(),
            [](Scene& s) { s.body.eta_m = 1.25; }, "scene.body.eta_m",
            "1.25 is not allowed: 0 ≤ η_m ≤ 1, for the centre of mass lies "
            "inside the cylinder"),
        spoil(
            "MassPointOnTheRim", uniform_scene(),
            [](Scene& s) {
              s.body.eta_m = 1.0;
              s.body.k = 0.0;
            },
            "scene.body.eta_m",
            "1 is not allowed: all mass would sit in one point of the rim "
            "(k = 0), whose speed, and with it the inertia factor A, vanishes "
            "whenever that point touches the track"),
        spoil(
            "NegativeInertia", uniform_scene(),
            [](Scene& s) { s.body.k = -0.5; }, "scene.body.k",
            "-0.5 is not allowed: 0 ≤ k, for a moment of inertia is not "
            "negative"),
        spoil(
            "MoreInertiaThanTheRimAllows", off_centred_scene(),
            [](Scene& s) {
              s.body.eta_m = 0.5;
              s.body.k = 0.875;
            },
            "scene.body.k",
            "0.875 is not allowed: k ≤ 1 − η_m² = 0.75 for η_m = 0.5, reached "
            "when all mass sits on the rim"),
        spoil(
            "FinishStraightBelow", uniform_scene(), [](Scene& s) { s.L = 0.0; },
            "scene.finish.L",
            "0 m is not allowed: it must be > 0, for B lies to the right of A"),
        spoil(
            "FinishAbove", uniform_scene(), [](Scene& s) { s.H = -1.0; },
            "scene.finish.H",
            "-1 m is not allowed: it must be > 0, for B lies below A (z points "
            "down)"),
        spoil(
            "NoGravity", uniform_scene(), [](Scene& s) { s.gravity = 0.0; },
            "scene.gravity",
            "0 m/s² is not allowed: it must be > 0, for it is what moves the "
            "body"),
        spoil(
            "NoMass", uniform_scene(), [](Scene& s) { s.body.mass = 0.0; },
            "scene.body.mass",
            "0 kg is not allowed: it must be > 0, for it turns forces into "
            "newtons"),
        spoil(
            "RadiusNotANumber", uniform_scene(),
            [](Scene& s) { s.body.radius = kNaN; }, "scene.body.radius",
            "nan is not a finite number"),
        spoil(
            "OffsetNotANumber", uniform_scene(),
            [](Scene& s) { s.body.eta_m = kNaN; }, "scene.body.eta_m",
            "nan is not a finite number"),
        spoil(
            "AngleInfinite", uniform_scene(),
            [](Scene& s) { s.body.theta_m = -kInfinity; }, "scene.body.theta_m",
            "-inf is not a finite number"),
        spoil(
            "InertiaNotANumber", uniform_scene(),
            [](Scene& s) { s.body.k = kNaN; }, "scene.body.k",
            "nan is not a finite number"),
        spoil(
            "FinishInfinitelyFar", bead_scene(),
            [](Scene& s) { s.L = kInfinity; }, "scene.finish.L",
            "inf is not a finite number"),
        spoil(
            "DropNotANumber", bead_scene(), [](Scene& s) { s.H = kNaN; },
            "scene.finish.H", "nan is not a finite number"),
        spoil(
            "GravityNotANumber", bead_scene(),
            [](Scene& s) { s.gravity = kNaN; }, "scene.gravity",
            "nan is not a finite number"),
        spoil(
            "MassNotANumber", bead_scene(),
            [](Scene& s) { s.body.mass = kNaN; }, "scene.body.mass",
            "nan is not a finite number"),
        spoil(
            "BeadWithRadius", bead_scene(),
            [](Scene& s) { s.body.radius = 0.5; }, "scene.body.radius",
            kBeadHasNone),
        spoil(
            "BeadWithOffset", bead_scene(),
            [](Scene& s) { s.body.eta_m = 0.5; }, "scene.body.eta_m",
            kBeadHasNone),
        spoil(
            "BeadWithAngle", bead_scene(),
            [](Scene& s) { s.body.theta_m = kNaN; }, "scene.body.theta_m",
            kBeadHasNone),
        spoil(
            "BeadWithInertia", bead_scene(), [](Scene& s) { s.body.k = 0.5; },
            "scene.body.k", kBeadHasNone)),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ValidateScene, AcceptsGoodScenes) {
  Scene heavy = bead_scene();
  heavy.body.mass = 2.5;

  EXPECT_TRUE(validate(heavy).empty());
  EXPECT_TRUE(validate(bead_scene()).empty());
  EXPECT_TRUE(validate(uniform_scene()).empty());
  EXPECT_TRUE(validate(off_centred_scene(-kPi / 6.0)).empty());
}

TEST(ValidateScene, AcceptsTheBoundsThemselves) {
  EXPECT_TRUE(validate(scene_of(Body::cylinder(0.5, 0.0, 0.0, 0.0))).empty());
  EXPECT_TRUE(validate(scene_of(Body::cylinder(0.5, 0.0, 0.0, 1.0))).empty());
  EXPECT_TRUE(validate(scene_of(Body::cylinder(0.5, 0.5, 0.0, 0.75))).empty());
}

TEST(ValidateScene, AllowsForRoundingOfInertiaOnTheRim) {
  // 1/√2 rounded up, as √(1/2) is: ½ is then more than 1 − η².
  const double eta = std::sqrt(0.5);
  const double k = 0.5;

  ASSERT_GT(k, (1.0 - eta) * (1.0 + eta)) << "the case is no longer hard";
  EXPECT_TRUE(validate(scene_of(Body::cylinder(0.5, eta, 0.0, k))).empty());
  EXPECT_TRUE(
      validate(scene_of(Body::cylinder(0.5, 1.0 / std::sqrt(2.0), 0.0, k)))
          .empty());
}

TEST(ValidateScene, AllowsForRoundingAndNoMore) {
  const double eta = 1.0 / std::sqrt(2.0);
  const double k = 0.5 + 2.0 * kBoundSlack;

  EXPECT_EQ(validate(scene_of(Body::cylinder(0.5, eta, 0.0, k))).size(), 1U);
}

TEST(ValidateScene, ReportsEverythingAtOnce) {
  Scene scene = scene_of(Body::cylinder(-1.0, 2.0, kNaN, -3.0));
  scene.L = -1.0;
  scene.H = 0.0;
  scene.gravity = -9.81;

  std::vector<std::string> keys;
  for (const SceneError& error : validate(scene)) keys.push_back(error.key);

  EXPECT_THAT(keys, ::testing::UnorderedElementsAre(
                        "scene.body.radius", "scene.body.eta_m",
                        "scene.body.theta_m", "scene.body.k", "scene.finish.L",
                        "scene.finish.H", "scene.gravity"));
}

/// The keys that are refused.
std::vector<std::string> refused(const Scene& scene) {
  std::vector<std::string> keys;
  for (const SceneError& error : validate(scene)) keys.push_back(error.key);
  return keys;
}

TEST(Validate, RefusesWhatProductsOfSixCannotCarry) {
  using ::testing::ElementsAre;
  using ::testing::HasSubstr;
  using ::testing::IsEmpty;
  // Six factors 1e-50 or 1e50 are normal numbers, which end near 1e±308.
  EXPECT_TRUE(std::isnormal(std::pow(kSmallestQuantity, 6)));
  EXPECT_TRUE(std::isnormal(std::pow(kLargestQuantity, 6)));
  for (const double outside : {5e-324, 0.99e-50, 1.01e50, 1.7e308}) {
    Scene scene = off_centred_scene();
    scene.L = scene.H = scene.gravity = scene.body.radius = outside;
    scene.body.mass = outside;

    EXPECT_THAT(refused(scene), ElementsAre("scene.body.radius",
                                            "scene.body.mass", "scene.finish.L",
                                            "scene.finish.H", "scene.gravity"))
        << outside;
    EXPECT_THAT(validate(scene).front().message, HasSubstr("1e-50 to 1e+50"));
  }
  for (const double inside : {kSmallestQuantity, kLargestQuantity}) {
    Scene scene = off_centred_scene();
    scene.L = scene.H = scene.gravity = scene.body.radius = inside;
    EXPECT_THAT(refused(scene), IsEmpty()) << inside;
  }
}

TEST(Validate, TakesAnOffsetForNoneOnlyIfItIs) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  Scene scene = off_centred_scene();
  for (const double eta : {0.0, 1e-50, 1e-17}) {
    scene.body.eta_m = eta;
    EXPECT_THAT(refused(scene), IsEmpty()) << eta;
  }
  for (const double eta : {5e-324, 1e-51}) {
    scene.body.eta_m = eta;
    EXPECT_THAT(refused(scene), ElementsAre("scene.body.eta_m")) << eta;
  }
}

TEST(Validate, RefusesAnglesWhoseRoundingIsToBeSeen) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  EXPECT_THAT(refused(off_centred_scene(1e6)), IsEmpty());
  EXPECT_THAT(refused(off_centred_scene(-1e6)), IsEmpty());
  EXPECT_THAT(refused(off_centred_scene(1.0001e6)),
              ElementsAre("scene.body.theta_m"));
  // Half an ulp there, against the default tolerance 1e-10 of T.
  EXPECT_GT(0.5 * (std::nextafter(1e6, 2e6) - 1e6), 0.5e-10);
}

TEST(Validate, KnowsAllThatAnEnumerationMayBe) {
  using ::testing::ElementsAre;
  Scene scene = off_centred_scene();
  scene.contact = static_cast<Contact>(7);
  EXPECT_THAT(refused(scene), ElementsAre("scene.contact"));
  scene = off_centred_scene();
  scene.body.shape = static_cast<Shape>(-1);
  EXPECT_EQ(refused(scene).front(), "scene.body.shape");
}

TEST(Validate, HoldsTheEndsOfAPathAgainstEitherCoordinate) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  const auto ends_at = [](double x, double z) {
    Scene scene = bead_scene();
    scene.H = 1e-6;
    GivenPath path;
    path.curve = GivenPath::Curve::Track;
    path.shape = GivenPath::Shape::Points;
    path.points = {{0.0, 0.0}, {1.0, 1e-6}, {x, z}};
    scene.path = std::make_shared<const GivenPath>(path);
    return refused(scene);
  };
  const double H = 1e-6;
  EXPECT_THAT(ends_at(3.0, H), IsEmpty());
  EXPECT_THAT(ends_at(3.0 * (1.0 + 0.9e-6), H * (1.0 - 0.9e-6)), IsEmpty());
  // Far less than 1e-6 of L, and twice as low as it should be.
  EXPECT_THAT(ends_at(3.0, 2.0 * H), ElementsAre("scene.path.file"));
  EXPECT_THAT(ends_at(3.0, H * (1.0 + 2e-6)), ElementsAre("scene.path.file"));
  EXPECT_THAT(ends_at(3.0 * (1.0 + 2e-6), H), ElementsAre("scene.path.file"));
  EXPECT_THAT(ends_at(3.0, kInfinity).front(), "scene.path.file");
}

TEST(Validate, KnowsWhatSlopesLeadToB) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  // Straight down from A to B = (3, 1), 10% of the way too far, and so on.
  const SlopesAlong straight{
      std::sqrt(10.0), {0.0, 0.5, 1.0}, std::vector(3, std::atan2(1.0, 3.0))};
  const auto along = [](const SlopesAlong& slopes) {
    Scene scene = off_centred_scene();
    GivenPath path;
    path.shape = GivenPath::Shape::Slopes;
    path.slopes = slopes;
    scene.path = std::make_shared<const GivenPath>(path);
    return scene;
  };
  EXPECT_THAT(refused(along(straight)), IsEmpty());
  const auto bad = ElementsAre("scene.path.slopes");
  for (const std::vector<double>& places : {std::vector{0.0, 0.5},
                                            {0.1, 0.5, 1.0},
                                            {0.0, 0.5, 0.9},
                                            {0.0, 0.0, 1.0},
                                            {0.0, 1.0, 1.0},
                                            {0.0, kNan, 1.0}}) {
    SlopesAlong slopes = straight;
    slopes.q = places;
    EXPECT_THAT(refused(along(slopes)), bad);
  }
  SlopesAlong slopes = straight;
  slopes.length *= 1.1;
  EXPECT_THAT(refused(along(slopes)), bad);
  slopes = straight;
  slopes.q = {0.0, 0.5, 0.5, 1.0};
  slopes.beta.push_back(slopes.beta.back());
  EXPECT_THAT(refused(along(slopes)), IsEmpty());
  slopes.beta[2] += 1e-9;
  EXPECT_THAT(refused(along(slopes)), bad);

  // On the track of such a one.
  const auto beside = [&](const Scene& other) {
    Scene scene = off_centred_scene();
    GivenPath path;
    path.track_of = std::make_shared<const Scene>(other);
    scene.path = std::make_shared<const GivenPath>(path);
    return refused(scene);
  };
  const auto none = ElementsAre("scene.path.track_of");
  EXPECT_THAT(beside(along(straight)), IsEmpty());
  EXPECT_THAT(beside(off_centred_scene()), none);
  Scene wrong = along(straight);
  wrong.body.radius = 0.0;
  EXPECT_THAT(beside(wrong), none);
  wrong = along(straight);
  wrong.L = 4.0;
  wrong.path = std::make_shared<const GivenPath>();
  EXPECT_THAT(beside(wrong), none);
}

}  // namespace
}  // namespace brachisto::testing
