// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Search::Global under limits, where the other paths are known: by a closed
// form, by the free motion, and by what the limits leave.

#include "search/limited_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "refinement/detour.hpp"
#include "refinement/pass_protocol.hpp"
#include "refinement/tightening.hpp"
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
const Branch* branch_with(const Solution& solution, double tau, double digits) {
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

void expect_both_ways(const Scene& scene, double fastest, double other) {
  const Solution found = solved(scene, Search::Global);

  ASSERT_TRUE(found.verified()) << found.message;
  EXPECT_NEAR(found.motion()->tau(), fastest,
              kDigits + *found.estimated_error * fastest);
  const Branch* slower = branch_with(found, other, kDigits);
  ASSERT_NE(slower, nullptr);
  EXPECT_TRUE(slower->verified);
  EXPECT_TRUE(slower->minimum);
  EXPECT_TRUE(slower->feasible);
  EXPECT_EQ(std::ranges::count_if(found.branches, &Branch::principal), 1);
  EXPECT_TRUE(std::ranges::is_sorted(found.branches, {}, &Branch::tau));
}

TEST(LimitedSearch, FindsBothWaysOfABeadRoundADisc) {
  expect_both_ways(bead_and_disc(), kUnder, kOver);
}

/// The same with P_z + h in place of P_z and H + h of H, h = v²/2g, and the
/// first cycloid from R (1 − cos ψ_A) = h on.
TEST(LimitedSearch, FindsBothWaysOfABeadThatIsPushed) {
  Scene scene = bead_and_disc();
  scene.gravity = 10.0;
  scene.world.start_speed = 2.0;
  constexpr double kPushedOver = 3.57445376583539;
  constexpr double kPushedUnder = 3.61279034720083;

  expect_both_ways(scene, kPushedOver, kPushedUnder);
}

Scene free_contacts_above_a_floor() {
  Scene scene;
  scene.body = Body::cylinder(0.2, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  scene.limits.floor = 5.0;
  return scene;
}

/// What a bound that is nowhere reached leaves are the smooth contacts of the
/// free motion, the expected τ being those of tests/search/global_search.cpp.
TEST(LimitedSearch, FindsTheFreeContactsUnderABoundThatIsFarOff) {
  const Scene scene = free_contacts_above_a_floor();
  constexpr double kSixDecimals = 5e-7;

  const Solution found = solved(scene, Search::Global);

  ASSERT_TRUE(found.verified()) << found.message;
  for (const double tau : {5.424799, 5.566444}) {
    const Branch* branch = branch_with(found, tau, kSixDecimals);
    ASSERT_NE(branch, nullptr) << tau;
    EXPECT_TRUE(branch->verified) << tau;
  }
}

TEST(LimitedSearch, RanksWhatIsVerifiedWithThePrincipalAnswerAmongIt) {
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
  EXPECT_TRUE(found.feasible());
  for (const Branch& branch : found.branches) {
    if (!branch.verified || !branch.feasible) continue;
    EXPECT_LE(found.motion()->tau(), branch.tau);
  }
  const auto own = std::ranges::find_if(found.branches, &Branch::principal);
  ASSERT_NE(own, found.branches.end());
  EXPECT_EQ(own->tau, principal.motion()->tau());
}

/// A scene that is solved beside another one, as in a sweep.
TEST(LimitedSearch, SeeksTheOtherWaysBesideANeighbourToo) {
  Scene scene = bead_and_disc();
  const Solution before = solved(scene, Search::Principal);
  const auto neighbour = before.as_neighbour();
  ASSERT_NE(neighbour, nullptr);
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;

  const Solution found = solve(scene, options, {.neighbour = neighbour.get()});

  ASSERT_TRUE(found.verified()) << found.message;
  EXPECT_NE(branch_with(found, kOver, kDigits), nullptr);
  EXPECT_NE(branch_with(found, kUnder, kDigits), nullptr);
  EXPECT_EQ(found.as_neighbour(), nullptr);
}

TEST(LimitedSearch, SolvesForItsPathsOnAFixedMesh) {
  constexpr int kElements = 30, kDegree = 6;
  SolveOptions options;
  auto& program = options.use<Collocation>();
  program.search = Search::Global;
  program.discretisation.elements = kElements;
  program.discretisation.degree = kDegree;

  const Solution found = solve(bead_and_disc(), options);

  ASSERT_TRUE(found.verified()) << found.message;
  EXPECT_EQ(found.program()->elements, kElements);
  EXPECT_EQ(found.program()->degree, kDegree);
  EXPECT_NEAR(found.motion()->tau(), kUnder,
              kDigits + *found.estimated_error * kUnder);
}

/// Called once a start of the limited search is under way.
ProgressHook on_second_start(std::function<void()> act) {
  return
      [act = std::move(act)](std::string_view phase, const std::string& text) {
        if (phase == "search" && text.starts_with("start 2,")) act();
      };
}

TEST(LimitedSearch, KeepsTheVerifiedAnswerWhenItsTimeIsOver) {
  using Clock = std::chrono::steady_clock;
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;
  options.limits.seconds = 8.0;  // many times what the principal answer takes
  const auto begin = Clock::now();
  const auto wait = [&] {
    std::this_thread::sleep_until(begin + std::chrono::milliseconds(8100));
  };

  const Solution found =
      solve(bead_and_disc(), options, {.progress = on_second_start(wait)});

  ASSERT_TRUE(found.verified()) << found.message;
  EXPECT_NE(found.search_remark.find("the limit of 8 s"), std::string::npos)
      << found.search_remark;
  const double tau = found.motion()->tau();
  EXPECT_LE(std::min(std::abs(tau - kOver), std::abs(tau - kUnder)),
            kDigits + *found.estimated_error * tau);
}

TEST(LimitedSearch, HasNoAnswerWhenItIsInterrupted) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;
  std::atomic<int> flag{0};

  const Solution found = solve(
      bead_and_disc(), options,
      {.interrupt = &flag, .progress = on_second_start([&] { flag = 1; })});

  EXPECT_EQ(found.status, Status::Interrupted) << found.message;
  EXPECT_EQ(found.motion(), nullptr);
}

/// Free extremals that rough starts are bent from.
struct Free {
  PosedProblem posed;
  Start start;

  explicit Free(const Scene& scene)
      : posed(pose(scene, {}, {})), start(start_from_cycloid(posed)) {}

  [[nodiscard]] LimitedSearch search(MeshOptions options) const {
    return find_limited_paths(*posed.limited, {{*start.curve, start.phi}},
                              options);
  }
};

TEST(LimitedSearch, SaysWhatItsBoundsLeftUndone) {
  Scene scene = bead_and_disc();
  scene.limits.discs.assign(4, scene.limits.discs.front());
  const Free free(scene);
  MeshOptions options = free.posed.mesh_options;
  options.ipopt.max_iterations = 2;

  const std::string remark = free.search(options).remark;

  for (const char* text : {"of 4 discs", "both sides were tried of 3",
                           "ended at their 2 iterations"}) {
    EXPECT_NE(remark.find(text), std::string::npos) << remark;
  }
}

/// Where no limit is reached the contact met along the slope at B is that of
/// the free motion, with the τ of tests/search/global_search.cpp. It is closed
/// in on between two slopes 0.1 rad apart; what is left open, δ, moves C_B by
/// r δ along the path's end, where the speed is √(2 g H), and so τ by r δ/H.
TEST(LimitedSearch, MeetsTheContactAlongTheSlopeAtB) {
  constexpr double kTau = 5.424799, kStep = 0.1, kOpen = 0.2 * kStep;
  const Free free(free_contacts_above_a_floor());
  PassProtocol protocol(free.posed.mesh_options);
  Tightening path(*free.posed.limited, *free.start.curve, free.start.phi,
                  free.posed.mesh_options.ipopt, protocol);
  ASSERT_TRUE(path.tighten()) << protocol.message;

  const std::vector<LimitedCurve> contacts = path.contacts_along();

  ASSERT_FALSE(contacts.empty());
  for (const LimitedCurve& one : contacts) {
    const double tau = one.transit_time() / std::sqrt(free.posed.limited->H);
    EXPECT_NEAR(tau, kTau, kOpen);
    EXPECT_NEAR(one.problem().ends().phi, one.at(1.0).state.beta, kStep);
  }
}

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
