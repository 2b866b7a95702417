// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What solves take is foretold; those that are too large are not begun.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "math/machine_speed.hpp"
#include "study/size.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using ::testing::HasSubstr;
using testing::off_centred_scene;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Of processes that did nothing but this solve, in the processor time of a
/// quiet core of the machine of docs/benchmarks.md.
struct Measured {
  const char* file;
  double nodes, bytes, seconds;
};

void PrintTo(const Measured& measured, std::ostream* out) {
  *out << measured.file;
}

class ForecastOfAFile : public ::testing::TestWithParam<Measured> {};

INSTANTIATE_TEST_SUITE_P(
    LargeAndLimited, ForecastOfAFile,
    ::testing::Values(Measured{"large/r_0.005", 2767, 40.9e6, 0.287},
                      Measured{"large/r_0.001", 13603, 134e6, 2.00},
                      Measured{"large/r_0.0002", 66655, 539e6, 20.8},
                      Measured{"large/million_nodes", 1000001, 2.11e9, 7.37},
                      Measured{"large/million_pieces", 1000001, 0.99e9, 2.49},
                      Measured{"large/L_200", 3247, 105e6, 52.0},
                      Measured{"limits/bead_with_floor", 85, 17.7e6, 0.026},
                      Measured{"limits/coaster", 519, 22.4e6, 0.184},
                      Measured{"limits/friction_0.3", 372, 20.9e6, 0.087},
                      Measured{"limits/friction_1", 176, 19.9e6, 0.050},
                      Measured{"limits/marble_run", 85, 17.6e6, 0.033},
                      Measured{"limits/table_in_the_way", 155, 21.2e6, 0.082}));

TEST_P(ForecastOfAFile, IsGoodToAFactorOfTwo) {
  const Measured& measured = GetParam();
  const io::ProblemFile problem = io::read_problem_file(
      fmt::format("{}/{}.yaml", BRACHISTO_PROBLEMS_DIR, measured.file));

  const auto found = forecast(problem.scene, problem.options);

  ASSERT_TRUE(found);
  const auto expect_near = [](double value, double there) {
    EXPECT_GT(value, there / 2.0);
    EXPECT_LT(value, there * 2.0);
  };
  expect_near(found->nodes, measured.nodes);
  expect_near(found->bytes, measured.bytes);
  // On the machine that was measured on.
  expect_near(found->seconds * machine_speed(), measured.seconds);
  EXPECT_GE(found->nodes, measured.nodes);
}

TEST(Forecast, CountsTheNodesOfAFixedMesh) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  const auto nodes = [&] {
    return forecast(off_centred_scene(), options)->nodes;
  };
  mesh.elements = 100;
  EXPECT_EQ(nodes(), 501.0);
  mesh.degree = 3;
  EXPECT_EQ(nodes(), 301.0);
  mesh.elements.reset();
  mesh.nodes = 301;
  EXPECT_EQ(nodes(), 301.0);
}

/// A uniform body may turn as often as it likes: its path takes a few elements,
/// and sensitivities give up where turns are too many.
TEST(Forecast, OfAUniformBodyDoesNotGrowWithoutBound) {
  SolveOptions options;
  options.use<Collocation>().sensitivities = SensitivityOrder::First;
  Scene scene = off_centred_scene();
  scene.body.eta_m = 0.0;
  for (const double radius : {0.3, 1e-3, 1e-6, 1e-9}) {
    scene.body.radius = radius;
    EXPECT_LT(forecast(scene, options)->bytes, 5e8) << radius;
  }
  const Solution solution = solve(scene, options);
  EXPECT_TRUE(solution.verified()) << solution.message;
  EXPECT_FALSE(solution.sensitivities);
}

TEST(Forecast, OfThePapersSystemIsItsDenseMatrices) {
  SolveOptions options;
  auto& system = options.use<DiscreteSystem>();
  system.nodes = 40'000;
  const auto bytes = [&] {
    return forecast(off_centred_scene(), options)->bytes;
  };
  EXPECT_GT(bytes(), 2.0 * 8.0 * 80'001.0 * 80'001.0);
  EXPECT_LT(bytes(), 4.0 * 8.0 * 80'001.0 * 80'001.0);
  system.solver = DiscreteSolver::Lifted;
  EXPECT_LT(bytes(), 1e9);
}

TEST(Forecast, ThereIsNoneOfAPathThatIsGiven) {
  Scene scene = off_centred_scene();
  scene.path = std::make_shared<const GivenPath>();

  EXPECT_FALSE(forecast(scene));
}

TEST(TooLarge, SaysWhatIsMissing) {
  const Forecast size{.turns = 1e6,
                      .nodes = 1e7,
                      .adaptive = true,
                      .bytes = 1.7e11,
                      .seconds = 1.5e5,
                      .least_seconds = 1.5e4};

  const auto memory = too_large(size, 2.1e10, 1e6);
  const auto time = too_large(size, kInfinity, 3600.0);

  ASSERT_TRUE(memory);
  EXPECT_EQ(memory->status, Status::OutOfMemory);
  EXPECT_THAT(memory->message, HasSubstr("about 1e+06 times"));
  EXPECT_THAT(memory->message, HasSubstr("about 170 GB of memory"));
  EXPECT_THAT(memory->message, HasSubstr("there are 21 GB"));
  ASSERT_TRUE(time);
  EXPECT_EQ(time->status, Status::TimeLimit);
  EXPECT_THAT(time->message, HasSubstr("1.5e+05 s"));
  EXPECT_THAT(time->message, HasSubstr("limits.seconds is 3600"));
  EXPECT_FALSE(too_large(size, kInfinity, 1e6));
}

TEST(TooLarge, AMeshThatTheMemoryIsTooSmallForIsRefused) {
  SolveOptions options;
  options.use<Collocation>().discretisation.elements = kMaxElements;

  const Forecast size = *forecast(off_centred_scene(), options);

  // A mesh takes at least its unknowns: x, z, θ, w and β at each node, with
  // multipliers, bounds and a row of the Jacobian each.
  const double least = size.nodes * 10.0 * sizeof(double);
  EXPECT_TRUE(too_large(size, least, kInfinity));
  EXPECT_FALSE(too_large(size, size.bytes, kInfinity));
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
      EXPECT_LT(solution.effort.cpu_seconds, 0.5);
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
  options.use<Collocation>().discretisation.elements = 200'000;
  options.limits.seconds = 0.1;

  const Solution solution = solve(off_centred_scene(), options);

  EXPECT_EQ(solution.status, Status::TimeLimit) << solution.message;
  EXPECT_THAT(solution.message, HasSubstr("1e+06 nodes"));
  EXPECT_LT(solution.effort.cpu_seconds, 0.5);
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
