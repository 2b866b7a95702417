// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Search::Global under limits, where the other paths are known: by a closed
// form, by the free motion, and by what the limits leave.

#include "search/limited_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "refinement/detour.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"

namespace brachisto {
namespace {

Solution solved(const Scene& scene, Search search) {
  SolveOptions options;
  options.use<Collocation>().search = search;
  return solve(scene, options);
}

/// The branch with that τ, to its own error and what is known of the other.
const Branch* find_branch(const Solution& solution, double tau, double digits) {
  const auto one =
      std::ranges::find_if(solution.branches, [&](const Branch& branch) {
        return std::abs(branch.tau - tau) <=
               digits + branch.estimated_error * tau;
      });
  return one == solution.branches.end() ? nullptr : &*one;
}

/// A bead with L = 3, H = 1, whose cycloid goes through the disc.
Scene bead_and_disc() {
  Scene scene;
  scene.body = Body::bead();
  scene.L = 3.0;
  scene.H = 1.0;
  scene.limits.discs = {{{1.2, 1.1}, 0.2}};
  return scene;
}

// A cycloid that touches the circle, along it, and a cycloid that leaves it for
// B. With P(β) = c ± ϱ (sin β, −cos β) on the circle and ψ = π − 2β the angle
// of a cycloid whose slope is β, the two places β₁ and β₂ are roots of
//
//     (ψ − sin ψ) P_z = (1 − cos ψ) P_x,   P_x + R (ψ_B − sin ψ_B − ψ + sin ψ)
//     = L,   R = P_z/(1 − cos ψ),   R (1 − cos ψ_B) = H,
//
// and τ = √(2 R₁) ψ₁ + ϱ |∫ dβ/√P_z| + √(2 R₂) (ψ_B − ψ₂), by scipy.
constexpr double kOver = 4.5506210365753, kUnder = 4.5316407841612;
constexpr double kDigits = 1e-12;

TEST(LimitedSearch, FindsBothWaysOfABeadRoundADisc) {
  const Solution found = solved(bead_and_disc(), Search::Global);

  ASSERT_TRUE(found.verified()) << found.message;
  EXPECT_NEAR(found.motion()->tau(), kUnder,
              kDigits + *found.estimated_error * kUnder);
  const Branch* over = find_branch(found, kOver, kDigits);
  ASSERT_NE(over, nullptr);
  EXPECT_TRUE(over->verified);
  EXPECT_TRUE(over->minimum);
  EXPECT_TRUE(over->feasible);
  EXPECT_EQ(std::ranges::count_if(found.branches, &Branch::principal), 1);
  EXPECT_TRUE(std::ranges::is_sorted(found.branches, {}, &Branch::tau));
}

/// What a bound that is nowhere reached leaves are the smooth contacts of the
/// free motion, the expected τ being those of tests/search/global_search.cpp.
TEST(LimitedSearch, FindsTheFreeContactsUnderABoundThatIsFarOff) {
  Scene scene;
  scene.body = Body::cylinder(0.2, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  scene.limits.floor = 5.0;
  constexpr double kSixDecimals = 5e-7;

  const Solution found = solved(scene, Search::Global);

  ASSERT_TRUE(found.verified()) << found.message;
  for (const double tau : {5.424799, 5.566444}) {
    const Branch* branch = find_branch(found, tau, kSixDecimals);
    ASSERT_NE(branch, nullptr) << tau;
    EXPECT_TRUE(branch->verified) << tau;
  }
}

TEST(LimitedSearch, IsNeverWorseThanTheAnswerWithoutIt) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  scene.limits.floor = 1.25;
  scene.limits.discs = {{{1.35, 0.35}, 0.15}};

  const Solution principal = solved(scene, Search::Principal);
  const Solution found = solved(scene, Search::Global);

  ASSERT_TRUE(principal.verified());
  ASSERT_TRUE(found.verified());
  EXPECT_LE(found.motion()->tau(), principal.motion()->tau());
  const auto own = std::ranges::find_if(found.branches, &Branch::principal);
  ASSERT_NE(own, found.branches.end());
  EXPECT_EQ(own->tau, principal.motion()->tau());
}

/// Free extremals that rough starts are bent from.
struct Free {
  PosedProblem posed;
  Start start;

  explicit Free(const Scene& scene)
      : posed(pose(scene, {}, {})), start(start_from_cycloid(posed)) {}
};

TEST(RoughStarts, PassADiscOnEitherSide) {
  const Free free(bead_and_disc());
  const Scene& scene = *free.posed.limited;
  const auto limits = inequalities(scene.body, scene.limits);

  const std::vector<RoughPath> ways =
      ways_past_discs(scene, *free.start.curve, limits);

  ASSERT_EQ(ways.size(), 2U);
  std::vector<bool> below;
  for (const RoughPath& way : ways) {
    double nearest = 1e9;
    bool is_below = false;
    for (const TurningPoint<double>& at : way.places) {
      const double off = distance({at.x, at.z}, limits.front().place);
      if (off >= nearest) continue;
      nearest = off;
      is_below = at.z > limits.front().place.z;
    }
    EXPECT_GT(nearest, limits.front().number);
    below.push_back(is_below);
  }
  EXPECT_NE(below[0], below[1]);
}

TEST(RoughStarts, AreTheSameWavesBetweenTheSameEndsEachTime) {
  const Free free(bead_and_disc());
  const Scene& scene = *free.posed.limited;

  const std::vector<RoughPath> one = waves(scene, *free.start.curve, 4);
  const std::vector<RoughPath> other = waves(scene, *free.start.curve, 4);

  ASSERT_EQ(one.size(), 4U);
  const ExtremalPoint end = free.start.curve->at(1.0);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].rolling_time, other[i].rolling_time);
    // sin kπ in floating point.
    EXPECT_NEAR(one[i].places.back().z, end.centre.z, 1e-14);
  }
  EXPECT_NE(one[0].rolling_time, one[1].rolling_time);
}

}  // namespace
}  // namespace brachisto
