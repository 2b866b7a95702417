// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Solves that are too large are not begun.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "study/size.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using ::testing::HasSubstr;
using testing::off_centred_scene;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(SizeEstimate, IsBelowWhatSolvesWereMeasuredToTake) {
  // docs/benchmarks.md: r = 0.001 and 0.0002, 568 and 2840 turns.
  const SizeEstimate medium = estimate_size(568.0, {});
  EXPECT_LT(medium.seconds, 1.5);
  EXPECT_LT(medium.bytes, 0.13e9);
  const SizeEstimate large = estimate_size(2840.0, {});
  EXPECT_LT(large.seconds, 13.6);
  EXPECT_LT(large.bytes, 0.55e9);
  // A million nodes: 5.6 s and 2.06 GB; on pieces 2.0 s and 0.96 GB.
  SolveOptions options;
  options.use<Collocation>().discretisation.nodes = 1'000'001;
  // A machine five times as fast is not refused what it can do.
  EXPECT_LT(estimate_size(0.0, options).seconds, 5.6 / 5.0);
  EXPECT_LT(estimate_size(0.0, options).bytes, 2.06e9);
  options.use<Collocation>().discretisation.formulation =
      Formulation::ArcLength;
  EXPECT_LT(estimate_size(0.0, options).seconds, 2.0 / 3.0);
  EXPECT_LT(estimate_size(0.0, options).bytes, 0.96e9);
  // And not so far below that nothing would ever be refused.
  EXPECT_GT(large.seconds, 13.6 / 4.0);
  EXPECT_GT(large.bytes, 0.55e9 / 4.0);
}

TEST(SizeEstimate, CountsTheNodesOfAFixedMesh) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.elements = 100;
  EXPECT_EQ(estimate_size(0.0, options).nodes, 501.0);
  mesh.degree = 3;
  EXPECT_EQ(estimate_size(0.0, options).nodes, 301.0);
  mesh.elements.reset();
  mesh.nodes = 301;
  EXPECT_EQ(estimate_size(0.0, options).nodes, 301.0);
}

TEST(SizeEstimate, OfThePapersSystemIsItsDenseMatrix) {
  SolveOptions options;
  auto& system = options.use<DiscreteSystem>();
  system.nodes = 40'000;
  EXPECT_EQ(estimate_size(0.0, options).bytes, 8.0 * 80'001.0 * 80'001.0);
  system.solver = DiscreteSolver::Lifted;
  EXPECT_LT(estimate_size(0.0, options).bytes, 1e9);
}

TEST(TooLarge, SaysWhatIsMissing) {
  const SizeEstimate size{
      .turns = 1e6, .nodes = 0, .bytes = 1.7e11, .seconds = 1.5e5};

  const auto memory = too_large(size, 2.1e10, 1e6);
  const auto time = too_large(size, kInfinity, 3600.0);

  ASSERT_TRUE(memory);
  EXPECT_EQ(memory->status, Status::OutOfMemory);
  EXPECT_THAT(memory->message, HasSubstr("about 1e+06 times"));
  EXPECT_THAT(memory->message, HasSubstr("at least 170 GB of memory"));
  EXPECT_THAT(memory->message, HasSubstr("there are 21 GB"));
  ASSERT_TRUE(time);
  EXPECT_EQ(time->status, Status::TimeLimit);
  EXPECT_THAT(time->message, HasSubstr("1.5e+05 s"));
  EXPECT_THAT(time->message, HasSubstr("limits.seconds is 3600"));
  EXPECT_FALSE(too_large(size, kInfinity, 1e6));
}

TEST(TooLarge, ABodyOfBillionsOfTurnsIsRefusedAtOnce) {
  const std::vector<SolveOptions> methods{
      {Collocation{}, {}},
      {Collocation{.solver = ProgramSolver::NewtonKkt}, {}},
      {Shooting{}, {}},
      {DiscreteSystem{}, {}}};
  for (const double radius : {1e-9, 2e-8, 1e-50}) {
    for (const SolveOptions& options : methods) {
      Scene scene = off_centred_scene();
      scene.body.radius = radius;

      const Solution solution = solve(scene, options);

      EXPECT_EQ(solution.status, Status::OutOfMemory) << solution.message;
      EXPECT_THAT(solution.message, HasSubstr("Nothing was computed"));
      EXPECT_LT(solution.effort.seconds, 0.5);
    }
  }
  Scene scene = off_centred_scene();
  scene.L = 1e10;
  EXPECT_EQ(solve(scene).status, Status::OutOfMemory);
}

TEST(TooLarge, ABodyWhoseTurnsDoNotMatterIsNot) {
  Scene scene = off_centred_scene();
  scene.body.eta_m = 0.0;
  scene.body.radius = 1e-9;

  const Solution solution = solve(scene);

  EXPECT_TRUE(solution.verified()) << solution.message;
}

TEST(TooLarge, AMeshForWhichThereIsNoTimeIsRefusedAtOnce) {
  SolveOptions options;
  options.use<Collocation>().discretisation.elements = 1'000'000;
  options.limits.seconds = 2.0;

  const Solution solution = solve(off_centred_scene(), options);

  EXPECT_EQ(solution.status, Status::TimeLimit) << solution.message;
  EXPECT_THAT(solution.message, HasSubstr("5e+06 nodes"));
  EXPECT_LT(solution.effort.seconds, 0.5);
}

TEST(AvailableMemory, IsWhatTheAddressSpaceLeaves) {
  // Sanitizers take terabytes of addresses, hence relative to what is taken.
  double pages = 0.0;
  ASSERT_TRUE(std::ifstream("/proc/self/statm") >> pages);
  const double taken = pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
  constexpr double kLeft = 1 << 28;  // less than any machine of the tests has
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  rlimit tight = before;
  tight.rlim_cur = static_cast<rlim_t>(taken + kLeft);
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &tight), 0);

  const double left = available_memory();

  ASSERT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
  // Opening files takes a little.
  EXPECT_GT(left, 0.9 * kLeft);
  EXPECT_LE(left, kLeft);
}

}  // namespace
}  // namespace brachisto
