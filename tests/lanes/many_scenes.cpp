// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/many_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "trajectory/lane_motion.hpp"

namespace brachisto::lanes {
namespace {

/// Scenes about the paper's, some of which have no answer.
std::vector<Scene> random_scenes(std::size_t count) {
  std::mt19937 random(38);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<Scene> scenes(count);
  for (Scene& scene : scenes) {
    const double eta = between(0.0, 0.9);
    const double k = between(0.0, 1.0) * largest_k(eta);
    scene.body = Body::cylinder(between(0.15, 0.5), eta, between(-1.5, 1.5), k);
    scene.L = between(1.5, 4.0);
    scene.H = between(0.7, 1.5);
  }
  return scenes;
}

/// The same, each in an air of its own.
std::vector<Scene> in_airs(std::vector<Scene> scenes) {
  std::mt19937 random(39);
  const auto up_to = [&](double most) {
    return most * static_cast<double>(random()) / 4294967296.0;
  };
  for (Scene& scene : scenes) scene.world.air = {up_to(0.5), up_to(0.2)};
  return scenes;
}

/// The same, each with a push of its own.
std::vector<Scene> with_pushes(std::vector<Scene> scenes) {
  std::mt19937 random(40);
  for (Scene& scene : scenes) {
    scene.world.start_speed =
        0.1 + 2.9 * static_cast<double>(random()) / 4294967296.0;
  }
  return scenes;
}

/// The same, each in the field of a planet of its own, below all of it or about
/// it.
std::vector<Scene> by_planets(std::vector<Scene> scenes) {
  std::mt19937 random(41);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const bool below = i % 2 == 0;
    scenes[i].world.sphere =
        Sphere{{between(1.0, 4.0), between(9.5, 15.0)},
               below ? between(2.0, 6.5) : between(17.5, 30.0),
               between(3.0, 20.0)};
  }
  return scenes;
}

double transit_time(const Scene& scene, const Extremal& found) {
  return found.transit_time * natural_units(scene).time;
}

/// That its time is the one of the indirect method of one scene, by both
/// estimates, and its end too.
void expect_its_own(const Scene& scene, const Extremal& found) {
  const ExtremalSolution alone = solve_extremal(scene);
  ASSERT_TRUE(alone.usable()) << alone.message;
  EXPECT_NEAR(transit_time(scene, found) / alone.transit_time, 1.0,
              found.error_estimate + alone.error_estimate);
  // The end of a path is as far off as its steps are, to the first order.
  EXPECT_NEAR(found.phi, alone.phi, 1e-9 + 1e3 * found.error_estimate);
}

struct Attempt {
  const char* name;
  Fineness fineness;
  bool in_air, pushed;
  int least_served;
  bool by_planet = false;
};
class ManyScenesTried : public testing::TestWithParam<Attempt> {};

TEST_P(ManyScenesTried, HaveTheTimesOfTheIndirectMethodOfOne) {
  std::vector<Scene> scenes = random_scenes(24);
  if (GetParam().in_air) scenes = in_airs(std::move(scenes));
  if (GetParam().pushed) scenes = with_pushes(std::move(scenes));
  if (GetParam().by_planet) scenes = by_planets(std::move(scenes));

  const std::vector<Extremal> found = shoot(scenes, GetParam().fineness);

  int served = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!found[i].found) continue;
    ++served;
    SCOPED_TRACE(i);
    expect_its_own(scenes[i], found[i]);
  }
  EXPECT_GE(served, GetParam().least_served);
}

INSTANTIATE_TEST_SUITE_P(
    Finenesses, ManyScenesTried,
    testing::Values(Attempt{"Plain", kPlain, false, false, 16},
                    Attempt{"Fine", kFine, false, false, 19},
                    Attempt{"PlainInAir", kPlain, true, false, 16},
                    Attempt{"FineInAir", kFine, true, false, 19},
                    Attempt{"PlainPushed", kPlain, false, true, 16},
                    Attempt{"FinePushedInAir", kFine, true, true, 16},
                    Attempt{"PlainByPlanets", kPlain, false, false, 14, true},
                    Attempt{"FineByPlanets", kFine, false, false, 18, true},
                    Attempt{"PlainPushedInAirByPlanets", kPlain, true, true, 9,
                            true}),
    [](const auto& one) { return one.param.name; });

