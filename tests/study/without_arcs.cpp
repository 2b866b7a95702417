// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Paths under limits on a mesh that knows no arcs, against closed forms and
// against paths on arcs.

#include "refinement/without_arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "brachisto/io/problem_file.hpp"
#include "refinement/limited_refinement.hpp"
#include "study/answer.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"

namespace brachisto {
namespace {

struct Posed {
  PosedProblem problem;
  Start start;

  explicit Posed(const std::string& name)
      : problem(pose(io::read_problem_file(
                         std::string(BRACHISTO_PROBLEMS_DIR "/limits/") + name)
                         .scene,
                     {}, {})),
        start(start_from_cycloid(problem)) {}

  [[nodiscard]] std::optional<PathWithoutArcs> without_arcs() const {
    const MeshOptions options = problem.mesh_options_after({});
    PassProtocol protocol(options);
    Tightening tightening(*problem.limited, *start.curve, start.phi,
                          options.ipopt, protocol);
    if (!tightening.tighten()) return std::nullopt;
    return solve_without_arcs(tightening.last(), kToleranceWithoutArcs,
                              options.ipopt, protocol)
        .path;
  }
  [[nodiscard]] double tau(const PathWithoutArcs& found) const {
    return found.path.curve.transit_time() / std::sqrt(problem.limited->H);
  }
};

TEST(WithoutArcs, OfABeadAboveAFloorErrByNoMoreThanTheyEstimate) {
  const Posed posed("bead_with_floor.yaml");
  const double cycloid_and_line = 3.0 + std::numbers::pi / 2.0;

  const auto found = posed.without_arcs();

  ASSERT_TRUE(found);
  EXPECT_FALSE(arcs_are_known(found->path.curve));
  EXPECT_LE(found->estimated_error, kToleranceWithoutArcs);
  EXPECT_LE(std::abs(posed.tau(*found) / cycloid_and_line - 1.0),
            found->estimated_error);
  // What keeps limits everywhere is no faster than what is fastest.
  EXPECT_GE(posed.tau(*found), cycloid_and_line * (1.0 - 1e-9));
}

TEST(WithoutArcs, PassTheChecksOfTheCertificate) {
  const Posed posed("friction_1.yaml");

  const auto found = posed.without_arcs();

  ASSERT_TRUE(found);
  const Certified certified =
      certify(posed.problem, {found->path, found->estimated_error});
  for (const Check& check : certified.certificate.checks) {
    EXPECT_TRUE(check.passed) << check.name << ' ' << check.value;
  }
}

class WithoutArcsBeside : public ::testing::TestWithParam<const char*> {};

TEST_P(WithoutArcsBeside, PathsOnArcsErrByNoMoreThanTheyEstimate) {
  const Posed posed(GetParam());
  const LimitedRefinement arcs =
      refine_limited(*posed.problem.limited,
                     posed.problem.program.discretisation, *posed.start.curve,
                     posed.start.phi, posed.problem.mesh_options_after({}));
  ASSERT_TRUE(arcs.answer);

  const auto found = posed.without_arcs();

  ASSERT_TRUE(found);
  EXPECT_LE(std::abs(found->path.curve.transit_time() /
                         arcs.answer->path.curve.transit_time() -
                     1.0),
            found->estimated_error + *arcs.answer->estimated_error);
}

INSTANTIATE_TEST_SUITE_P(Problems, WithoutArcsBeside,
                         ::testing::Values("friction_0.3.yaml",
                                           "friction_1.yaml", "coaster.yaml",
                                           "table_in_the_way.yaml"));

}  // namespace
}  // namespace brachisto
