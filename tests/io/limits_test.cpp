// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The section scene.limits, and the contacts that need it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/effective_input.hpp"
#include "io/reading.hpp"
#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A cylinder in four lines, with further keys of the scene from line 5 on.
std::string scene_with(const std::string& lines) {
  return "scene:\n"
         "  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
         "  finish: {L: 3, H: 1}\n"
         "  gravity: 9.81\n" +
         lines;
}

const std::string kAll =
    "  contact: {end_slope: -10 deg}\n"
    "  limits:\n"
    "    friction: 1/2\n"
    "    normal_force: {min: 0.01, max: 5}\n"
    "    curvature: {hump: 2, valley: 4, of: centre}\n"
    "    fold_margin: 0.1\n"
    "    floor: 3/2\n"
    "    clear_of:\n"
    "    - half_plane: {x: 3.6, z: 0, normal: 180 deg}\n"
    "    - disc: {x: 1, z: 1.5, radius: 1/5}\n"
    "    - disc: {x: 2, z: 1.6, radius: 0.1}\n";

Json echo(const ProblemFile& problem) {
  return effective_input(problem.scene, problem.options);
}

TEST(ReadLimits, EveryKeyHasItsPlace) {
  const Scene scene = read(scene_with(kAll)).scene;
  const PathLimits& limits = scene.limits;

  EXPECT_EQ(scene.contact, Contact::EndSlope);
  EXPECT_DOUBLE_EQ(scene.end_slope.value(), -std::numbers::pi / 18.0);
  EXPECT_EQ(limits.friction, 0.5);
  EXPECT_EQ(limits.normal_min, 0.01);
  EXPECT_EQ(limits.normal_max, 5.0);
  EXPECT_EQ(limits.curvature.hump, 2.0);
  EXPECT_EQ(limits.curvature.valley, 4.0);
  EXPECT_EQ(limits.curvature.of, CurvatureLimit::Of::Centre);
  EXPECT_EQ(limits.fold_margin, 0.1);
  EXPECT_EQ(limits.floor, 1.5);
  ASSERT_EQ(limits.discs.size(), 2U);
  EXPECT_EQ(limits.discs[0].centre, (Point{1.0, 1.5}));
  EXPECT_EQ(limits.discs[0].radius, 0.2);
  EXPECT_EQ(limits.discs[1].centre, (Point{2.0, 1.6}));
  ASSERT_EQ(limits.half_planes.size(), 1U);
  EXPECT_EQ(limits.half_planes[0].point, (Point{3.6, 0.0}));
  EXPECT_DOUBLE_EQ(limits.half_planes[0].normal, std::numbers::pi);
}

TEST(ReadLimits, NoneIsThereUnlessAskedFor) {
  for (const std::string keys : {"", "  limits: {}\n", "  limits: null\n",
                                 "  limits: {friction: null}\n",
                                 "  limits: {curvature: {of: track}}\n"}) {
    const ProblemFile problem = read(scene_with(keys));

    EXPECT_FALSE(problem.scene.limits.any()) << keys;
    EXPECT_EQ(echo(problem).dump(), echo(read(scene_with(""))).dump()) << keys;
  }
  EXPECT_FALSE(echo(read(scene_with("")))["scene"].contains("limits"));
}

TEST(ReadLimits, WordsOfTheContact) {
  const auto contact = [](const std::string& word) {
    return read(scene_with("  contact: " + word +
                           "\n  limits: {curvature: {hump: 2, valley: 2}}\n"))
        .scene.contact;
  };

  EXPECT_EQ(contact("smooth"), Contact::Smooth);
  EXPECT_EQ(contact("centre"), Contact::Centre);
  EXPECT_EQ(contact("optimal"), Contact::Optimal);
}

TEST(EchoOfLimits, IsInputAgainAndTheSame) {
  const std::string curvatures = "curvature: {hump: 2, valley: 2}";
  for (const std::string& keys :
       {kAll, std::string("  limits: {friction: 1/2}\n"),
        std::string("  limits: {normal_force: {min: 0.1}}\n"),
        std::string("  limits: {curvature: {of: centre}}\n"),
        std::string(
            "  limits: {clear_of: [{disc: {x: 1, z: 2, radius: 1}}]}\n"),
        "  contact: optimal\n  limits: {" + curvatures + "}\n"}) {
    const Json first = echo(read(scene_with(keys)));
    const Json result = {{"schema_version", 2}, {"input", first}};

    EXPECT_EQ(echo(read(result.dump(2))).dump(), first.dump()) << keys;
  }
}