/// A path that turns quickly is interpolated between the places that are kept:
/// with 64 of them, whatever the steps, the speed there missed the energy.
TEST(ManyScenes, KeepPlacesCloseEnoughForTheEnergyBetweenThem) {
  Scene scene;
  scene.body = Body::cylinder(0.182, 0.3366, 1.422, 0.0174);
  scene.L = 3.3655;
  scene.H = 1.0;
  scene.world.air = {0.1407, 0.0322};

  const Extremal found = shoot(std::vector{scene}, kFine).front();

  ASSERT_TRUE(found.found);
  expect_its_own(scene, found);
  const Units units = natural_units(scene);
  const Certificate certificate =
      certify(LaneMotion(in_natural_units(scene), found, scene, units));
  EXPECT_TRUE(certificate.verified())
      << testing::PrintToString(not_verified_because(certificate));
}

TEST(ManyScenes, HaveTheClosedFormWithoutOffset) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 0.0, 0.4, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;

  const Extremal found = shoot(std::vector{scene}).front();

  ASSERT_TRUE(found.found);
  const double T =
      axisymmetric_optimum(scene)->rolling_time(scene.gravity) * std::sqrt(1.5);
  EXPECT_NEAR(transit_time(scene, found) / T, 1.0,
              found.error_estimate + 4.0 * kUlp);
}

/// Pushed, the centre takes a part of a cycloid whose cusp lies w₀²/(2 g) above
/// A, from ψ₀ to ψ₁: T = √A √(R/g) (ψ₁ − ψ₀).
TEST(ManyScenes, HaveTheRaisedCycloidOfAPushWithoutOffset) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  constexpr double kFrom = 0.7, kTo = 3.6, kR = 0.6, kA = 1.5;
  Scene scene;
  scene.body = Body::cylinder(0.2, 0.0, 0.4, kA - 1.0);
  scene.contact = Contact::Centre;
  scene.L = kR * (kTo - std::sin(kTo) - kFrom + std::sin(kFrom));
  scene.H = kR * (std::cos(kFrom) - std::cos(kTo));
  scene.world.start_speed =
      std::sqrt(2.0 * scene.gravity * kR * (1.0 - std::cos(kFrom)) / kA);

  const Extremal found = shoot(std::vector{scene}).front();

  ASSERT_TRUE(found.found);
  const double T = std::sqrt(kA * kR / scene.gravity) * (kTo - kFrom);
  EXPECT_NEAR(transit_time(scene, found) / T, 1.0,
              found.error_estimate + 4.0 * kUlp);
  // dz/dx = cot(ψ/2)
  EXPECT_NEAR(found.path.front().beta, 0.5 * (std::numbers::pi - kFrom), 1e-9);
}

/// T goes with the slope at A to the first order: what is left of Newton's
/// method there is an error that no doubled steps show.
TEST(ManyScenes, LeaveAPushInItsOwnDirectionFarFromThatOfRest) {
  Scene scene;
  scene.body = Body::cylinder(0.324, 0.281, -2.139, 0.192);
  scene.L = 4.187;
  scene.H = 1.0;
  scene.world.air = {0.369, 0.132};
  scene.world.start_speed = 2.962;

  const Extremal found = shoot(std::vector{scene}, kFine).front();

  ASSERT_TRUE(found.found);
  expect_its_own(scene, found);
}

TEST(ManyScenes, HaveTheSameDigitsWhateverStandsBesideThem) {
  std::vector<Scene> scenes = random_scenes(11);
  for (const std::vector<Scene>& others :
       {in_airs(random_scenes(5)), with_pushes(random_scenes(3)),
        with_pushes(in_airs(random_scenes(3))), by_planets(random_scenes(6)),
        by_planets(in_airs(random_scenes(3)))}) {
    scenes.insert(scenes.begin() + 4, others.begin(), others.end());
  }

  const std::vector<Extremal> together = shoot(scenes);

  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Extremal alone = shoot(std::vector{scenes[i]}).front();
    ASSERT_EQ(alone.found, together[i].found) << i;
    if (!alone.found) continue;
    EXPECT_EQ(alone.transit_time, together[i].transit_time) << i;
    EXPECT_EQ(alone.error_estimate, together[i].error_estimate) << i;
    EXPECT_EQ(alone.path[7].beta_rate, together[i].path[7].beta_rate) << i;
  }
}

