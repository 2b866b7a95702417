// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/study/solution.hpp"
#include "design/best_track.hpp"
#include "design/designs.hpp"

namespace brachisto::testing {
namespace {

using enum BodyKey;

/// Known from calculations of the closed equations with another method.
struct Known {
  double k, tau, eta_m, theta_m;
};
constexpr double kOfEta = 5e-5;

class KnownDesigns : public ::testing::TestWithParam<int> {};

TEST_P(KnownDesigns, AreFoundFromFiveStarts) {
  for (const Known& known : {Known{0.1, 4.258368999, 0.5579, -0.2008},
                             Known{0.5, 4.976102748, 0.4007, -0.4787}}) {
    Scene scene = base();
    scene.body.k = known.k;
    scene.body.eta_m = 0.3;
    DesignPlan plan;
    plan.free = {EtaM, ThetaM};
    plan.seed = static_cast<std::uint64_t>(GetParam());
    for (int start = 1; start <= 5; ++start) {
      const DesignSearch found = search_design(scene, {}, plan, start, nullptr);

      ASSERT_FALSE(found.minima.empty()) << found.message;
      const DesignMinimum& minimum = found.minima.back();
      auto values = by_name(minimum.values);
      EXPECT_TRUE(minimum.verified && minimum.feasible) << start;
      EXPECT_NEAR(minimum.tau, known.tau, kOfTau) << start;
      EXPECT_NEAR(values["eta_m"], known.eta_m, kOfEta) << start;
      EXPECT_NEAR(values["theta_m"], known.theta_m, kOfEta) << start;
      ASSERT_EQ(minimum.curvatures.size(), 2U);
      EXPECT_GT(minimum.curvatures.front(), 0.0) << "a strict minimum";
    }
  }
}

TEST_P(KnownDesigns, TheQuickestBodyOfTheRadiusIsAMassWithoutExtent) {
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K};
  plan.seed = static_cast<std::uint64_t>(GetParam());
  std::vector<DesignSearch> searches;
  for (int start = 1; start <= 5; ++start) {
    searches.push_back(search_design(base(), {}, plan, start, nullptr));
  }

  const DesignAnswer found = gather_designs(plan, std::move(searches));

  ASSERT_TRUE(found.best);
  auto values = by_name(found.best->values);
  EXPECT_NEAR(found.best->tau, 3.977561558, kOfTau);
  EXPECT_NEAR(values["eta_m"], 0.77096, 5e-6);
  EXPECT_NEAR(values["theta_m"], -0.19332, 5e-6);
  EXPECT_EQ(values["k"], 0.0) << "exactly at its bound";
  ASSERT_EQ(found.best->bounds_active.size(), 1U);
  EXPECT_EQ(found.best->bounds_active[0].name, "k");
  EXPECT_NEAR(found.best->bounds_active[0].multiplier, 4.13, 5e-3);
  EXPECT_TRUE(found.best->feasible && found.best->verified);
}

INSTANTIATE_TEST_SUITE_P(Seeds, KnownDesigns, ::testing::Values(1, 2));

TEST(Design, AQuickerBodyThatLiftsOffIsFoundAndRefused) {
  Scene scene = base();
  scene.L = 1.0;
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K};

  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  ASSERT_EQ(found.minima.size(), 2U) << found.message;
  const DesignMinimum& free = found.minima[0];
  const DesignMinimum& feasible = found.minima[1];
  EXPECT_FALSE(free.feasible);
  EXPECT_TRUE(feasible.feasible && feasible.verified);
  EXPECT_LT(free.tau, feasible.tau);
  // The force is what holds it back: it vanishes somewhere, and bodies a
  // little further down the slope of τ, k held, have a negative one.
  ASSERT_EQ(feasible.bounds_active.size(), 2U);
  EXPECT_EQ(feasible.bounds_active[0].name, "k");
  EXPECT_EQ(feasible.bounds_active[1].name, "normal_force");
  EXPECT_GT(feasible.bounds_active[1].multiplier, 0.0);
  auto slope = by_name(feasible.gradient);
  scene.body = feasible.body;
  const Solution there = solve(scene);
  ASSERT_TRUE(there.verified());
  // A least margin of 1e-6 is asked for, and met by Newton's method.
  EXPECT_NEAR(there.diagnostics->normal_force_after_rise.value, 1e-6, 1e-6);
  scene.body.eta_m -= std::copysign(1e-3, slope["eta_m"]);
  const Solution beyond = solve(scene);
  EXPECT_LT(beyond.motion()->tau(), there.motion()->tau());
  EXPECT_FALSE(beyond.feasible());
  // And the best of both is the one that can run.
  EXPECT_EQ(gather_designs(plan, {found}).best->tau, feasible.tau);

