// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A solve ends when its budget does.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/processor_time.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::FlagAfterWork;
using testing::reference;

/// A mesh on which the coarse curve of the continuation is no solution, so that
/// it takes several iterations.
SolveOptions some_work() {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 1;
  mesh.elements = 100;
  return options;
}

/// A solve of 50 001 nodes. How long it takes depends on machine and build, so
/// that the tests measure it first.
SolveOptions much_work() {
  SolveOptions options;
  options.use<Collocation>().discretisation.elements = 10'000;
  return options;
}

/// Of that the tests let pass a quarter, however much faster the second solve
/// is than the first for reasons of the machine.
constexpr double kShare = 0.25;

double cpu_seconds_of(const Solution& solution) {
  return solution.effort.cpu_seconds + solution.effort.certificate_cpu_seconds;
}

/// Two meshes, the second one found from the first.
SolveOptions two_meshes() {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 2;
  mesh.tolerance = 1e-9;
  return options;
}

TEST(Limits, TheIterationsOfAllPassesAreCountedTogether) {
  const Scene scene = reference("reference_case").scene();
  for (SolveOptions options : {some_work(), two_meshes()}) {
    const int needed = solve(scene, options).effort.iterations;
    ASSERT_GT(needed, 1);
    for (int limit = 1; limit < needed; ++limit) {
      options.limits.iterations = limit;

      const Solution solution = solve(scene, options);

      EXPECT_EQ(solution.status, Status::IterationLimit)
          << limit << " of " << needed << ": " << solution.message;
      EXPECT_FALSE(solution.verified());
      EXPECT_LE(solution.effort.iterations, limit);
      EXPECT_NE(solution.message, "");
    }
  }
}

TEST(Limits, AsManyIterationsAsNeededAreEnough) {
  const Scene scene = reference("reference_case").scene();
  for (SolveOptions options : {some_work(), two_meshes()}) {
    options.limits.iterations = solve(scene, options).effort.iterations;

    const Solution solution = solve(scene, options);

    EXPECT_TRUE(solution.verified()) << solution.message;
  }
}

TEST(Limits, TheClockEndsASolve) {
  SolveOptions options;
  options.limits.seconds = 1e-6;

  const Solution solution = solve(reference("reference_case").scene(), options);

  EXPECT_EQ(solution.status, Status::TimeLimit) << solution.message;
  EXPECT_FALSE(solution.verified());
}

TEST(Limits, TheClockEndsALargeSolveSoonAfter) {
  const Scene scene = reference("reference_case").scene();
  SolveOptions options = much_work();
  const double needed = cpu_seconds_of(solve(scene, options));
  // The wall's clock runs as fast as the processor's or faster.
  options.limits.seconds = kShare * needed;

  const Solution solution = solve(scene, options);

  EXPECT_EQ(solution.status, Status::TimeLimit) << solution.message;
  EXPECT_GE(solution.effort.seconds, kShare * needed);
  EXPECT_LT(cpu_seconds_of(solution), needed);
}

TEST(Interrupt, APresetFlagEndsTheSolveAtOnce) {
  const std::atomic<int> flag{2};

  const Solution solution =
      solve(reference("reference_case").scene(), {}, {.interrupt = &flag});

  EXPECT_EQ(solution.status, Status::Interrupted) << solution.message;
  EXPECT_FALSE(solution.verified());
  EXPECT_FALSE(trajectory_of(solution));
}

TEST(Interrupt, AFlagSetMeanwhileEndsALargeSolve) {
  const Scene scene = reference("reference_case").scene();
  const SolveOptions options = much_work();
  const double needed = cpu_seconds_of(solve(scene, options));
  const FlagAfterWork interrupt(kShare * needed);

  const Solution solution =
      solve(scene, options, {.interrupt = interrupt.flag()});

  EXPECT_EQ(solution.status, Status::Interrupted) << solution.message;
  EXPECT_LT(cpu_seconds_of(solution), needed);
}

TEST(Interrupt, AFlagSetMeanwhileEndsShooting) {
  // Over a thousand turns: the continuation alone takes minutes.
  Scene scene = reference("reference_case").scene();
  scene.body.radius = 0.0005;
  SolveOptions options;
  options.method = Shooting{};
  const FlagAfterWork interrupt(0.3);

  const Solution solution =
      solve(scene, options, {.interrupt = interrupt.flag()});

  EXPECT_EQ(solution.status, Status::Interrupted) << solution.message;
  EXPECT_LT(interrupt.seconds_since(), 2.0);
}