TEST(ManyScenes, HaveTheSameDigitsWithAllInstructions) {
  std::vector<Scene> scenes = random_scenes(16);
  for (const std::vector<Scene>& others :
       {in_airs(random_scenes(16)), with_pushes(in_airs(random_scenes(16))),
        by_planets(random_scenes(16)),
        by_planets(with_pushes(in_airs(random_scenes(16))))}) {
    scenes.insert(scenes.end(), others.begin(), others.end());
  }
  const std::vector<Extremal> baseline =
      shoot(scenes, kFine, Instructions::Baseline);
  for (const Instructions set : {Instructions::Avx2, Instructions::Avx512}) {
    if (static_cast<int>(set) > static_cast<int>(best_instructions())) continue;

    const std::vector<Extremal> wide = shoot(scenes, kFine, set);

    for (std::size_t i = 0; i < scenes.size(); ++i) {
      ASSERT_EQ(wide[i].found, baseline[i].found) << i;
      if (!wide[i].found) continue;
      EXPECT_EQ(wide[i].transit_time, baseline[i].transit_time) << i;
      EXPECT_EQ(wide[i].by_length, baseline[i].by_length) << i;
      EXPECT_EQ(wide[i].path[20].beta, baseline[i].path[20].beta) << i;
    }
  }
}

/// In air w is a state of its own, and conditions of the second order are of
/// three states; with little of it they are those of the two that there are
/// without: ∂²T/∂S² differs by what the air changes of it.
class ManyScenesLeaving
    : public testing::TestWithParam<std::vector<Scene> (*)()> {};