  // Without that there is no quickest body but with a bound that is stated.
  plan.require_feasible = false;
  const DesignAnswer unbounded = gather_designs(plan, {found});
  EXPECT_EQ(unbounded.best->tau, feasible.tau);
  EXPECT_NE(unbounded.minima[0].remarks.back().find("no quickest one"),
            std::string::npos);
  plan.bounds[static_cast<std::size_t>(EtaM)] = {0.0, kLargestOffset};
  EXPECT_EQ(gather_designs(plan, {found}).best->tau, free.tau);
}

TEST(Design, MinimaThatOneMarginHoldsAreOneToTheDigitsOfForces) {
  // As two searches have come to them, on different meshes.
  const auto minimum = [](double tau, double eta_m, double theta_m,
                          std::string_view held) {
    DesignMinimum out;
    out.stationary = out.verified = out.feasible = true;
    out.body = Body::cylinder(1.0 / 3.0, eta_m, theta_m, 0.5);
    out.tau = tau;
    if (!held.empty()) out.bounds_active = {{std::string(held), 0.6, -0.375}};
    return out;
  };
  const auto gathered = [&](std::string_view held, bool feasible) {
    DesignPlan plan;
    plan.free = {EtaM, ThetaM};
    std::vector<DesignSearch> searches(2);
    searches[0].minima = {minimum(5.054866115, 0.62147925, -0.06359240, held)};
    searches[1].minima = {minimum(5.054868251, 0.62149416, -0.06361647, held)};
    searches[1].minima[0].feasible = feasible;
    return gather_designs(plan, searches).minima;
  };

  const std::vector<DesignMinimum> one = gathered("max_grip.mu", true);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].found_from, 2);
  EXPECT_EQ(gathered("max_grip.mu", false).size(), 2U);
  EXPECT_EQ(gathered("k", true).size(), 2U) << "a bound that is met exactly";
  EXPECT_EQ(gathered("", true).size(), 2U);
}

TEST(Design, TheEdgeOfAFoldIsNoMinimum) {
  // At θ_m = 1.133, k = 0 the branch from the cycloid turns at η_m = 0.94782
  // and again at 0.3957; what lies beyond is quicker than what lies before,
  // 4.2227 against 5.07. An optimiser that takes τ as a function of the body
  // ends there. It is no minimum: beyond the edge τ has a slope.
  Scene scene = base();
  scene.body = Body::cylinder(1.0 / 3.0, 0.9479, 1.133, 0.0);
  const Solution edge = solve(scene);
  ASSERT_TRUE(edge.verified());
  EXPECT_EQ(edge.folds.size(), 2U);
  scene.body.eta_m = 0.955;
  const Solution beyond = solve(scene);
  EXPECT_GT((beyond.motion()->tau() - edge.motion()->tau()) / 0.0071, 0.5);

  // A search starts on the branch that leads there from the axis, and goes on.
  scene.body.eta_m = 0.9479;
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K};
  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  EXPECT_NEAR(found.minima.back().tau, 3.977561558, kOfTau);
}

