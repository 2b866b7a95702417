// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/many_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

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

double transit_time(const Scene& scene, const Extremal& found) {
  return found.transit_time * natural_units(scene).time;
}

struct Attempt {
  const char* name;
  Fineness fineness;
  bool in_air, pushed;
  int least_served;
};
class ManyScenesTried : public testing::TestWithParam<Attempt> {};

TEST_P(ManyScenesTried, HaveTheTimesOfTheIndirectMethodOfOne) {
  std::vector<Scene> scenes = random_scenes(24);
  if (GetParam().in_air) scenes = in_airs(std::move(scenes));
  if (GetParam().pushed) scenes = with_pushes(std::move(scenes));

  const std::vector<Extremal> found = shoot(scenes, GetParam().fineness);

  int served = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!found[i].found) continue;
    ++served;
    const ExtremalSolution alone = solve_extremal(scenes[i]);
    ASSERT_TRUE(alone.usable()) << i << ": " << alone.message;
    EXPECT_NEAR(transit_time(scenes[i], found[i]) / alone.transit_time, 1.0,
                found[i].error_estimate + alone.error_estimate)
        << i;
    // The end of a path is as far off as its steps are, to the first order.
    EXPECT_NEAR(found[i].phi, alone.phi, 1e-9 + 1e3 * found[i].error_estimate)
        << i;
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
                    Attempt{"FinePushedInAir", kFine, true, true, 16}),
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
  const ExtremalSolution alone = solve_extremal(scene);
  ASSERT_TRUE(alone.usable()) << alone.message;
  EXPECT_NEAR(transit_time(scene, found) / alone.transit_time, 1.0,
              found.error_estimate + alone.error_estimate);
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
  const ExtremalSolution alone = solve_extremal(scene);
  ASSERT_TRUE(alone.usable()) << alone.message;
  EXPECT_NEAR(transit_time(scene, found) / alone.transit_time, 1.0,
              found.error_estimate + alone.error_estimate);
}

TEST(ManyScenes, HaveTheSameDigitsWhateverStandsBesideThem) {
  std::vector<Scene> scenes = random_scenes(11);
  for (const std::vector<Scene>& others :
       {in_airs(random_scenes(5)), with_pushes(random_scenes(3)),
        with_pushes(in_airs(random_scenes(3)))}) {
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
       {in_airs(random_scenes(16)), with_pushes(in_airs(random_scenes(16)))}) {
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
