// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the section `design` and the parts of a body may be.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "io/reading.hpp"

namespace brachisto::io {
namespace {

const std::string kScene = cylinder("radius: 1/3, eta_m: 0.2, k: 1/2");

std::string with_design(const std::string& section) {
  return kScene + "design: " + section + "\n";
}

DesignPlan design_plan(const std::string& section) {
  return read(with_design(section)).design;
}

bool refused(const std::string& text, const std::string& reason) {
  const std::string found = errors(text);
  if (found.find(reason) != std::string::npos) return true;
  ADD_FAILURE() << '"' << found << "\" does not say: " << reason;
  return false;
}

TEST(DesignSection, HasDefaults) {
  const DesignPlan absent = read(kScene).design;

  EXPECT_TRUE(absent.empty());
  EXPECT_TRUE(absent.require_feasible);
  EXPECT_EQ(absent.starts, 5);
  EXPECT_EQ(absent.seed, 1U);
  EXPECT_FALSE(absent.start);
  EXPECT_EQ(absent.bounds_of(BodyKey::EtaM).upper, kLargestOffset);
  EXPECT_EQ(absent.bounds_of(BodyKey::K).upper, 1.0);
  EXPECT_TRUE(std::isinf(absent.bounds_of(BodyKey::ThetaM).lower));
}

TEST(DesignSection, IsRead) {
  const DesignPlan stated = design_plan(
      "{minimise: tau, free: [k, theta_m, r], bounds: {k: [0.1, 3/4], theta_m: "
      "[-30 deg, 1], r: [0.1, 1/2]}, require_feasible: false, starts: 7, seed: "
      "3, start: 2}");

  EXPECT_EQ(stated.free, (std::vector<BodyKey>{BodyKey::K, BodyKey::ThetaM,
                                               BodyKey::Radius}));
  EXPECT_EQ(stated.bounds_of(BodyKey::K).lower, 0.1);
  EXPECT_EQ(stated.bounds_of(BodyKey::K).upper, 0.75);
  EXPECT_DOUBLE_EQ(stated.bounds_of(BodyKey::ThetaM).lower,
                   -std::numbers::pi / 6.0);
  EXPECT_EQ(stated.bounds_of(BodyKey::Radius).upper, 0.5);
  EXPECT_FALSE(stated.require_feasible);
  EXPECT_EQ(stated.starts, 7);
  EXPECT_EQ(stated.seed, 3U);
  EXPECT_EQ(stated.start, 2);
}

TEST(DesignSection, BoundsTheGrip) {
  EXPECT_FALSE(design_plan("{free: [k]}").max_grip);
  const DesignPlan stated = design_plan("{free: [k], max_grip: {mu: 1/2}}");

  ASSERT_TRUE(stated.max_grip);
  EXPECT_EQ(stated.max_grip->mu, 0.5);
  EXPECT_EQ(stated.max_grip->after, 0.01);
  EXPECT_EQ(design_plan("{free: [k], max_grip: {mu: 1, after: 0.05}}")
                .max_grip->after,
            0.05);
  EXPECT_TRUE(refused(with_design("{free: [k], max_grip: {after: 0.05}}"),
                      "design.max_grip.mu: missing"));
  EXPECT_TRUE(refused(with_design("{free: [k], max_grip: {mu: 1, after: 1}}"),
                      "0 ≤ share < 1"));
  EXPECT_TRUE(refused(
      with_design("{free: [k], max_grip: {mu: 1}, require_feasible: false}"),
      "not allowed beside require_feasible: false"));
}

TEST(DesignSection, RefusesWhatIsNoBodyKey) {
  refused(with_design("{free: [eta]}"), "eta_m");
  refused(with_design("{free: [k, k]}"), "repeated");
  refused(with_design("{free: []}"), "empty list");
  refused(with_design("{minimise: mass, free: [k]}"), "tau");
  refused(with_design("{free: [k], bounds: {k: [0.5]}}"),
          "a list of 1 was read");
  refused(with_design("{free: [k], bounds: {k: [0.5, 0.5]}}"), "no room");
  refused(with_design("{free: [k], bounds: {k: [-0.1, 0.5]}}"), "from 0 to 1");
  refused(with_design("{free: [k], bounds: {eta_m: [0, 0.5]}}"), "not free");
  refused(with_design("{free: [k], starts: 0}"), "from 1 to 1000");
}

TEST(DesignSection, RefusesARadiusWithoutABound) {
  // (L² + H²)/(2L) = 5/3.
  const std::string reason = "(L² + H²)/(2L) = 1.66667 m";
  refused(with_design("{free: [r]}"), reason);
  refused(with_design("{free: [r], bounds: {r: [0.1, 5/3]}}"), reason);
  EXPECT_EQ(errors(with_design("{free: [r], bounds: {r: [0.1, 1.66]}}")), "");
}

TEST(DesignSection, RefusesWaysOfSolvingThatItDoesNotGo) {
  const std::string design = "design: {free: [k]}\n";
  refused(kScene + "solver: {method: extremal}\n" + design, "design");
  refused(kScene + "solver: {search: global}\n" + design, "principal branch");
  refused(kScene + "discretisation: {formulation: arc_length}\n" + design,
          "straight pieces");
  refused(kBead + design, "a bead has nothing to design");
}

TEST(DesignSection, RefusesAStartThatThereIsNot) {
  EXPECT_TRUE(refused(with_design("{free: [eta_m], starts: 5, start: 6}"),
                      "design.start: 6 is not allowed; there are 5 starts"));
}

/// The slope at A is an unknown then, and closes with that at B.
TEST(DesignSection, TakesAStartWithASpeed) {
  const std::string pushed =
      "scene: {body: {shape: cylinder, radius: 1/3, eta_m: 0.2, k: 1/2}, "
      "finish: {L: 3, H: 1}, start: {speed: 1}}\n";
  EXPECT_EQ(errors(pushed + "design: {free: [eta_m]}\n"), "");
  EXPECT_EQ(errors(pushed + "solver: {sensitivities: true}\n"), "");
}

TEST(DesignSection, RefusesDirectionsThatAreNotConvexWithOffsets) {
  const std::string wide = "bounds: {theta_m: [-120 deg, 120 deg]}}";
  refused(with_design("{free: [eta_m, theta_m], " + wide), "half a turn");
  EXPECT_EQ(errors(with_design("{free: [theta_m], " + wide)), "");
}

TEST(DesignSection, RefusesDirectionsThatComeTwice) {
  refused(
      with_design("{free: [theta_m], bounds: {theta_m: [-200 deg, 200 deg]}}"),
      "more than a turn");
  EXPECT_TRUE(
      design_plan("{free: [theta_m], bounds: {theta_m: [0, 2*pi]}}").bounds[1]);
}

TEST(DesignSection, RefusesBoundsThatNoBodyHas) {
  const std::string reason = "k ≤ 1 − η_m² = 0.36";
  refused(with_design(
              "{free: [eta_m, k], bounds: {eta_m: [0.8, 0.9], k: [0.5, 0.6]}}"),
          "design.bounds.eta_m: no body has η_m ≥ 0.8 and k ≥ 0.5: " + reason);
  refused(with_design("{free: [eta_m], bounds: {eta_m: [0.8, 0.9]}}"),
          "design.bounds.eta_m: no body has η_m ≥ 0.8 and k = 0.5: " + reason);
  refused(cylinder("radius: 1/3, eta_m: 0.8, k: 0.1") +
              "design: {free: [k], bounds: {k: [0.5, 0.6]}}\n",
          "design.bounds.k: no body has η_m = 0.8 and k ≥ 0.5: " + reason);
  refused(cylinder("radius: 1/3, k: 1") + "design: {free: [eta_m, theta_m]}\n",
          "design.free: one pair of both alone has η_m ≥ 0 and k = 1: k ≤ 1 − "
          "η_m² = 1");
  // 0.6² + 0.5 is less than 1.
  EXPECT_TRUE(design_plan("{free: [eta_m], bounds: {eta_m: [0.6, 0.9]}}")
                  .is_free(BodyKey::EtaM));
}

TEST(BodyParts, HaveNoMassBesideTheirs) {
  refused(cylinder("radius: 1/3, parts: [ring, \"point:m=1\"], mass: 2"),
          "scene.body.mass: not allowed beside parts");
}

TEST(Field, SaysWhatPulls) {
  refused("scene: {body: {shape: bead}, finish: {L: 3, H: 1}, field: {}}\n",
          "scene.field: has nothing in it");
}

TEST(BodyParts, GiveTheNumbersOfTheBody) {
  // A ring of 2 and a weight of 1 on its rim: η = 1/3, k = 1 − 1/9.
  const Body body = read(cylinder("radius: 1/3, parts: [\"ring:m=2\", "
                                  "\"point:m=1,at=1/3@-30deg\"]"))
                        .scene.body;

  constexpr double kRounding = 1e-15;
  EXPECT_NEAR(body.eta_m, 1.0 / 3.0, kRounding);
  EXPECT_NEAR(body.theta_m, -std::numbers::pi / 6.0, kRounding);
  EXPECT_NEAR(body.k, 8.0 / 9.0, kRounding);
}

TEST(BodyParts, StandInPlaceOfNumbersAndNotBesideThem) {
  refused(cylinder("radius: 1/3, k: 1/2, parts: [ring]"),
          "scene.body.k: not allowed beside parts");
  refused(cylinder("radius: 1/3, parts: [hoop]"), "not a kind of part");
  refused(cylinder("radius: 1/3, parts: [\"point:at=0.4@0\"]"),
          "beyond the cylinder");
  refused(cylinder("radius: 1/3"), "scene.body.k: missing");
}

TEST(BodyParts, MayBeFree) {
  const std::string parts = cylinder(
      "radius: 1/3, parts: [\"ring:m=2\", \"point:at=0.1@0\", "
      "\"rod:from=0.1@0,to=0.2@0\"]");
  const DesignPlan stated =
      read(parts +
           "design: {free: [{part: 2, key: at}, {part: 1, key: mass, bounds: "
           "[1, 3]}]}\n")
          .design;

  ASSERT_EQ(stated.free_parts.size(), 2U);
  EXPECT_EQ(stated.free_parts[0].part, 1U);
  EXPECT_EQ(stated.free_parts[1].key, FreePart::Key::Mass);
  EXPECT_EQ(stated.free_parts[1].bounds.upper, 3.0);
  refused(parts + "design: {free: [{part: 4}]}\n", "there is no part 4");
  refused(parts + "design: {free: [{part: 3}]}\n", "is a rod");
  refused(parts + "design: {free: [{part: 1}]}\n", "cannot move");
  refused(parts + "design: {free: [{part: 1, key: mass}]}\n", "has bounds");
  refused(parts + "design: {free: [{part: 2, bounds: [1, 2]}]}\n",
          "has no bounds but the cylinder");
  refused(parts + "design: {free: [{part: 2}, {part: 2, key: at}]}\n",
          "free already");
  refused(parts + "design: {free: [k]}\n", "parts are free");
  refused(with_design("{free: [{part: 1}]}"), "there is no part 1");
}

}  // namespace
}  // namespace brachisto::io