TEST(EchoOfLimits, SaysWhatIsThereAndNullForTheRest) {
  const Json scene = echo(read(scene_with(
      "  contact: {end_slope: 0}\n"
      "  limits: {curvature: {valley: 2}, fold_margin: 0.5}\n")))["scene"];

  EXPECT_EQ(scene["contact"].dump(), R"({"end_slope":0.0})");
  EXPECT_EQ(scene["limits"].dump(),
            R"({"friction":null,"normal_force":null,)"
            R"("curvature":{"hump":null,"valley":2.0,"of":"track"},)"
            R"("fold_margin":0.5,"floor":null})");
}

TEST(OverridesOfLimits, AddAndReplace) {
  const std::vector<std::string> curvatures{"scene.limits.curvature.hump=2",
                                            "scene.limits.curvature.valley=2"};
  const auto with = [&](std::string keys, const std::string& change) {
    std::vector<std::string> overrides = curvatures;
    overrides.push_back(change);
    return read(scene_with(keys), overrides).scene;
  };
  const std::string slope = "scene.contact.end_slope=-0.1";

  for (const std::string before :
       {"", "  contact: smooth\n", "  contact: {end_slope: 0.3}\n"}) {
    const Scene scene = with(before, slope);
    EXPECT_EQ(scene.contact, Contact::EndSlope) << before;
    EXPECT_EQ(scene.end_slope, -0.1) << before;
  }
  const Scene scene = with(kAll, "scene.contact=optimal");
  EXPECT_EQ(scene.contact, Contact::Optimal);
  EXPECT_FALSE(scene.end_slope);
  EXPECT_EQ(with(kAll, "scene.limits.friction=0.7").limits.friction, 0.7);
  EXPECT_TRUE(with(kAll, "scene.limits.clear_of=null").limits.discs.empty());
}

TEST(OverridesOfLimits, KeepTheirMistakes) {
  EXPECT_EQ(
      errors(scene_with("  contact: smooth\n"), {"scene.contact.slope=1"}),
      "p.yaml:5:3: scene.contact.end_slope: missing; expected an angle "
      "in rad or, as in 30 deg, in degrees (slope angle of the track at "
      "B, downwards positive, in place of a word for contact)\n"
      "--set scene.contact.slope=1: scene.contact.slope: unknown key; "
      "allowed in scene.contact: end_slope");
}

TEST(MistakesInLimits, HaveTheirPlaces) {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"  contact: optimum\n",
       "p.yaml:5:12: scene.contact: \"optimum\" was read; expected smooth or "
       "centre or optimal or a map with the key end_slope; did you mean "
       "optimal?"},
      {"  contact: [smooth]\n",
       "p.yaml:5:12: scene.contact: a list was read; expected smooth or centre "
       "or optimal or a map with the key end_slope"},
      {"  contact: {}\n",
       "p.yaml:5:3: scene.contact.end_slope: missing; expected an angle in rad "
       "or, as in 30 deg, in degrees (slope angle of the track at B, downwards "
       "positive, in place of a word for contact)"},
      {"  contact: {end_slope: steep}\n",
       "p.yaml:5:24: scene.contact.end_slope: \"steep\" is not a number: "
       "\"steep\" has no meaning here; expected an angle in rad or, as in 30 "
       "deg, in degrees"},
      {"  limits: {frction: 0.5}\n",
       "p.yaml:5:12: scene.limits.frction: unknown key; allowed in "
       "scene.limits: friction, normal_force, curvature, fold_margin, floor, "
       "clear_of; did you mean friction?"},
      {"  limits: 0.5\n",
       "p.yaml:5:11: scene.limits: a single value was read; expected a map "
       "with "
       "the keys friction, normal_force, curvature, fold_margin, floor, "
       "clear_of"},
      {"  limits: {friction: [0.5]}\n",
       "p.yaml:5:22: scene.limits.friction: a list was read; expected a "
       "number, "
       "> 0"},
      {"  limits: {friction: 0}\n",
       "p.yaml:5:22: scene.limits.friction: 0 is not allowed: it must be > 0, "
       "for it is friction that turns the body"},
      {"  limits: {curvature: {of: body}}\n",
       "p.yaml:5:28: scene.limits.curvature.of: \"body\" was read; expected "
       "track or centre"},
      {"  limits: {floor: 1/2}\n",
       "p.yaml:5:19: scene.limits.floor: 0.5 m is not allowed: it must be more "
       "than H = 1 "
       "m, for a body that stands at B on a slope, however gentle, reaches "
       "lower than B"},
      {"  limits: {clear_of: []}\n",
       "p.yaml:5:22: scene.limits.clear_of: an empty list was read; expected a "
       "list of {disc: {x, z, radius}} and {half_plane: {x, z, normal}}"},
      {"  limits: {clear_of: {disc: {x: 1, z: 1, radius: 1}}}\n",
       "p.yaml:5:22: scene.limits.clear_of: a map was read; expected a list of "
       "{disc: {x, z, radius}} and {half_plane: {x, z, normal}}"},
      {"  limits: {clear_of: [{disk: {x: 1, z: 1, radius: 1}}]}\n",
       "p.yaml:5:24: scene.limits.clear_of: \"disk\" was read; expected a list "
       "of {disc: {x, z, radius}} and {half_plane: {x, z, normal}}; did you "
       "mean disc?"},
      {"  limits: {clear_of: [{disc: {x: 1, z: 1, radus: 1}}]}\n",
       "p.yaml:5:24: scene.limits.clear_of.disc.radius: missing; expected a "
       "number in m, > 0\n"
       "p.yaml:5:43: scene.limits.clear_of.disc.radus: unknown key; allowed in "
       "scene.limits.clear_of.disc: x, z, radius; did you mean radius?"},
      {"  limits: {clear_of: [{disc: {x: 1, z: one, radius: -1}}]}\n",
       "p.yaml:5:40: scene.limits.clear_of.disc.z: \"one\" is not a number: "
       "\"one\" has no meaning here; expected a number in m\n"
       "p.yaml:5:53: scene.limits.clear_of.disc.radius: \"-1\" is not allowed; "
       "expected a number in m, > 0"},
      {"  limits: {clear_of: [{half_plane: 90 deg}]}\n",
       "p.yaml:5:36: scene.limits.clear_of.half_plane: a single value was "
       "read; "
       "expected a map with the keys x, z, normal"},
      {"  limits: {clear_of: [{}, 3]}\n",
       "p.yaml:5:23: scene.limits.clear_of: a map of 0 keys was read; expected "
       "a list of {disc: {x, z, radius}} and {half_plane: {x, z, normal}}\n"
       "p.yaml:5:27: scene.limits.clear_of: a single value was read; expected "
       "a "
       "list of {disc: {x, z, radius}} and {half_plane: {x, z, normal}}"},
  };
  for (const auto& [keys, message] : mistakes) {
    EXPECT_EQ(errors(scene_with(keys)), message) << keys;
  }
}

