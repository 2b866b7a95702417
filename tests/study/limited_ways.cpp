// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The ways to a path under limits, beside each other.

#include "refinement/limited_ways.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "refinement/arcs_from_mesh.hpp"
#include "refinement/limited_refinement.hpp"
#include "study/posed_file.hpp"

namespace brachisto {
namespace {

using testing::PosedFile;

LimitedWays ways_of(const PosedFile& posed, const MeshOptions& options,
                    PassProtocol& protocol) {
  return {*posed.problem.limited,
          posed.problem.program.discretisation,
          *posed.start.curve,
          posed.start.phi,
          options,
          protocol};
}

struct Found {
  std::optional<LimitedAnswer> answer;  ///< made exact
  double work;                          ///< before that
};

Found found_by(const PosedFile& posed,
               std::optional<FittedPath> (LimitedWays::*way)()) {
  const MeshOptions options = posed.options();
  PassProtocol protocol(options);
  LimitedWays ways = ways_of(posed, options, protocol);
  std::optional<FittedPath> path = (ways.*way)();
  const double work = protocol.work;
  ArcSearch search(protocol, options);
  if (!path) return {{}, work};
  return {refined(*std::move(path), posed.problem.program.discretisation,
                  search, protocol),
          work};
}

class WaysTo : public ::testing::TestWithParam<const char*> {};

/// With less work.
TEST_P(WaysTo, LeadAtOnceToWhatTheyDoWithCare) {
  const PosedFile posed(GetParam());

  const Found at_once = found_by(posed, &LimitedWays::find_at_once);
  const Found with_care = found_by(posed, &LimitedWays::find_with_care);

  ASSERT_TRUE(at_once.answer && at_once.answer->estimated_error);
  ASSERT_TRUE(with_care.answer && with_care.answer->estimated_error);
  EXPECT_LE(
      std::abs(at_once.answer->path.curve.transit_time() /
                   with_care.answer->path.curve.transit_time() -
               1.0),
      *at_once.answer->estimated_error + *with_care.answer->estimated_error);
  EXPECT_LT(at_once.work, with_care.work);
}

INSTANTIATE_TEST_SUITE_P(Problems, WaysTo,
                         ::testing::Values("friction_0.3.yaml",
                                           "bead_with_floor.yaml",
                                           "table_in_the_way.yaml"));

TEST(LimitedWays, LeadABeadAlongItsCycloidAndFloor) {
  const PosedFile posed("bead_with_floor.yaml");
  for (const auto way :
       {&LimitedWays::find_at_once, &LimitedWays::from_random}) {
    const Found found = found_by(posed, way);

    ASSERT_TRUE(found.answer && found.answer->estimated_error);
    EXPECT_NEAR(found.answer->path.curve.transit_time() /
                    std::sqrt(posed.problem.limited->H) /
                    (3.0 + std::numbers::pi / 2.0),
                1.0, *found.answer->estimated_error);
  }
}

TEST(LimitedWays, ThatFindNothingAtOnceLeaveNoVerdict) {
  const PosedFile posed("friction_1.yaml");
  MeshOptions options = posed.options();
  options.ipopt.max_iterations = 10;  // one of which is theirs
  PassProtocol protocol(options);
  protocol.fail(Status::TimeLimit, "as it was");
  LimitedWays ways = ways_of(posed, options, protocol);

  EXPECT_FALSE(ways.find_at_once());

  EXPECT_EQ(protocol.record.iterations, 1);
  EXPECT_EQ(protocol.status, Status::TimeLimit);
  EXPECT_EQ(protocol.message, "as it was");
}

TEST(LimitedWays, TakeNoMoreIterationsThanAreAllowed) {
  constexpr int kAllowed = 10;
  const PosedFile posed("friction_1.yaml");
  MeshOptions options = posed.options();
  options.ipopt.max_iterations = kAllowed;

  const LimitedRefinement found = refine_limited(
      *posed.problem.limited, posed.problem.program.discretisation,
      *posed.start.curve, posed.start.phi, options, Tightening::Care::Rough);

  int taken = 0;
  for (const MeshRecord& mesh : found.meshes) taken += mesh.iterations;
  EXPECT_FALSE(found.answer);
  EXPECT_LE(taken, kAllowed);
  EXPECT_EQ(found.status, Status::IterationLimit) << found.message;
}

}  // namespace
}  // namespace brachisto
