// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Search::Global: what it lists and what it answers with. The expected τ come
// from backward shooting over (θ_end, φ) that shares no code with the project.

#include "search/global_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "extremal/contact_scan.hpp"
#include "extremal/shooting.hpp"
#include "model/units.hpp"
#include "study/branches.hpp"

namespace brachisto {
namespace {

// Half of the last printed digit.
constexpr double kSixDecimals = 5e-7;
// The wanted accuracy of an answer, tenfold.
constexpr double kAccuracy = 1e-9;

Scene scene_of(const Body& body, double L) {
  Scene scene;
  scene.body = body;
  scene.L = L;
  scene.H = 1.0;
  return scene;
}

Scene base(double radius) {
  return scene_of(Body::cylinder(radius, 2.0 / 3.0, 0.0, 0.5), 3.0);
}

Solution search(const Scene& scene) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;
  return solve(scene, options);
}

const Branch* find_branch(const Solution& solution, double tau,
                          double tolerance) {
  const auto one = std::find_if(
      solution.branches.begin(), solution.branches.end(),
      [&](const Branch& b) { return std::abs(b.tau - tau) <= tolerance; });
  return one == solution.branches.end() ? nullptr : &*one;
}

TEST(GlobalSearch, FindsTheFeasibleContactBeyondTheFolds) {
  const Solution solution = search(base(0.1));

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_TRUE(solution.feasible());
  EXPECT_NEAR(solution.motion()->tau(), 5.671362, kSixDecimals);
  EXPECT_NEAR(solution.motion()->end_angle(), -0.28541, 5e-6);
  const Branch* principal = find_branch(solution, 5.609105, kSixDecimals);
  ASSERT_NE(principal, nullptr);
  EXPECT_TRUE(principal->principal);
  EXPECT_TRUE(principal->verified);
  EXPECT_FALSE(principal->feasible);
  for (const double tau : {5.623189, 5.875915}) {
    const Branch* saddle = find_branch(solution, tau, kSixDecimals);
    ASSERT_NE(saddle, nullptr) << tau;
    EXPECT_FALSE(saddle->minimum) << tau;
  }
}

TEST(GlobalSearch, ListsMinimaAndSaddlesOfOtherRadii) {
  struct Expected {
    double radius;
    std::vector<double> minima, saddles;
  };
  for (const Expected& expected :
       {Expected{0.15, {5.516731, 5.617166}, {5.547017}},
        Expected{0.2, {5.424799, 5.566444}, {5.483744}}}) {
    const Solution solution = search(base(expected.radius));

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_TRUE(solution.feasible());
    EXPECT_EQ(solution.branches.size(),
              expected.minima.size() + expected.saddles.size());
    for (const double tau : expected.minima) {
      const Branch* branch = find_branch(solution, tau, kSixDecimals);
      ASSERT_NE(branch, nullptr) << tau;
      EXPECT_TRUE(branch->verified) << tau;
    }
    for (const double tau : expected.saddles) {
      const Branch* branch = find_branch(solution, tau, kSixDecimals);
      ASSERT_NE(branch, nullptr) << tau;
      EXPECT_FALSE(branch->minimum) << tau;
    }
  }
}

TEST(GlobalSearch, ListsThreeContactsOfTheExampleAndBooksTheirWork) {
  const Solution solution =
      search(scene_of(Body::cylinder(0.4041, 0.458, -0.0867, 0.2594), 4.6395));

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), 6.2360317459, kAccuracy);
  EXPECT_NE(find_branch(solution, 6.2360317459, kAccuracy), nullptr);
  const Branch* principal = find_branch(solution, 6.3038676047, kAccuracy);
  ASSERT_NE(principal, nullptr);
  EXPECT_TRUE(principal->principal);
  const Branch* saddle = find_branch(solution, 6.104084, kSixDecimals);
  ASSERT_NE(saddle, nullptr);
  EXPECT_FALSE(saddle->minimum);
  // Each candidate takes a pass at least; the meshes told are the answer's.
  const Effort& effort = solution.effort;
  const int passes_of_answer = std::accumulate(
      effort.meshes.begin(), effort.meshes.end(), 0,
      [](int sum, const MeshRecord& mesh) { return sum + mesh.passes; });
  EXPECT_GE(effort.passes, passes_of_answer + 2);
}

TEST(GlobalSearch, StopsWhenItsTimeIsOver) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;
  options.limits.seconds = 0.3;

  const Solution solution = solve(base(0.02), options);

  EXPECT_EQ(solution.status, Status::TimeLimit);
  EXPECT_LT(solution.effort.cpu_seconds, 3.0);
}

TEST(GlobalSearch, KeepsTheBranchesThatItHadJudgedWhenItIsStopped) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;
  std::atomic<int> flag{0};
  SolveHooks hooks{.interrupt = &flag};
  hooks.progress = [&](std::string_view phase, const std::string& text) {
    if (phase == "branches" && text.starts_with("2 of")) flag = 2;
  };

  const Solution solution = solve(base(0.1), options, hooks);

  EXPECT_EQ(solution.status, Status::Interrupted);
  EXPECT_FALSE(solution.motion());
  ASSERT_EQ(solution.branches.size(), 1U);
  EXPECT_TRUE(solution.branches[0].principal);
}

/// Between fixed ends of the centre, where the principal one is not the
/// fastest.
Scene between_fixed_ends() {
  Scene scene = scene_of(Body::cylinder(0.15, 0.4, 0.92, 0.2), 3.7);
  scene.contact = Contact::Centre;
  return scene;
}