TEST(MistakesInLimits, BringNoOthersAboutNumbersNobodyGave) {
  EXPECT_EQ(
      errors(scene_with("  contact: optimal\n"
                        "  limits: {curvature: {hump: two, valley: 2}}\n")),
      "p.yaml:6:30: scene.limits.curvature.hump: \"two\" is not a number: "
      "\"two\" has no meaning here; expected a number in 1/m, > 0");
}

TEST(Limits, AreRefusedByWhatKnowsTheFreeMotionAlone) {
  const std::string limits = "  limits: {friction: 1}\n";
  const std::string optimal =
      "  contact: optimal\n"
      "  limits: {curvature: {hump: 2, valley: 2}}\n";
  struct Refused {
    std::string keys, key, word, reason;
  };
  const std::string starts =
      "starts elsewhere are tried for the free motion alone";
  for (const auto& [keys, key, word, reason] : std::vector<Refused>{
           {"discretisation: {formulation: arc_length}\n",
            "p.yaml:%:31: discretisation.formulation", "arc_length",
            "straight pieces have neither forces nor curvatures to bound"},
           {"solver: {method: fsolve}\n", "p.yaml:%:18: solver.method",
            "fsolve",
            "the paper's discrete system consists of equations alone"},
           {"solver: {guess: straight}\n", "p.yaml:%:17: solver.guess",
            "straight", starts},
           {"solver: {guess: random}\n", "p.yaml:%:17: solver.guess", "random",
            starts}}) {
    for (const auto& [scene, line] :
         {std::pair{limits, "6"}, std::pair{optimal, "7"}}) {
      std::string place = key;
      place.replace(place.find('%'), 1, line);
      EXPECT_EQ(
          errors(scene_with(scene) + keys),
          place + ": " + word + " is not allowed with scene.limits: " + reason);
    }
    EXPECT_EQ(errors(scene_with("") + keys), "");
  }
  for (const std::string method : {"certify", "method"}) {
    EXPECT_EQ(
        errors(scene_with(limits) + "solver: {" + method + ": extremal}\n"),
        "");
  }
  EXPECT_EQ(errors("scene: {body: {shape: bead}, finish: {L: 3, H: 1}, "
                   "contact: optimal}\nsolver: {guess: straight}\n"),
            "p.yaml:2:17: solver.guess: straight is not allowed with contact: "
            "optimal: " +
                starts);
  for (const std::string& scene : {limits, optimal}) {
    EXPECT_EQ(errors(scene_with(scene) + "solver: {search: global}\n"), "");
  }
}

