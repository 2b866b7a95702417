// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Everything that goes wrong ends in a status and a message, never in an
// exception or in a wrong answer.

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <numbers>

#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"
#include "support/processor_time.hpp"

namespace brachisto {
namespace {

using testing::base_scene;
using testing::FlagAfterWork;
using testing::scene_of;

TEST(Failure, WithoutACycloidIsSaid) {
  // r > H, and B so near that the centre would have to end above its start.
  const Scene scene = scene_of(Body::cylinder(1.5, 0.3, 0.0, 0.5), 1.0);

  const ExtremalSolution found = solve_extremal(scene);

  EXPECT_EQ(found.status, ExtremalStatus::NoCycloid);
  EXPECT_FALSE(found.message.empty());
  EXPECT_TRUE(found.path.empty());
}

TEST(Failure, OfAGuessThatCannotBeIntegratedNamesTheArc) {
  ExtremalGuess guess = cycloid_guess(base_scene());
  const auto cycloid = guess.state;
  guess.state = [cycloid](double sigma) {
    ExtremalState s = cycloid(sigma);
    if (sigma > 0.6) s.theta = std::numeric_limits<double>::quiet_NaN();
    return s;
  };

  const ExtremalSolution found =
      solve_extremal(base_scene(), guess, {.arcs = 4});

  EXPECT_EQ(found.status, ExtremalStatus::BadGuess);
  EXPECT_NE(found.message.find("arc 4 of 4"), std::string::npos)
      << found.message;
}

TEST(Failure, OfNewtonsMethodSaysHowFarItCame) {
  const ExtremalGuess guess = cycloid_guess(base_scene());

  const ExtremalSolution found =
      solve_extremal(base_scene(), guess, {.max_newton_steps = 1});

  EXPECT_EQ(found.status, ExtremalStatus::NewtonFailed);
  EXPECT_NE(found.message.find("after 1 steps"), std::string::npos)
      << found.message;
}

TEST(Failure, ByTheClockIsSaid) {
  const ExtremalSolution found =
      solve_extremal(base_scene(), {.stop = StopCondition(0.0, nullptr)});

  EXPECT_EQ(found.status, ExtremalStatus::TimeLimit);
}

TEST(Failure, ByASignalIsSaid) {
  const std::atomic<int> signal{2};
  // In the continuation, and in Newton's method from a guess.
  const ExtremalOptions options{.stop = StopCondition(3600.0, &signal)};

  EXPECT_EQ(solve_extremal(base_scene(), options).status,
            ExtremalStatus::Interrupted);
  EXPECT_EQ(
      solve_extremal(base_scene(), cycloid_guess(base_scene()), options).status,
      ExtremalStatus::Interrupted);
}

TEST(Failure, OfASignalOnALongWayIsFast) {
  // Two thousand turns: an integration along all of them takes seconds.
  const Scene scene =
      scene_of(Body::cylinder(0.0003, 2.0 / 3.0, 0.0, 0.5), 3.0);
  const FlagAfterWork interrupt(0.3);

  const ExtremalSolution found =
      solve_extremal(scene, {.stop = StopCondition(3600.0, interrupt.flag())});

  EXPECT_EQ(found.status, ExtremalStatus::Interrupted) << found.message;
  EXPECT_LT(interrupt.seconds_since(), 2.0);
}

TEST(Failure, ToReachTheToleranceKeepsTheAnswer) {
  // Five hundred turns: rounding alone costs more than asked for.
  const Scene scene = scene_of(Body::cylinder(0.02, 0.1, 0.0, 0.5), 50.0);

  const ExtremalSolution found = solve_extremal(scene, {.tolerance = 1e-14});

  EXPECT_EQ(found.status, ExtremalStatus::AccuracyNotReached) << found.message;
  EXPECT_GT(found.error_estimate, 1e-14);
  EXPECT_TRUE(found.usable());
  EXPECT_NEAR(found.tau, 28.29440569044, 1e-10);
}

TEST(Failure, HasASentenceForEveryStatus) {
  for (int i = 0; i <= static_cast<int>(ExtremalStatus::Interrupted); ++i) {
    EXPECT_NE(describe(static_cast<ExtremalStatus>(i)), "unknown status");
  }
}

TEST(Regularity, RefusesLoopsStandstillAndMaxima) {
  const Regularity good{
      .min_legendre = 0.5, .min_w = 0.01, .min_beta = -1.0, .max_beta = 2.0};
  Regularity loop = good;
  loop.max_beta = 3.2;
  Regularity stalled = good;
  stalled.min_w = -0.1;
  Regularity maximal = good;
  maximal.min_legendre = -0.1;

  EXPECT_TRUE(good.free_of_loops() && good.keeps_moving() &&
              good.legendre_holds());
  EXPECT_FALSE(loop.free_of_loops());
  EXPECT_FALSE(stalled.keeps_moving());
  EXPECT_FALSE(maximal.legendre_holds());
}

}  // namespace
}  // namespace brachisto
