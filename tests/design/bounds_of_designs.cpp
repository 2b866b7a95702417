// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Bounds that hold a design back, and what they cost.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/model/body.hpp"
#include "design/best_track.hpp"
#include "design/design_search.hpp"
#include "design/designs.hpp"

namespace brachisto::testing {
namespace {

using enum BodyKey;

TEST(Design, TheGripThatThereIsBoundsTheBody) {
  // The quickest body needs more; of those that do not the quickest needs just
  // that, and τ falls as more is allowed, at the rate that its multiplier says:
  // by a central difference of whole designs, whose error is (Δμ)² τ‴/6, a
  // thousandth of it by the multipliers of the three.
  const auto plan_with = [](double mu) {
    DesignPlan plan;
    plan.free = {EtaM, ThetaM};
    plan.max_grip = MaxGrip{mu, 0.05};
    return plan;
  };
  // From one start a search may end in a body of which the program finds no
  // path: two of the five searches that the command makes.
  const auto quickest = [&](double mu) {
    const DesignPlan plan = plan_with(mu);
    return gather_designs(plan, {search_design(base(), {}, plan, 1, nullptr),
                                 search_design(base(), {}, plan, 2, nullptr)})
        .best->tau;
  };
  constexpr double kMu = 0.8, kStep = 0.02;

  const DesignSearch found =
      search_design(base(), {}, plan_with(kMu), 1, nullptr);

  ASSERT_EQ(found.minima.size(), 2U) << found.message;
  EXPECT_FALSE(found.minima[0].feasible);
  EXPECT_NE(found.minima[0].remarks.at(0).find("design.max_grip.mu is 0.8"),
            std::string::npos)
      << found.minima[0].remarks.at(0);
  const DesignMinimum& best = found.minima[1];
  EXPECT_TRUE(best.feasible && best.verified);
  EXPECT_GT(best.tau, found.minima[0].tau);
  ASSERT_EQ(best.bounds_active.size(), 1U);
  EXPECT_EQ(best.bounds_active[0].name, "max_grip.mu");
  EXPECT_EQ(best.bounds_active[0].bound, kMu);
  // A least margin of 1e-6 rad is asked for.
  const Solution there = *found.answer;
  EXPECT_NEAR(there.diagnostics->least_grip[2].mu, kMu, 3e-6);
  const double slope =
      (quickest(kMu + kStep) - quickest(kMu - kStep)) / (2.0 * kStep);
  EXPECT_LT(slope, 0.0);
  EXPECT_NEAR(best.bounds_active[0].multiplier / slope, 1.0, 2e-3);
}

TEST(Design, BoundsOfADirectionMeetOnTheAxis) {
  // Where all directions that are allowed are slower the body is the uniform
  // one, whose τ has no direction; angles beyond ±180° are what they are.
  Scene scene = base();
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};
  constexpr double kDegree = 0.017453292519943295;
  plan.bounds[static_cast<std::size_t>(ThetaM)] = {170 * kDegree,
                                                   200 * kDegree};

  const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  const DesignMinimum& best = found.minima.back();
  EXPECT_EQ(best.body.eta_m, 0.0);
  // The closed form of the uniform cylinder.
  EXPECT_NEAR(best.tau, 5.115100653580, kOfTau);
  ASSERT_EQ(best.bounds_active.size(), 1U);
  EXPECT_EQ(best.bounds_active[0].name, "eta_m");
  // dτ/dη along the quicker end, by a difference with an error h τ″/2 of the
  // order 1.
  constexpr double kStep = 1e-3;
  const Body off = Body::cylinder(1.0 / 3.0, kStep, 200 * kDegree, 0.5);
  EXPECT_NEAR(best.bounds_active[0].multiplier,
              (tau(scene, off) - best.tau) / kStep, 2.0 * kStep);
}

TEST(Design, AMultiplierIsTheSlopeOfTheLeastTimeOverItsBound) {
  // dτ/d(bound) against the least τ of designs with the bound moved.
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K};
  constexpr double kStep = 1e-3;
  const auto least = [&](double bound) {
    plan.bounds[static_cast<std::size_t>(K)] = {bound, 0.9};
    return search_design(base(), {}, plan, 1, nullptr).minima.back();
  };

  const auto slope = [&](double step) {
    return (least(0.1 + step).tau - least(0.1 - step).tau) / (2.0 * step);
  };

  const DesignMinimum middle = least(0.1);

  ASSERT_EQ(middle.bounds_active.size(), 1U);
  // Differences with errors ∝ h² and, extrapolated, h⁴; τ ≈ 4 is good to kInner
  // of itself, which counts 4/3 + 1/6 times over h/2.
  constexpr double kError = 1.5 * 5.0 * kInner / (0.5 * kStep);
  EXPECT_NEAR(middle.bounds_active[0].multiplier,
              (4.0 * slope(0.5 * kStep) - slope(kStep)) / 3.0, kError);
}