TEST(Limits, OfForcesAreInUnitsOfTheWeightAtA) {
  const auto in_field = [](const std::string& field, double least) {
    return errors(scene_with("").substr(0, scene_with("").find("  gravity")) +
                  "  field: {" + field + "}\n  limits: {normal_force: {min: " +
                  std::to_string(least) + "}}\n");
  };
  // A sphere so large that its field is uniform to a millionth.
  const auto sphere = [](const std::string& gravity) {
    return "sphere: {centre: {x: 0, z: 1.7e6}, radius: 1.7e6, "
           "surface_gravity: " +
           gravity + "}";
  };
  for (const std::string gravity : {"1.62", "50"}) {
    EXPECT_EQ(in_field("uniform: " + gravity, 0.3), "");
    EXPECT_EQ(in_field(sphere(gravity), 0.3), "");
    EXPECT_THAT(in_field("uniform: " + gravity, 1.5),
                HasSubstr("scene.limits.normal_force.min: 1.5"));
    EXPECT_THAT(in_field(sphere(gravity), 1.5),
                HasSubstr("scene.limits.normal_force.min: 1.5"));
  }
}

TEST(Limits, AreNotForGivenPaths) {
  EXPECT_EQ(errors(scene_with("  path: {shape: straight}\n"
                              "  contact: {end_slope: 0}\n"
                              "  limits: {floor: 2}\n")),
            "p.yaml:6:12: scene.contact: not allowed with scene.path: a given "
            "path has its slopes at A and B already; smooth or centre is\n"
            "p.yaml:7:11: scene.limits: not allowed with scene.path: a given "
            "path is evaluated as it is, and bound by nothing");
}

TEST(SweepsOfLimits, VaryANumberAndAWord) {
  const SweepFile file =
      sweep({"scene.limits.friction: {from: 0.3, to: 3, count: 10}",
             "scene.limits.curvature.of: [track, centre]"});

  ASSERT_EQ(file.num_scenes(), 20U);
  EXPECT_EQ(file.problem(0).scene.limits.friction, 0.3);
  EXPECT_EQ(file.problem(19).scene.limits.friction, 3.0);
  EXPECT_EQ(file.problem(1).scene.limits.curvature.of,
            CurvatureLimit::Of::Centre);
}

TEST(SweepsOfLimits, VaryTheContact) {
  const std::string limits = "  limits: {curvature: {hump: 2, valley: 2}}\n";
  const auto slopes = read_sweep_text(
      kCylinder + limits + "sweep: {scene.contact.end_slope: [-10 deg, 0.1]}\n",
      "p.yaml");
  const auto words = read_sweep_text(
      kCylinder + limits + "sweep: {scene.contact: [smooth, optimal]}\n",
      "p.yaml", {"scene.contact.end_slope=1"});

  EXPECT_DOUBLE_EQ(slopes.problem(0).scene.end_slope.value(),
                   -std::numbers::pi / 18.0);
  EXPECT_EQ(slopes.problem(1).scene.contact, Contact::EndSlope);
  EXPECT_EQ(words.problem(1).scene.contact, Contact::Optimal);
  EXPECT_FALSE(words.problem(0).scene.end_slope);
  const auto overridden = read_sweep_text(
      kCylinder + limits + "sweep: {scene.gravity: [1, 2]}\n", "p.yaml",
      {"sweep.scene.contact.end_slope=[0.1, 0.2, 0.3]"});
  EXPECT_EQ(overridden.num_scenes(), 6U);
}

TEST(SweepsOfLimits, AreCheckedSceneByScene) {
  // At L = 3, H = 1, k = 1/2 a straight track needs μ = 1/9.
  EXPECT_THAT(sweep_errors({"scene.limits.friction: [0.1, 0.12]"}),
              HasSubstr("p.yaml:5:27: scene.limits.friction: scene 0"));
  EXPECT_EQ(sweep_errors({"scene.limits.friction: [0.112, 0.12]"}), "");
  // A bound that varies is there, though the file has none.
  EXPECT_EQ(
      sweep_text_errors(kCylinder +
                        "  contact: optimal\n  limits: {fold_margin: 0.1}\n" +
                        section({"scene.limits.normal_force.max: [4, 5]"})),
      "");
  EXPECT_THAT(
      sweep_errors(
          {"scene.contact: [smooth]", "scene.contact.end_slope: [0.1]"}),
      HasSubstr("p.yaml:6:3: sweep.scene.contact.end_slope: not allowed "
                "beside sweep.scene.contact: a scene has one of them"));
}

}  // namespace
}  // namespace brachisto::io
