// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The flag --set KEY=VALUE.

#include <gtest/gtest.h>

#include <string>

#include "io/reading.hpp"

namespace brachisto::io {
namespace {

TEST(Overrides, ReplaceAKey) {
  const ProblemFile problem = read(kBead, {"scene.finish.L=2^2"});

  EXPECT_EQ(problem.scene.L, 4.0);
}

TEST(Overrides, AddAKeyAndTheMapsAboveIt) {
  const ProblemFile problem =
      read(kBead, {"solver.limits.iterations=7", "scene.gravity=1.62"});

  EXPECT_EQ(problem.options.limits.iterations, 7);
  EXPECT_EQ(problem.scene.gravity, 1.62);
}

TEST(Overrides, FillAnEmptySection) {
  const ProblemFile problem =
      read(kBead + "solver:\n", {"solver.guess=straight"});

  EXPECT_EQ(problem.options.of<Collocation>()->guess, Guess::Straight);
}

TEST(Overrides, TakeFlowCollections) {
  const ProblemFile problem =
      read(cylinder("radius: 1/3, k: 1/2"), {"scene.body={shape: bead}"});

  EXPECT_EQ(problem.scene.body.shape, Shape::Bead);
  EXPECT_EQ(problem.scene.body.radius, 0.0);
}

TEST(Overrides, MayContainEqualsSigns) {
  EXPECT_EQ(errors(kBead, {"scene.finish.L=a=3"}),
            "--set scene.finish.L=a=3: scene.finish.L: \"a=3\" is not a "
            "number: \"a\" has no meaning here; expected a number in m, > 0");
}

TEST(Overrides, TheLastOneWins) {
  const ProblemFile problem =
      read(kBead, {"scene.finish.L=4", "scene.finish.L=5"});

  EXPECT_EQ(problem.scene.L, 5.0);
}

TEST(Overrides, RepairAMistakeOfTheFile) {
  EXPECT_EQ(errors(cylinder("radius: 0, k: 1/2"), {"scene.body.radius=1"}), "");
}

TEST(Overrides, NoneIsLostBehindAValue) {
  EXPECT_EQ(errors(kBead, {"scene.finish.L.y=1"}),
            "--set scene.finish.L.y=1: scene.finish.L.y: scene.finish.L has a "
            "value, and no keys of its own");
}

TEST(Overrides, OfAListNameAllOfIt) {
  const std::string list =
      "scene.limits={clear_of: [{disc: {x: 1, z: 2, radius: 0.1}}]}";
  for (const std::string key : {"foo", "disc.radius", "0.disc.radius"}) {
    const std::string change = "scene.limits.clear_of." + key;
    EXPECT_EQ(errors(kBead, {list, change + "=0.2"}),
              "--set " + change + "=0.2: " + change +
                  ": scene.limits.clear_of is a list; expected one for all of "
                  "it, as in scene.limits.clear_of=[…]");
  }
}

TEST(Overrides, ErrorsNameTheOverrideBehindThoseOfTheFile) {
  EXPECT_EQ(errors(kBead + "q: 1\n", {"solver.guess=strait", "scene.finish.H=0",
                                      "solver.limits.second=3"}),
            "p.yaml:2:1: q: unknown key; allowed at the top level: version, "
            "scene, discretisation, solver, sweep, work_precision, design\n"
            "--set solver.guess=strait: solver.guess: \"strait\" was read; "
            "expected cycloid or straight or random; did you mean straight?\n"
            "--set scene.finish.H=0: scene.finish.H: 0 m is not allowed: it "
            "must be > 0, for B lies below A (z points down)\n"
            "--set solver.limits.second=3: solver.limits.second: unknown key; "
            "allowed in solver.limits: iterations, seconds; did you mean "
            "seconds?");
}

TEST(Overrides, AreStrictYamlToo) {
  EXPECT_EQ(errors(kBead, {"scene.finish.L=[3"}),
            "--set scene.finish.L=[3: scene.finish.L: not valid YAML: end of "
            "sequence flow not found");
  EXPECT_EQ(errors(kBead, {"scene.finish={L: 3, L: 4, H: 1}"}),
            "--set scene.finish={L: 3, L: 4, H: 1}: scene.finish.L: repeated "
            "key; first given in line 1");
  EXPECT_EQ(errors(kBead, {"scene.finish.L=!!int 3"}),
            "--set scene.finish.L=!!int 3: scene.finish.L: tags (!) are not "
            "allowed");
  EXPECT_EQ(errors(kBead, {"scene.finish.L="}),
            "--set scene.finish.L=: scene.finish.L: no value was read; "
            "expected a number in m, > 0");
}

TEST(Overrides, NeedAKeyAndAValue) {
  for (const std::string text : {"scene.finish.L", "=3", "", ".scene=3",
                                 "scene..finish=3", "scene.=3"}) {
    EXPECT_EQ(errors(kBead, {text}),
              "--set " + text +
                  ": not an override; expected KEY=VALUE, as in "
                  "scene.body.k=1/2");
  }
}

TEST(Overrides, OfKeysThatNestWithoutEndAreRefused) {
  for (const std::string first : {"scene", "sweep"}) {
    std::string key = first;
    for (int i = 0; i < 50'000; ++i) key += ".a";
    const std::string message = errors(kBead, {key + "=1"});
    EXPECT_NE(message.find("nests more than 32 levels"), std::string::npos)
        << message;
  }
}

TEST(Overrides, DoNotHideThatTheFileHasNoMapThere) {
  EXPECT_EQ(
      errors(kBead + "solver: ipopt\n", {"solver.guess=straight"}),
      "p.yaml:2:9: solver: a single value was read; expected a map with "
      "the keys method, linear_solver, threads, tolerance, search, polish, "
      "certify, sensitivities, guess, seed, limits, fsolve");
}

}  // namespace
}  // namespace brachisto::io