/// Found otherwise: with a disc in the way, which the faster path is clear of,
/// the interior-point method leads from the principal extremal to that one.
TEST(GlobalSearch, FindsTheFasterExtremalBetweenFixedEnds) {
  const Scene scene = between_fixed_ends();
  Scene with_disc = scene;
  with_disc.limits.discs = {{{1.175, 1.079}, 0.1}};

  const Solution found = search(scene);
  const Solution principal = solve(scene, {});
  const Solution led_there = solve(with_disc, {});

  ASSERT_TRUE(found.verified()) << found.message;
  ASSERT_TRUE(led_there.verified()) << led_there.message;
  const double tau = led_there.motion()->tau();
  EXPECT_GT(principal.motion()->tau(), 1.001 * tau);
  EXPECT_NEAR(found.motion()->tau(), tau,
              tau * (*found.estimated_error + *led_there.estimated_error));
  const Branch* own = find_branch(found, principal.motion()->tau(), kAccuracy);
  ASSERT_NE(own, nullptr);
  EXPECT_TRUE(own->principal);
  EXPECT_TRUE(own->minimum);
}

/// One of them, τ = 5.5994, has on the mesh of the search a slope at B that is
/// off by 2e-3 rad.
TEST(GlobalSearch, ListsTheExtremalsBetweenFixedEndsThatShootingFinds) {
  Scene scene = scene_of(Body::cylinder(0.155477499128895, 0.913657488276004,
                                        2.138403398380534, 0.081870606595932),
                         3.013820626487555);
  scene.contact = Contact::Centre;
  const Scene natural = in_natural_units(scene);

  const Solution found = search(scene);
  const ContactScan scan = scan_contacts(natural, 5.0, [] { return false; });

  EXPECT_GE(scan.contacts.size(), 5U);
  for (const ScannedContact& contact : scan.contacts) {
    const ExtremalSolution shot = solve_extremal(
        natural, {contact.rolling_time, contact.phi,
                  [&contact](double sigma) { return contact.path.at(sigma); }});
    ASSERT_TRUE(shot.solved()) << shot.message;
    EXPECT_NE(find_branch(found, shot.tau, kAccuracy), nullptr) << shot.tau;
  }
}

void expect_confirmed(const Scene& scene, std::size_t count) {
  const Scene natural = in_natural_units(scene);
  const auto never = [] { return false; };
  const ContactScan scan = scan_contacts(natural, 5.0, never);
  const std::vector<ScannedContact>& contacts = scan.contacts;

  EXPECT_TRUE(scan.complete());
  ASSERT_EQ(contacts.size(), count);
  for (const ScannedContact& contact : contacts) {
    const ExtremalSolution solution = solve_extremal(
        natural, {contact.rolling_time, contact.phi,
                  [&contact](double sigma) { return contact.path.at(sigma); }});

    ASSERT_TRUE(solution.solved()) << solution.message;
    EXPECT_NEAR(contact.transit_time / solution.transit_time, 1.0, 1e-7);
    if (natural.contact == Contact::Smooth) {
      EXPECT_NEAR(contact.phi, solution.phi, 1e-6);
    }
    EXPECT_NEAR(contact.centre_path_length / solution.centre_path_length, 1.0,
                1e-7);
    const ExtremalState start = contact.path.at(0.0);
    EXPECT_NEAR(start.w, 0.0, 1e-9);
    EXPECT_NEAR(start.theta, natural.body.theta_m, 1e-6);
  }
}

TEST(ContactScan, IsConfirmedByMultipleShooting) {
  expect_confirmed(base(0.15), 3);
}

TEST(ContactScan, BetweenFixedEndsIsConfirmedByMultipleShooting) {
  expect_confirmed(between_fixed_ends(), 3);
}

TEST(ContactScan, SaysWhatItLeavesUndone) {
  const Scene natural = in_natural_units(base(0.15));
  const auto never = [] { return false; };
  constexpr long kAFewOfTheGrid = 20'000;

  const ContactScan part = scan_contacts(natural, 5.0, never, kAFewOfTheGrid);

  EXPECT_FALSE(part.complete());
  EXPECT_FALSE(part.whole_grid);
  EXPECT_EQ(part.tried, 0);
  EXPECT_TRUE(part.contacts.empty());
}

JudgedBranch judged(double tau, bool verified, bool feasible) {
  JudgedBranch one;
  one.branch.tau = tau;
  one.branch.verified = verified;
  one.branch.feasible = feasible;
  return one;
}

TEST(BestBranch, IsVerifiedIfAnyIsAndFeasibleIfPossible) {
  std::vector<JudgedBranch> none;
  std::vector<JudgedBranch> unverified;
  unverified.push_back(judged(1.0, false, true));
  unverified.push_back(judged(2.0, false, false));
  std::vector<JudgedBranch> infeasible;
  infeasible.push_back(judged(1.0, false, true));
  infeasible.push_back(judged(2.0, true, false));
  infeasible.push_back(judged(3.0, true, false));
  std::vector<JudgedBranch> all;
  all.push_back(judged(1.0, false, true));
  all.push_back(judged(2.0, true, false));
  all.push_back(judged(3.0, true, true));
  all.push_back(judged(4.0, true, true));

  EXPECT_EQ(best_branch(none), nullptr);
  EXPECT_EQ(best_branch(unverified)->branch.tau, 1.0);
  EXPECT_EQ(best_branch(infeasible)->branch.tau, 2.0);
  EXPECT_EQ(best_branch(all)->branch.tau, 3.0);
}

}  // namespace
}  // namespace brachisto
