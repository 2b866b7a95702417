// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A ball and what it runs in, and moments of inertia by names.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/effective_input.hpp"
#include "io/reading.hpp"

namespace brachisto::io {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string body(const std::string& keys) {
  return "scene:\n  finish: {L: 3, H: 1}\n  body: {" + keys + "}\n";
}
std::string ball(const std::string& keys) {
  return body("shape: ball, radius: 0.5, k: 2/5, " + keys);
}

TEST(ReadBall, RollsWithWhatItsRailsLeave) {
  const Body found = read(ball("eta_m: 0.2, rails: {gauge: 0.6}")).scene.body;

  EXPECT_EQ(found.shape, Shape::Ball);
  EXPECT_DOUBLE_EQ(found.radius, 0.4);
  EXPECT_DOUBLE_EQ(found.eta_m, 0.25);
  EXPECT_DOUBLE_EQ(found.k, 0.625);
}

TEST(ReadBall, KnowsRoundRailsAndGrooves) {
  // b R/(R + ρ) = 0.6, and sin 30° = 1/2.
  EXPECT_DOUBLE_EQ(
      read(ball("rails: {gauge: 0.72, radius: 0.1}")).scene.body.radius, 0.4);
  EXPECT_NEAR(read(ball("groove: {angle: 60 deg}")).scene.body.radius, 0.25,
              1e-16);
}

TEST(ReadBall, TakesItsKeysInAnyOrder) {
  const Body found =
      read(body("rails: {gauge: 0.6}, k: 2/5, radius: 0.5, shape: ball"))
          .scene.body;

  EXPECT_DOUBLE_EQ(found.radius, 0.4);
  EXPECT_DOUBLE_EQ(found.k, 0.625);
}

TEST(ReadBall, EchoesWhatIsWritten) {
  const ProblemFile problem =
      read(ball("eta_m: 0.1, theta_m: 0.3, rails: {gauge: 0.7, radius: 0.11}"));

  const Json echoed = effective_input(problem.scene, problem.options)["scene"];

  const Json& found = echoed["body"];
  EXPECT_EQ(found["shape"], "ball");
  EXPECT_EQ(found["radius"], 0.5);
  EXPECT_EQ(found["eta_m"], 0.1);
  EXPECT_EQ(found["theta_m"], 0.3);
  EXPECT_EQ(found["k"], 0.4);
  EXPECT_EQ(found["rails"]["gauge"], 0.7);
  EXPECT_EQ(found["rails"]["radius"], 0.11);
  EXPECT_FALSE(found.contains("groove"));
}

TEST(ReadBall, EchoesNothingOfBallsForOtherBodies) {
  const ProblemFile problem = read(cylinder("radius: 1/3, k: 1/2"));

  const Json echoed = effective_input(problem.scene, problem.options)["scene"];

  EXPECT_FALSE(echoed["body"].contains("rails"));
  EXPECT_FALSE(echoed["body"].contains("groove"));
  EXPECT_FALSE(echoed["body"].contains("inertia"));
}

TEST(ReadInertia, HasNames) {
  const auto k = [](const std::string& name) {
    return read(cylinder("radius: 1/3, inertia: " + name)).scene.body.k;
  };

  EXPECT_EQ(k("disc"), 1.0 / 2.0);
  EXPECT_EQ(k("ring"), 1.0);
  EXPECT_EQ(k("ball"), 2.0 / 5.0);
  EXPECT_EQ(k("hollow_ball"), 2.0 / 3.0);
}

/// One message, which begins with the place and the key.
void expect_one(const std::string& text, const std::string& begin,
                const std::string& part) {
  const std::string found = errors(text);
  EXPECT_THAT(found, ::testing::StartsWith("p.yaml:3:"));
  EXPECT_THAT(found, HasSubstr(": " + begin + ": "));
  EXPECT_THAT(found, HasSubstr(part));
  EXPECT_THAT(found, Not(HasSubstr("\n")));
}

TEST(RefusedBall, FallsBetweenItsRails) {
  expect_one(ball("rails: {gauge: 1}"), "scene.body.rails.gauge",
             "1 m is not allowed: it must be less than 2 R = 1 m");
  expect_one(ball("rails: {gauge: 1.3, radius: 0.1}"), "scene.body.rails.gauge",
             "less than 2 (R + ρ) = 1.2 m");
}

TEST(RefusedBall, HasRailsThatAreNone) {
  expect_one(ball("rails: {gauge: 0.6, radius: -0.1}"),
             "scene.body.rails.radius", "-0.1 m is not allowed");
  expect_one(ball("rails: {gauge: 0}"), "scene.body.rails.gauge",
             "0 m is not allowed");
  expect_one(ball("rails: {gauge: 0.4, radius: 0.3}"), "scene.body.rails.gauge",
             "more than 2 ρ = 0.6 m");
  expect_one(ball("rails: {radius: 0.1}"), "scene.body.rails.gauge", "missing");
}

TEST(RefusedBall, RunsInTwoThings) {
  expect_one(ball("rails: {gauge: 0.6}, groove: {angle: 90 deg}"),
             "scene.body.groove", "not allowed beside rails");
}

TEST(RefusedBall, HasAGrooveThatIsNone) {
  for (const char* angle : {"0", "180 deg", "-10 deg", "200 deg"}) {
    expect_one(ball(std::string("groove: {angle: ") + angle + "}"),
               "scene.body.groove.angle", "between 0 and π");
  }
}

TEST(RefusedBall, DipsWithItsCentreOfMass) {
  expect_one(ball("eta_m: 0.3, groove: {angle: 30 deg}"), "scene.body.eta_m",
             "less than r_e/R");
}

TEST(RefusedBall, HasMoreInertiaThanItsRadiusAllows) {
  expect_one(body("shape: ball, radius: 0.5, k: 1.1, rails: {gauge: 0.6}"),
             "scene.body.k", "k ≤ 1 − η_m²");
}

TEST(RefusedInertia, SaysTheSameTwice) {
  expect_one(ball("inertia: ball"), "scene.body.inertia", "k");
}

TEST(RefusedInertia, HasNoSuchName) {
  expect_one(body("shape: ball, radius: 0.5, inertia: cube"),
             "scene.body.inertia", "hollow_ball");
}

TEST(RefusedCylinder, HasNoRails) {
  expect_one(cylinder("radius: 1/3, k: 1/2, rails: {gauge: 0.1}"),
             "scene.body.rails", "take shape: ball");
  expect_one(cylinder("radius: 1/3, k: 1/2, groove: {angle: 1}"),
             "scene.body.groove", "take shape: ball");
}

TEST(RefusedBead, HasNoRails) {
  expect_one(body("shape: bead, rails: {gauge: 0.1}"), "scene.body.rails",
             "a bead has no rails");
}

TEST(RefusedDesign, IsThatOfABall) {
  EXPECT_THAT(errors(ball("rails: {gauge: 0.6}") + "design: {free: [k]}\n"),
              HasSubstr("scene.body.shape: a ball"));
}

}  // namespace
}  // namespace brachisto::io