TEST(Interrupt, NothingIsLeftOfAnAnswerThatCameTooLate) {
  // Wherever the flag is seen, before, within or after the certificate.
  SolveOptions options;
  options.use<Collocation>().certify = Certify::Extremal;
  const Scene scene = reference("reference_case").scene();
  const double needed = cpu_seconds_of(solve(scene, options));
  constexpr int kMoments = 20;
  for (int i = 1; i <= kMoments; ++i) {
    const FlagAfterWork interrupt(needed * i / kMoments);

    const Solution solution =
        solve(scene, options, {.interrupt = interrupt.flag()});

    if (solution.status == Status::Solved) continue;
    EXPECT_EQ(solution.status, Status::Interrupted) << solution.message;
    EXPECT_FALSE(trajectory_of(solution) || solution.diagnostics ||
                 solution.estimated_error || solution.extremal ||
                 solution.as_neighbour())
        << i;
    EXPECT_TRUE(solution.certificate.checks.empty()) << i;
    EXPECT_FALSE(solution.program()) << i;
  }
}

TEST(Memory, ThatRunsOutIsAStatus) {
  // Wherever it does: the hooks are called from within.
  for (const char* phase : {"continuation", "mesh", "check", "certificate"}) {
    SolveHooks hooks;
    hooks.progress = [&](std::string_view now, const std::string&) {
      if (now.starts_with(phase)) throw std::bad_alloc();
    };

    const Solution solution =
        solve(reference("reference_case").scene(), {}, hooks);

    EXPECT_EQ(solution.status, Status::OutOfMemory) << phase;
    EXPECT_NE(solution.message.find("memory ran out"), std::string::npos);
    EXPECT_FALSE(trajectory_of(solution)) << phase;
  }
}

TEST(Memory, BeyondAllAddressesIsTheSame) {
  SolveHooks hooks;
  hooks.progress = [](std::string_view, const std::string&) {
    throw std::length_error("vector");
  };

  const Solution solution =
      solve(reference("reference_case").scene(), {}, hooks);

  EXPECT_EQ(solution.status, Status::OutOfMemory) << solution.message;
}

TEST(Hooks, ThatThrowAreHeard) {
  SolveHooks hooks;
  hooks.progress = [](std::string_view, const std::string&) { throw 42; };

  EXPECT_THROW(
      static_cast<void>(solve(reference("reference_case").scene(), {}, hooks)),
      int);
}

TEST(Interrupt, OfAnOuterConditionLeavesTheSolve) {
  // Not the solve's own, so that it is not the solve's to report.
  const StopScope scope(StopCondition(0.0, nullptr));

  EXPECT_THROW(static_cast<void>(solve(reference("reference_case").scene())),
               Stopped);
}

TEST(Interrupt, EndsTheEvaluationOfAGivenPath) {
  Scene scene = reference("reference_case").scene();
  GivenPath path;
  path.curve = GivenPath::Curve::Track;
  path.shape = GivenPath::Shape::Points;
  constexpr int kPoints = 20'000;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = scene.L * i / kPoints;
    path.points.push_back(
        {x, scene.H * std::sqrt(x / scene.L) * (2.0 - std::sqrt(x / scene.L))});
  }
  scene.body = Body::bead();
  scene.path = std::make_shared<const GivenPath>(path);
  SolveOptions options;
  options.limits.seconds = 0.05;

  const Solution solution = solve(scene, options);

  EXPECT_EQ(solution.status, Status::TimeLimit) << solution.message;
  EXPECT_FALSE(solution.motion());
  EXPECT_LT(cpu_seconds_of(solution), 0.3);
}

/// Scenes on which the integrator of the indirect method takes ever smaller
/// steps: almost level ones.
TEST(AlmostLevel, EndsWithoutAnAnswerSoon) {
  for (const double H : {1e-10, 1e-15, 1e-30}) {
    for (Scene scene :
         {reference("reference_case").scene(), reference("bead_L3").scene()}) {
      scene.H = H;

      const Solution solution = solve(scene);

      EXPECT_FALSE(solution.verified()) << H;
      EXPECT_NE(solution.message, "") << H;
      EXPECT_LT(cpu_seconds_of(solution), 20.0) << H;
    }
  }
}

}  // namespace
}  // namespace brachisto