TEST(Design, ABodyOnTheRimIsThereExactlyAndTellsWhatTheRimCosts) {
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};
  Scene scene = base();
  scene.body.eta_m = 0.05;
  for (const double k : {0.95, 0.98, 0.99}) {
    scene.body.k = k;
    for (const double radius : {1.0 / 3.0, 0.1}) {
      scene.body.radius = radius;
      std::vector<DesignSearch> searches;
      for (int start = 1; start <= 3; ++start) {
        searches.push_back(search_design(scene, {}, plan, start, nullptr));
      }
      const DesignAnswer found = gather_designs(plan, std::move(searches));

      ASSERT_EQ(found.minima.size(), 1U) << k << ", " << radius;
      const DesignMinimum& minimum = found.minima.front();
      ASSERT_EQ(minimum.bounds_active.size(), 1U);
      EXPECT_EQ(minimum.bounds_active[0].name, "rim");
      const double eta_m = by_name(minimum.values)["eta_m"];
      EXPECT_NEAR(eta_m * eta_m + k, 1.0, 1e-13);
      // The rim is η² + k = 1: dτ/dη = 2 η dτ/d(rim).
      const double slope = by_name(minimum.gradient)["eta_m"];
      EXPECT_NEAR(minimum.bounds_active[0].multiplier, slope / (2.0 * eta_m),
                  1e-6);
      ASSERT_EQ(minimum.curvatures.size(), 1U) << "along the rim";
    }
  }
}

TEST(Design, BoundsOfTheOffsetAndOfOthersHoldTogether) {
  // The direction is all that is left, and nearly that of a coordinate, which
  // has no bound of its own.
  DesignPlan plan;
  plan.free = {EtaM, ThetaM, K, Radius};
  plan.bounds[static_cast<std::size_t>(EtaM)] = {0.36, 0.435};
  plan.bounds[static_cast<std::size_t>(Radius)] = {0.147, 0.222};
  Scene scene = base();
  scene.body = Body::cylinder(0.2, 0.376, -1.8326, 0.3);

  const DesignSearch search = search_design(scene, {}, plan, 1, nullptr);
  ASSERT_FALSE(search.minima.empty()) << search.message;
  const DesignMinimum& found = search.minima.back();

  ASSERT_EQ(found.bounds_active.size(), 3U);
  auto gradient = by_name(found.gradient);
  std::map<std::string, double> prices;
  for (const BoundOfDesign& bound : found.bounds_active) {
    prices[bound.name] = bound.multiplier;
  }
  ASSERT_EQ(prices.size(), 3U);
  for (const auto& [name, price] : prices) {
    EXPECT_NEAR(price, gradient[name], 1e-6) << name;
  }
  EXPECT_EQ(prices.count("theta_m"), 0U);
  EXPECT_NEAR(gradient["theta_m"], 0.0, 1e-8);
  auto values = by_name(found.values);
  EXPECT_NEAR(values["eta_m"], 0.435, 1e-12);
  EXPECT_EQ(values["k"], 0.0);
  EXPECT_EQ(values["r"], 0.222);
}

TEST(Design, ABoundOfAMassIsInItsOwnUnit) {
  // A ring of 2 kg, free from 1 kg on, with a weight of 1 kg.
  const double r = base().body.radius;
  DesignPlan plan;
  plan.parts = {MassPart::ring(2.0, {}, r), MassPart::point(1.0, {0.5 * r, 0})};
  plan.free_parts = {{0, FreePart::Key::Mass, {1.0, 4.0}}};

  const DesignSearch found = search_design(base(), {}, plan, 1, nullptr);

  ASSERT_FALSE(found.minima.empty()) << found.message;
  const DesignMinimum& best = found.minima.back();
  ASSERT_EQ(best.bounds_active.size(), 1U);
  EXPECT_EQ(best.bounds_active[0].name, "part_1.mass");
  EXPECT_DOUBLE_EQ(best.bounds_active[0].bound, 1.0);
  const auto with_ring = [&](double mass) {
    const std::vector<MassPart> parts{MassPart::ring(mass, {}, r),
                                      plan.parts[1]};
    const MassProperties body = mass_properties(parts, r);
    return tau(base(), Body::cylinder(r, body.eta_m, body.theta_m, body.k));
  };
  // By a difference with an error h² τ‴/6, τ‴ of the order 1, and that of two
  // solves.
  constexpr double kStep = 1e-3;
  EXPECT_NEAR(best.bounds_active[0].multiplier,
              (with_ring(1.0 + kStep) - with_ring(1.0 - kStep)) / (2.0 * kStep),
              kStep * kStep + 5.0 * kInner / kStep);
}

TEST(Design, OfAPushedBodyTheQuickestThatCanRunIsFound) {
  // R_n is not 0 at the start, so that its rate there says nothing.
  DesignPlan plan;
  plan.free = {EtaM, ThetaM};
  for (const double speed : {2.0, 3.0}) {
    Scene scene = base();
    scene.body = Body::cylinder(0.2, 0.3, 0.0, 0.4);
    scene.world.start_speed = speed;

    const DesignSearch found = search_design(scene, {}, plan, 1, nullptr);

    ASSERT_EQ(found.minima.size(), 2U) << found.message;
    EXPECT_TRUE(found.lost.empty());
    EXPECT_FALSE(found.minima[0].feasible);
    const DesignMinimum& best = found.minima[1];
    ASSERT_TRUE(best.feasible && best.verified);
    ASSERT_EQ(best.bounds_active.size(), 1U);
    EXPECT_EQ(best.bounds_active[0].name, "normal_force");
    // No neighbour that can run is quicker.
    constexpr double kStep = 1e-3;
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.7853981633974483 * i;
      scene.body = best.body;
      scene.body.eta_m += kStep * std::cos(angle);
      scene.body.theta_m += kStep * std::sin(angle);
      const Solution there = solve(scene);
      ASSERT_TRUE(there.verified());
      EXPECT_TRUE(!there.feasible() || there.motion()->tau() > best.tau)
          << speed << ", " << angle;
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
