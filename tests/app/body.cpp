// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto body PART…: a body from its parts.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "support/rounding.hpp"

namespace brachisto {
namespace {

using testing::Output;
using testing::run;
using testing::says;
using testing::ScratchDirectory;
using testing::ulps;

Output body(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "body");
  return run(std::move(arguments));
}

nlohmann::json json_of(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const Output output = body(std::move(arguments));
  EXPECT_EQ(output.code, 0) << output.err;
  return nlohmann::json::parse(output.out);
}

TEST(BodyVerb, ComputesWhatTheMotionDependsOn) {
  const nlohmann::json found = json_of({"ring:m=2", "point:m=1,at=1@-30deg"});

  // η_m = 1/3, and k = 1 − η_m² on the rim; a few roundings.
  EXPECT_NEAR(found["body"]["eta_m"], 1.0 / 3.0, ulps(4.0));
  EXPECT_NEAR(found["body"]["theta_m"], -std::numbers::pi / 6.0, ulps(4.0));
  EXPECT_NEAR(found["body"]["k"], 8.0 / 9.0, ulps(8.0));
  EXPECT_EQ(found["body"]["mass"], 3.0);
  EXPECT_EQ(found["unit_of_length"], "radius");
}

TEST(BodyVerb, HasPartsAsLargeAsTheCylinderUnlessTold) {
  EXPECT_EQ(json_of({"disc"})["body"]["k"], 0.5);
  EXPECT_EQ(json_of({"--radius", "7.7/100", "ring"})["body"]["k"], 1.0);
  EXPECT_NEAR(json_of({"rod:from=1@0,to=1@180deg"})["body"]["k"], 1.0 / 3.0,
              ulps(8.0));
  EXPECT_NEAR(json_of({"disc:hole=1/2"})["body"]["k"], 0.625, ulps(4.0));
}

TEST(BodyVerb, TakesExpressionsAndPlacesOfBothKinds) {
  const nlohmann::json polar =
      json_of({"point:at=max(0.1, 0.2)@(90-60)deg", "disc:m=2^2"});
  const nlohmann::json cartesian =
      json_of({"point:x=0.2*cos(pi/6),z=0.2*sin(pi/6)", "disc:m=4"});

  for (const char* name : {"eta_m", "theta_m", "k"}) {
    EXPECT_NEAR(polar["body"][name], cartesian["body"][name], ulps(8.0))
        << name;
  }
}

TEST(BodyVerb, MeasuresInMetresIfTheRadiusIsGiven) {
  const nlohmann::json radii = json_of({"disc", "point:at=1/2@20deg"});
  const nlohmann::json metres =
      json_of({"--radius", "0.5", "disc:radius=0.5", "point:at=0.25@20deg"});

  EXPECT_EQ(metres["unit_of_length"], "m");
  EXPECT_NEAR(metres["r_m"], 0.125, ulps(4.0));
  for (const char* name : {"eta_m", "theta_m", "k"}) {
    EXPECT_NEAR(radii["body"][name], metres["body"][name], ulps(8.0)) << name;
  }
}

TEST(BodyVerb, PrintsALineThatASceneTakes) {
  const std::vector<std::vector<std::string>> bodies{
      {"ring"},
      {"ring:m=2", "point:m=1,at=1@-30deg"},
      {"point:at=1@0.1", "point:at=1@1", "point:m=3,at=1@pi"},
      {"--radius", "1/3", "disc:m=0.4", "point:m=0.1,x=0.05,z=-0.02"}};
  const ScratchDirectory scratch;
  for (const std::vector<std::string>& parts : bodies) {
    const Output output = body(parts);
    ASSERT_EQ(output.code, 0) << output.err;
    const std::size_t line = output.out.find("body: {");
    ASSERT_NE(line, std::string::npos) << output.out;
    const std::string file =
        scratch.file("scene.yaml", "scene:\n  " + output.out.substr(line) +
                                       "  finish: {L: 3, H: 1}\n");

    const Output checked = run({"validate", file, "--json"});

    ASSERT_EQ(checked.code, 0) << checked.err;
    // As the text has it, with as many digits as matter.
    const nlohmann::json read =
        nlohmann::json::parse(checked.out)["scene"]["body"];
    const nlohmann::json found = json_of(parts)["body"];
    for (const char* name : {"radius", "eta_m", "theta_m", "k"}) {
      EXPECT_NEAR(read.value(name, 0.0), found[name].get<double>(), ulps(16.0))
          << output.out;
    }
  }
}

TEST(BodyVerb, SaysThatThereIsNoAngleWithoutOffset) {
  const Output output = body({"disc"});

  EXPECT_TRUE(says(output.out, "θ_m  any")) << output.out;
  EXPECT_FALSE(says(output.out, "theta_m")) << output.out;
}

TEST(BodyVerb, RefusesAPartWithItsNameAndWhatIsAllowed) {
  const std::vector<std::vector<std::string>> cases{
      // the part, and what is said
      {"disk", "allowed are point, ring, disc, rod; did you mean disc?"},
      {"ring:raduis=1", "which has m, radius, at, x, z; did you mean radius?"},
      {"ring:m", "m has no value; expected m=…"},
      {"ring:m=1,m=2", "m is given twice"},
      {"ring:m=1/0", "\"1/0\" is not a number"},
      {"point:at=0.5", "expected at=DISTANCE@ANGLE"},
      {"point:at=0.5@30 degrees", "is not an angle"},
      {"point:at=0.5@0,x=1", "not by both"},
      {"point:m=-1", "the mass -1 is not allowed"},
      {"disc:hole=2", "the hole 2 is not allowed: 0 ≤ hole < radius = 1"},
      {"disc:at=0.3@0", "reaches 1.3 from the axis"},
      {"rod:to=1@0", "a rod needs both from and to"}};
  for (const std::vector<std::string>& each : cases) {
    const Output output = body({"ring", each[0]});

    EXPECT_EQ(output.code, 2) << each[0];
    EXPECT_EQ(output.out, "") << each[0];
    EXPECT_TRUE(output.err.starts_with("brachisto body: " + each[0] + ": "))
        << output.err;
    EXPECT_TRUE(says(output.err, each[1])) << output.err;
  }
}

TEST(BodyVerb, RefusesARadiusThatIsNone) {
  for (const char* radius : {"0", "-1", "x"}) {
    const Output output = body({"--radius", radius, "ring"});
    EXPECT_EQ(output.code, 2);
    EXPECT_TRUE(says(output.err, "--radius")) << output.err;
  }
  EXPECT_EQ(body({}).code, 2);
}

TEST(BodyVerb, SaysThatABodyOfOnePointOfTheRimIsRefused) {
  const Output output = body({"point:at=1@10deg"});

  EXPECT_EQ(output.code, 0);
  EXPECT_TRUE(says(output.err, "η_m = 1 is refused")) << output.err;
}

TEST(BodyVerb, AnswersErrorsInJsonToo) {
  const Output output = body({"disc:foo=1", "--json"});

  EXPECT_EQ(output.code, 2);
  EXPECT_EQ(nlohmann::json::parse(output.out)["status"], "usage");
}

}  // namespace
}  // namespace brachisto
