// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Where limits are not reached: the answer under limits that ask for less.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "model/loosened_limits.hpp"
#include "model/path_inequality.hpp"
#include "study/conclude.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"
#include "support/limited_scenes.hpp"

namespace brachisto::testing {
namespace {

/// The track has to turn a falling bead to within less than its weight, and to
/// press it all along: no path does it.
Scene impossible() {
  PathLimits limits;
  limits.normal_min = 0.2;
  limits.normal_max = 0.9;
  return under(bead_scene(), limits);
}

TEST(RelaxedLimits, HaveAnAnswerThatIsThatOfTheirOwnScene) {
  const Scene scene = impossible();

  const Solution solution = solve(scene);

  EXPECT_EQ(solution.motion(), nullptr);
  EXPECT_FALSE(solution.verified());
  ASSERT_NE(solution.relaxed, nullptr) << solution.message;
  const Solution& looser = *solution.relaxed;
  EXPECT_TRUE(looser.verified());
  EXPECT_LT(*looser.scene.limits.normal_min, 0.2);
  EXPECT_GE(*looser.scene.limits.normal_min, 0.0);
  EXPECT_GT(*looser.scene.limits.normal_max, 0.9);
  // From the cycloid, without a path to start from.
  const Solution alone = solve(looser.scene);
  ASSERT_TRUE(alone.verified()) << alone.message;
  EXPECT_NEAR(alone.motion()->tau(), looser.motion()->tau(),
              1e-10 * alone.motion()->tau());
}

/// Places of half-planes are loosened too, and those of `method: extremal`.
TEST(RelaxedLimits, AreFoundBesideAHalfPlaneAndByShooting) {
  Scene scene = impossible();
  scene.limits.half_planes = {{{1.5, 4.0}, -0.5 * kPi}};
  SolveOptions options;
  options.method = Shooting{};
  EXPECT_NE(solve(scene).relaxed, nullptr);
  EXPECT_NE(solve(scene, options).relaxed, nullptr);
}

TEST(RelaxedLimits, StandInTheDocumentBesideNoNumberOfTheSceneItself) {
  const Solution solution = solve(impossible());
  const auto told = nlohmann::json::parse(report::result_json(solution));

  EXPECT_TRUE(told.at("tau").is_null());
  const auto& relaxed = told.at("relaxed");
  EXPECT_EQ(relaxed.at("tau"), solution.relaxed->motion()->tau());
  EXPECT_EQ(relaxed.at("limits").at("normal_force").at("max"),
            *solution.relaxed->scene.limits.normal_max);
  EXPECT_LT(relaxed.at("estimated_error"), 1e-10);
}

/// What a search found that went beyond its share of the work is certified.
TEST(RelaxedLimits, AreCertifiedAfterASearchThatTookMoreThanItsShare) {
  const PosedProblem posed = pose(impossible(), {}, {});
  const Start start = start_from_cycloid(posed);
  ASSERT_TRUE(start.curve);
  LimitedRefinement found = refine_limited(
      *posed.limited, posed.program.discretisation, *start.curve, start.phi,
      posed.mesh_options_after({}), Tightening::Care::Rough);
  ASSERT_FALSE(found.loosened.empty());
  found.work = 1.05 * most_search_work(posed.mesh_options);

  Solution solution;
  record_loosened(posed, found, solution);

  ASSERT_NE(solution.relaxed, nullptr);
  EXPECT_TRUE(solution.relaxed->verified());
}

/// Measured with benchmark_cold_starts: from each of twenty random paths a
/// program on one mesh, no part of the search, keeps limits loosened by 0.54.
TEST(RelaxedLimits, AreTighterThanWhatRandomPathsKeepAtOnce) {
  Scene scene;
  scene.L = 1.354;
  scene.H = 1.0;
  scene.body = Body::cylinder(0.0512, 0.361, 86.35 * kPi / 180.0, 0.638);
  scene.world.start_speed = 1.48;
  scene.limits.fold_margin = 0.234;
  scene.limits.friction = 0.458;

  const Solution solution = solve(scene);

  ASSERT_NE(solution.relaxed, nullptr) << solution.message;
  const PathLimits kept = loosened_limits(scene, 0.54);
  const PathLimits& found = solution.relaxed->scene.limits;
  EXPECT_LT(*found.friction, *kept.friction);
  EXPECT_GT(*found.fold_margin, *kept.fold_margin);
}

/// Three times the iterations, three times the work; fewer take nothing away.
TEST(SearchWork, GrowsWithTheIterationsThatAreAllowed) {
  MeshOptions options;
  options.ipopt.max_iterations = Limits{}.iterations;
  const double by_default = most_search_work(options);

  options.ipopt.max_iterations *= 3;
  EXPECT_EQ(most_search_work(options), 3.0 * by_default);
  options.ipopt.max_iterations = 10;
  EXPECT_EQ(most_search_work(options), by_default);
}

TEST(RelaxedLimits, AreNotSoughtWhereTheSceneHasAnAnswer) {
  const Solution solution = solve(under(bead_scene(), least_force(0.1)));
  EXPECT_TRUE(solution.verified());
  EXPECT_EQ(solution.relaxed, nullptr);
}

/// All bounds of a scene at once.
TEST(LoosenedLimits, AskForLessTheMoreTheyAreLoosened) {
  Scene scene = off_centred_scene();
  PathLimits& asked = scene.limits;
  asked.friction = 0.4;
  asked.normal_min = -0.1;
  asked.normal_max = 3.0;
  asked.curvature = {0.5, 2.0, CurvatureLimit::Of::Centre};
  asked.fold_margin = 0.3;
  asked.floor = 1.5;
  asked.discs = {{{1.5, 1.0}, 0.2}};
  asked.half_planes = {{{1.0, 1.0}, 0.5}};
  const TurningPoint<double> place{1.0, 0.5, 0.3, 0.8, 0.2, 0.4};
  const auto slacks = [&](double by) {
    std::vector<double> out;
    for (const PathInequality& limit :
         inequalities(scene.body, loosened_limits(scene, by))) {
      const double value = value_of(limit, scene, place);
      out.push_back(value - limit.lower);
      if (std::isfinite(limit.upper)) out.push_back(limit.upper - value);
    }
    return out;
  };

  std::vector<double> before = slacks(0.0);
  for (const double by : {0.01, 0.3, 1.0}) {
    const std::vector<double> here = slacks(by);
    ASSERT_EQ(here.size(), before.size()) << by;
    for (std::size_t i = 0; i < here.size(); ++i) {
      EXPECT_GT(here[i], before[i]) << by << " " << i;
    }
    before = here;
  }
  // A valley of the track that is as sharp as the body would be no limit.
  asked.curvature.of = CurvatureLimit::Of::Track;
  EXPECT_EQ(slacks(1.0).size(), before.size());
  scene.contact = Contact::Optimal;
  EXPECT_EQ(loosened_limits(scene, 0.5).fold_margin, 0.3);
}

}  // namespace
}  // namespace brachisto::testing