TEST(Design, TheLeastTimeMayLieAtTheEdgeOfItsBranch) {
  Scene scene = base();
  scene.L = 2.0;
  scene.body.k = 0.1;
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};
  std::vector<DesignSearch> searches;
  for (const int start : {2, 3}) {
    searches.push_back(search_design(scene, {}, plan, start, nullptr));
  }

  const DesignAnswer found = gather_designs(plan, std::move(searches));

  ASSERT_TRUE(found.best);
  const DesignMinimum& best = *found.best;
  EXPECT_TRUE(best.stationary && best.verified && best.feasible);
  EXPECT_TRUE(at_edge_of_branch(best));
  EXPECT_EQ(best.found_from, 2);
  ASSERT_EQ(best.bounds_active.size(), 1U);
  EXPECT_GT(best.bounds_active[0].multiplier, 0.0);

  // Down the slope of τ tracks are soon no minima between their ends, and a
  // little further the principal one lies beyond two folds, and is slower.
  auto slope = by_name(best.gradient);
  const double size =
      std::hypot(slope["eta_m"], slope["theta_m"] / best.body.eta_m);
  const auto along = [&](double step) {
    Scene there = scene;
    there.body = best.body;
    there.body.eta_m -= step * slope["eta_m"] / size;
    there.body.theta_m -=
        step * slope["theta_m"] / (size * best.body.eta_m * best.body.eta_m);
    return solve(there);
  };
  const Solution before = along(-0.01), edge = along(5e-4),
                 beyond = along(0.01);
  EXPECT_TRUE(before.verified());
  EXPECT_GT(before.motion()->tau(), best.tau);
  ASSERT_NE(edge.certificate.find("second_order"), nullptr);
  EXPECT_FALSE(edge.certificate.find("second_order")->passed);
  ASSERT_TRUE(beyond.verified());
  EXPECT_FALSE(beyond.folds.empty());
  EXPECT_GT(beyond.motion()->tau(), best.tau + 0.05);
}

TEST(Design, TheContactAnswersLessAndLessUntilTheTrackIsNoMinimum) {
  // A known slope: of the uniform cylinder, by a kink that is asked for. Its
  // sign is that of the second-order check on the way to the fold at η_m =
  // 0.4875, θ_m = 0.45.
  Scene scene = base();
  scene.L = 2.0;
  scene.body = Body::cylinder(1.0 / 3.0, 0.0, 0.45, 0.1);
  for (const double eta_m : {0.0, 0.2, 0.4, 0.475, 0.482, 0.485}) {
    scene.body.eta_m = eta_m;
    const Solution found = solve(scene);
    const auto rates = sensitivities(found);
    ASSERT_TRUE(rates) << eta_m;
    const Check* second = found.certificate.find("second_order");
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(rates->contact_response > 0.0, second->passed) << eta_m;
  }
}

TEST(Design, ASearchThatIsLostBeginsAgainElsewhere) {
  // With r free most ways over L = 3 end at folds.
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K, Radius};
  plan.bounds[static_cast<std::size_t>(Radius)] = {0.1, 0.5};

  const DesignSearch found = search_design(base(), {}, plan, 5, nullptr);

  EXPECT_EQ(found.starts, static_cast<int>(found.lost.size()) + 1);
  ASSERT_FALSE(found.minima.empty()) << found.message;
  EXPECT_TRUE(found.minima.back().verified && found.minima.back().feasible);
}

TEST(Design, AMinimumOnAnotherBranchIsNotVerified) {
  // From the reference body at L = 2 the followed branch parts from the
  // principal one, which folds between.
  Scene scene = base();
  scene.L = 2.0;
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K};

  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  for (const DesignMinimum& minimum : found.minima) {
    EXPECT_EQ(minimum.verified,
              std::abs(tau(scene, minimum.body) / minimum.tau - 1.0) < 1e-8);
    if (!minimum.verified) {
      EXPECT_FALSE(minimum.remarks.empty());
    }
  }
}