TEST_P(ManyScenesLeaving, HaveInThinAirTheSecondDerivativeOfFreeOnes) {
  const std::vector<Scene> scenes = GetParam()();
  std::vector<Scene> thin = scenes, thinner = scenes;
  for (Scene& scene : thin) scene.world.air = {4e-3, 4e-3};
  for (Scene& scene : thinner) scene.world.air = {2e-3, 2e-3};

  const std::vector<Extremal> free = shoot(scenes), most = shoot(thin),
                              least = shoot(thinner);

  for (std::size_t i = 0; i < scenes.size(); ++i) {
    ASSERT_EQ(most[i].found, free[i].found) << i;
    ASSERT_EQ(least[i].found, free[i].found) << i;
    if (!free[i].found) continue;
    const double change = least[i].by_length - free[i].by_length;
    EXPECT_NEAR(change / free[i].by_length, 0.0, 0.1) << i;
    // But for its square, and for rounding, of which 1/(air)² is seen.
    EXPECT_NEAR((most[i].by_length - free[i].by_length) / change, 2.0, 0.1)
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(FromRestOrPushed, ManyScenesLeaving,
                         testing::Values(
                             +[] { return random_scenes(24); },
                             +[] { return with_pushes(random_scenes(24)); }));

/// Of a determinant that goes as the air squared truncation and rounding leave
/// nothing: its sign would be theirs, of a saddle as of a minimum.
TEST(ManyScenes, SayNothingOfTheSecondOrderInAirThatIsTooThinForIt) {
  const std::vector<Scene> scenes = random_scenes(24);
  std::vector<Scene> thin = scenes;
  for (Scene& scene : thin) scene.world.air = {1e-6, 0.0};

  for (const Fineness& fineness : {kPlain, kFine}) {
    const std::vector<Extremal> free = shoot(scenes, fineness),
                                braked = shoot(thin, fineness);

    for (std::size_t i = 0; i < scenes.size(); ++i) {
      EXPECT_FALSE(braked[i].found) << i;
      // Apart from that it is the same extremal.
      if (!free[i].found) continue;
      EXPECT_NEAR(braked[i].transit_time / free[i].transit_time, 1.0, 1e-5)
          << i;
    }
  }
}

/// Turned about its own centre a planet is the same: the scene has the time of
/// the one that was turned with it, in which the pull at A is another.
TEST(ManyScenes, HaveInTheFieldOfAPlanetNoDirectionThatIsTheVertical) {
  constexpr double kTurn = 0.3;
  Scene scene;
  scene.body = Body::cylinder(0.3, 0.4, 0.5, 0.3);
  scene.L = 3.0;
  scene.H = 1.5;
  scene.world.sphere = Sphere{{1.0, 8.0}, 3.0, 50.0};
  Scene turned = scene;
  const double c = std::cos(kTurn), s = std::sin(kTurn);
  turned.L = c * scene.L - s * scene.H;
  turned.H = s * scene.L + c * scene.H;
  turned.world.sphere->centre = {c * 1.0 - s * 8.0, s * 1.0 + c * 8.0};
  turned.body.theta_m += kTurn;

  const std::vector<Extremal> found = shoot(std::vector{scene, turned}, kFine);

  ASSERT_TRUE(found[0].found && found[1].found);
  EXPECT_NEAR(transit_time(turned, found[1]) / transit_time(scene, found[0]),
              1.0, found[0].error_estimate + found[1].error_estimate);
  // Second derivatives by lengths, of times in seconds per square metre.
  const auto by_length = [](const Scene& of, const Extremal& one) {
    const Units units = natural_units(of);
    return one.by_length * units.time / (units.length * units.length);
  };
  EXPECT_NEAR(by_length(turned, found[1]) / by_length(scene, found[0]), 1.0,
              1e-7);
  EXPECT_NEAR(found[1].phi - found[0].phi, kTurn, 1e-9);
}

/// The saddle of docs/robustness.md (scene 418), and what a push makes of it: a
/// minimum, if it is large enough.
TEST(ManyScenes, RefuseAPushedSaddleAndServeTheMinimumThatAPushMakesOfIt) {
  for (const double linear_drag : {0.0, 0.1}) {
    for (const double speed : {0.05, 0.2}) {
      Scene scene;
      scene.body = Body::cylinder(0.38522, 0.63445, -1.2318, 0.50532);
      scene.L = 2.9236;
      scene.H = 1.0;
      scene.world.start_speed = speed;
      scene.world.air.linear = linear_drag;

      const Extremal found = shoot(std::vector{scene}, kFine).front();

      const Solution alone = solve(scene);
      ASSERT_EQ(alone.status, Status::Solved);
      EXPECT_EQ(alone.verified(), speed == 0.2);
      EXPECT_EQ(found.found, speed == 0.2) << speed << ", " << linear_drag;
      if (!alone.verified()) {
        ASSERT_NE(alone.certificate.find("second_order"), nullptr);
        EXPECT_FALSE(alone.certificate.find("second_order")->passed);
      }
      // It is closed either way.
      EXPECT_NEAR(transit_time(scene, found) / alone.motion()->transit_time(),
                  1.0, found.error_estimate + *alone.estimated_error);
    }
  }
}

/// With the law of one side on both it would be another field.
TEST(ManyScenes, LeaveOutPathsThroughTheSurfaceOfAPlanet) {
  Scene scene;
  scene.body = Body::cylinder(0.2, 0.3, 0.3, 0.3);
  scene.L = 3.0;
  scene.H = 1.0;
  scene.world.sphere = Sphere{{1.0, 10.0}, 9.3, 9.81};

  EXPECT_TRUE(fits(scene));
  EXPECT_FALSE(shoot(std::vector{scene}, kFine).front().found);
  scene.world.sphere->radius = 8.0;
  EXPECT_TRUE(shoot(std::vector{scene}, kFine).front().found);
}

TEST(ManyScenes, LeaveOutWhatIsNotFreeAndWhatHasNoCycloid) {
  std::vector<Scene> scenes = random_scenes(3);
  scenes[0].limits.friction = 0.5;
  scenes[1].L = 0.2;  // B lies inside the body at its start
  scenes[1].H = 0.1;
  scenes[1].body.radius = 1.0;

  const std::vector<Extremal> found = shoot(scenes);

  EXPECT_FALSE(fits(scenes[0]));
  EXPECT_FALSE(found[0].found);
  EXPECT_FALSE(found[1].found);
}

}  // namespace
}  // namespace brachisto::lanes
