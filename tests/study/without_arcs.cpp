// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Paths under limits on a mesh that knows no arcs, against closed forms and
// against paths on arcs.

#include "refinement/without_arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "refinement/limited_refinement.hpp"
#include "study/answer.hpp"
#include "study/posed_file.hpp"

namespace brachisto {
namespace {

struct Posed : testing::PosedFile {
  using PosedFile::PosedFile;

  /// What each way comes to, until one suffices.
  [[nodiscard]] std::vector<PathWithoutArcs> without_arcs(
      bool first_suffices) const {
    const MeshOptions options = this->options();
    PassProtocol protocol(options);
    Tightening tightening(*problem.limited, *start.curve, start.phi,
                          options.ipopt, protocol);
    std::vector<PathWithoutArcs> found;
    if (!tightening.tighten()) return found;
    solve_without_arcs(tightening.last(), kToleranceWithoutArcs, options.ipopt,
                       protocol, [&](SolvedWithoutArcs solved) {
                         if (solved.path) found.push_back(*solved.path);
                         return first_suffices;
                       });
    return found;
  }
  [[nodiscard]] std::optional<PathWithoutArcs> without_arcs() const {
    const std::vector<PathWithoutArcs> found = without_arcs(true);
    return found.empty() ? std::nullopt : std::optional(found.front());
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

TEST(WithoutArcs, GoBothWaysToThatTimeIfTheFirstDoesNotSuffice) {
  const Posed posed("bead_with_floor.yaml");
  const double cycloid_and_line = 3.0 + std::numbers::pi / 2.0;

  const std::vector<PathWithoutArcs> found = posed.without_arcs(false);

  EXPECT_EQ(posed.without_arcs(true).size(), 1U);
  ASSERT_EQ(found.size(), 2U);

  for (const PathWithoutArcs& way : found) {
    EXPECT_LE(std::abs(posed.tau(way) / cycloid_and_line - 1.0),
              way.estimated_error);
  }
}

TEST(WithoutArcs, PassTheChecksOfTheCertificateByEitherWay) {
  const Posed posed("friction_1.yaml");

  const std::vector<PathWithoutArcs> found = posed.without_arcs(false);

  ASSERT_EQ(found.size(), 2U);
  for (const PathWithoutArcs& way : found) {
    const Certified certified =
        certify(posed.problem, {way.path, way.estimated_error});
    for (const Check& check : certified.certificate.checks) {
      EXPECT_TRUE(check.passed) << check.name << ' ' << check.value;
    }
  }
}

class WithoutArcsBeside : public ::testing::TestWithParam<const char*> {};

TEST_P(WithoutArcsBeside, PathsOnArcsErrByNoMoreThanTheyEstimate) {
  const Posed posed(GetParam());
  const LimitedRefinement arcs = refine_limited(
      *posed.problem.limited, posed.problem.program.discretisation,
      *posed.start.curve, posed.start.phi, posed.problem.mesh_options_after({}),
      Tightening::Care::Rough);
  ASSERT_TRUE(arcs.answer);

  const std::vector<PathWithoutArcs> found = posed.without_arcs(false);

  ASSERT_FALSE(found.empty());
  for (const PathWithoutArcs& way : found) {
    EXPECT_LE(std::abs(way.path.curve.transit_time() /
                           arcs.answer->path.curve.transit_time() -
                       1.0),
              way.estimated_error + *arcs.answer->estimated_error);
  }
}

INSTANTIATE_TEST_SUITE_P(Problems, WithoutArcsBeside,
                         ::testing::Values("friction_0.3.yaml",
                                           "friction_1.yaml", "coaster.yaml",
                                           "table_in_the_way.yaml"));

}  // namespace
}  // namespace brachisto