TEST(Design, NoNeighbourIsQuicker) {
  // By whole solves around the minimum, which the search has not made.
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};
  const DesignMinimum found =
      search_design(base(), {}, plan, 1, nullptr).minima.back();
  constexpr double kStep = 1e-2;
  for (int i = 0; i < 8; ++i) {
    Body body = found.body;
    const double angle = 0.7853981633974483 * i;
    const double a = body.eta_m * std::cos(body.theta_m),
                 b = body.eta_m * std::sin(body.theta_m);
    body.eta_m =
        std::hypot(a + kStep * std::cos(angle), b + kStep * std::sin(angle));
    body.theta_m =
        std::atan2(b + kStep * std::sin(angle), a + kStep * std::cos(angle));
    // Half of the least curvature times h², a fifth of it for the third order.
    EXPECT_GT(tau(base(), body),
              found.tau + 0.4 * found.curvatures.front() * kStep * kStep);
  }
}

/// Both contacts of a start with a speed are open: by the indirect method.
TEST(Design, OfAStartWithASpeedNoNeighbourIsQuicker) {
  Scene scene = base();
  scene.world.start_speed = 1.0;
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};
  const DesignMinimum best =
      search_design(scene, {}, plan, 1, nullptr).minima.back();
  ASSERT_TRUE(best.verified && best.feasible);
  auto values = by_name(best.values);
  SolveOptions by_shooting;
  by_shooting.method = Shooting{};
  const auto time_of = [&](double eta_m, double theta_m) {
    scene.body.eta_m = values["eta_m"] + eta_m;
    scene.body.theta_m = values["theta_m"] + theta_m;
    const Solution found = solve(scene, by_shooting);
    EXPECT_TRUE(found.verified()) << found.message;
    return found.motion()->tau();
  };
  const double tau = time_of(0.0, 0.0);
  // Differences of the gradient leave h² times third derivatives, 1e-4.
  constexpr double kStep = 1e-2;
  constexpr double kFlat = 1e-3;

  EXPECT_NEAR(tau, best.tau, 5.0 * kInner * tau);
  for (const auto& [eta_m, theta_m] :
       {std::pair{kStep, 0.0}, std::pair{0.0, kStep}}) {
    const double after = time_of(eta_m, theta_m);
    const double before = time_of(-eta_m, -theta_m);
    EXPECT_GT(std::min(before, after), tau);
    EXPECT_NEAR((after - before) / (2.0 * kStep), 0.0, kFlat);
  }
}

TEST(Design, StartsOnTheAxisAreNoTrap) {
  Scene scene = base();
  scene.body.eta_m = 0.0;
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};

  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  EXPECT_NEAR(found.minima.back().tau, 4.976102748, kOfTau);
}

TEST(Design, AFreeRadiusLeansOnItsBound) {
  // Of the uniform cylinder, whose centre runs along a cycloid that is the
  // shorter the larger the body is.
  Scene scene = base();
  scene.body.eta_m = 0.0;
  DesignPlan plan;
  plan.free = {Radius};
  plan.bounds[static_cast<std::size_t>(Radius)] = {0.2, 0.5};

  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  const DesignMinimum& minimum = found.minima.back();
  EXPECT_EQ(minimum.body.radius, 0.5);
  ASSERT_EQ(minimum.bounds_active.size(), 1U);
  Body above = minimum.body, below = minimum.body;
  constexpr double kStep = 1e-4;
  above.radius += kStep;
  below.radius -= kStep;
  // h² τ‴/6 with τ‴ of order 10, and errors of two solves over 2 h.
  EXPECT_NEAR(minimum.bounds_active[0].multiplier,
              (tau(scene, above) - tau(scene, below)) / (2.0 * kStep),
              10.0 * kStep * kStep + 5.0 * kInner / kStep);
}

