// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Scenes with several extremals, and branches that turn back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;

Scene scene_of(const Body& body, double L) {
  Scene scene;
  scene.body = body;
  scene.L = L;
  scene.H = 1.0;
  return scene;
}

/// Two smooth contacts, found by multiple shooting: τ to eight digits.
constexpr double kPrincipal = 6.3038676;
constexpr double kFaster = 6.2360317;
constexpr double kPrinted = 5e-8;

Scene two_contacts() {
  return scene_of(Body::cylinder(0.4041, 0.458, -0.0867, 0.2594), 4.6395);
}

TEST(SearchPrincipal, IsNotLeftForAFasterExtremal) {
  const Solution solution = solve(two_contacts());

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), kPrincipal, kPrinted);
  EXPECT_TRUE(solution.branches.empty());
}

TEST(SearchGlobal, ListsTheContactsItFindsAndAnswersWithTheFastestOfThem) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;

  const Solution solution = solve(two_contacts(), options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_TRUE(solution.feasible());
  EXPECT_NEAR(solution.motion()->tau(), kFaster, kPrinted);
  const auto near = [](double tau) {
    return [tau](const Branch& branch) {
      return std::abs(branch.tau - tau) <= kPrinted;
    };
  };
  const std::vector<Branch>& branches = solution.branches;
  const auto principal =
      std::find_if(branches.begin(), branches.end(), near(kPrincipal));
  const auto faster =
      std::find_if(branches.begin(), branches.end(), near(kFaster));
  ASSERT_NE(principal, branches.end());
  ASSERT_NE(faster, branches.end());
  EXPECT_TRUE(principal->principal);
  EXPECT_FALSE(faster->principal);
  for (const Branch& branch : {*principal, *faster}) {
    EXPECT_TRUE(branch.verified);
    EXPECT_TRUE(branch.minimum);
    EXPECT_TRUE(branch.feasible);
    EXPECT_TRUE(branch.remarks.empty());
    EXPECT_LE(branch.estimated_error, 1e-10);
  }
  EXPECT_TRUE(std::is_sorted(
      branches.begin(), branches.end(),
      [](const Branch& a, const Branch& b) { return a.tau < b.tau; }));
  // What is answered is the first in the list that is verified and feasible.
  const auto first =
      std::find_if(branches.begin(), branches.end(),
                   [](const Branch& b) { return b.verified && b.feasible; });
  EXPECT_EQ(first->tau, solution.motion()->tau());
}

TEST(SearchGlobal, IsNeverSlowerThanThePrincipalBranch) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;
  for (const auto* row : {&reference("reference_case"), &reference("bead_L3"),
                          &reference("uniform_L3")}) {
    const Solution solution = solve(row->scene(), options);

    ASSERT_TRUE(solution.verified()) << row->name << ": " << solution.message;
    EXPECT_LE(solution.motion()->tau(), row->tau * (1.0 + 1e-9)) << row->name;
    EXPECT_TRUE(std::any_of(solution.branches.begin(), solution.branches.end(),
                            [&](const Branch& branch) {
                              return branch.principal &&
                                     std::abs(branch.tau / row->tau - 1.0) <
                                         1e-9;
                            }))
        << row->name;
  }
}

TEST(AFold, IsFollowedAndTold) {
  const Scene scene = scene_of(
      Body::cylinder(1.0 / 3.0, 0.8, 0.5 * std::numbers::pi, 0.01), 3.0);

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_FALSE(solution.folds.empty());
  for (const double eta : solution.folds) {
    EXPECT_GT(eta, 0.0);
    EXPECT_LT(eta, scene.body.eta_m);
  }
  // The same extremal, all the way by shooting.
  ExtremalOptions options;
  options.follow_folds = true;
  const ExtremalSolution other = solve_extremal(scene, options);
  ASSERT_TRUE(other.solved()) << other.message;
  EXPECT_NEAR(solution.motion()->tau() / other.tau, 1.0, 1e-10);
}

TEST(APlainBranch, HasNoFolds) {
  for (const auto* row : {&reference("reference_case"), &reference("fast"),
                          &reference("theta_90"), &reference("bead_L3")}) {
    EXPECT_TRUE(solve(row->scene()).folds.empty()) << row->name;
  }
}

TEST(ASmallRadius, IsFollowedOnThePrincipalBranch) {
  // Neighbours lie close here: a jump to one of them would not be noticed by a
  // minimiser. τ from the indirect method, to the digits given.
  const Scene scene = scene_of(Body::cylinder(0.05, 2.0 / 3.0, 0.0, 0.5), 3.0);

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), 5.7071701888, 5e-10);
}

}  // namespace
}  // namespace brachisto