TEST(Design, ARadiusMayHaveAMinimumOfItsOwn) {
  // The reference body is slower with a radius of 0.40 or 0.45 than between.
  DesignPlan plan;
  plan.free = {Radius};
  plan.bounds[static_cast<std::size_t>(Radius)] = {0.2, 0.5};

  const DesignSearch found = search_design(base(), {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  const DesignMinimum& minimum = found.minima.back();
  EXPECT_TRUE(minimum.bounds_active.empty());
  for (const double radius : {0.40, 0.45}) {
    Body body = base().body;
    body.radius = radius;
    EXPECT_GT(tau(base(), body), minimum.tau) << radius;
  }
}

TEST(Design, TheBestPlaceOfAWeightIsThatOfASweepOverPlaces) {
  // A ring of mass 2 and a weight of mass 1 in it, its place in radii.
  Scene scene = base();
  const double r = scene.body.radius;
  DesignPlan plan;
  plan.parts = {MassPart::ring(2.0, {}, r), MassPart::point(1.0, {0.5 * r, 0})};
  plan.free_parts = {{1, FreePart::Key::At, {}}};

  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  const DesignMinimum& best = found.minima.back();
  auto values = by_name(best.values);
  const double x = values["part_2.x"], z = values["part_2.z"];
  // Polar grids around the axis and, finer, around the best place.
  double least = best.tau + 1.0;
  const auto at = [&](double px, double pz) {
    const std::vector<MassPart> parts{plan.parts[0],
                                      MassPart::point(1.0, {px, pz})};
    const MassProperties body = mass_properties(parts, r);
    return tau(scene, Body::cylinder(r, body.eta_m, body.theta_m, body.k));
  };
  for (int i = 0; i < 12; ++i) {
    for (const double d : {0.35, 0.7, 0.999}) {
      const double angle = 0.5235987755982988 * i;
      least =
          std::min(least, at(d * r * std::cos(angle), d * r * std::sin(angle)));
    }
  }
  EXPECT_GE(least, best.tau);
  const double distance = std::hypot(x, z), direction = std::atan2(z, x);
  EXPECT_NEAR(at(x, z), best.tau, 5.0 * kInner * best.tau);
  for (const double turn : {-0.05, 0.05}) {
    EXPECT_GT(at(distance * std::cos(direction + turn),
                 distance * std::sin(direction + turn)),
              best.tau);
  }
  EXPECT_GT(at(0.97 * x, 0.97 * z), best.tau);
}

TEST(DesignSearch, HasALimitOfTimeForAllItsSolves) {
  DesignPlan plan;
  plan.free = {BodyKey::EtaM, BodyKey::ThetaM, BodyKey::K};
  const DesignSearch whole = search_design(base(), {}, plan, 1, nullptr);
  ASSERT_FALSE(whole.stopped);
  EXPECT_FALSE(whole.reached);
  for (const double share : {0.0, 0.1, 0.3, 0.6}) {
    SolveOptions options;
    // The wall's clock runs as fast as the processor's or faster.
    options.limits.seconds = share * whole.cpu_seconds + 1e-9;

    const DesignSearch found = search_design(base(), options, plan, 1, nullptr);

    EXPECT_TRUE(found.stopped) << share;
    EXPECT_LT(found.solves, whole.solves) << share;
    // The same way as far as it goes, and a body on it.
    std::vector<double> passed, of_whole;
    for (const DesignPath& path : found.paths) {
      for (const DesignStep& step : path) passed.push_back(step.tau);
    }
    for (const DesignPath& path : whole.paths) {
      for (const DesignStep& step : path) of_whole.push_back(step.tau);
    }
    ASSERT_LE(passed.size(), of_whole.size());
    EXPECT_TRUE(std::equal(passed.begin(), passed.end(), of_whole.begin()));
    if (found.reached) {
      EXPECT_EQ(std::ranges::count(passed, found.reached->tau), 1);
      EXPECT_FALSE(found.reached->verified);
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
