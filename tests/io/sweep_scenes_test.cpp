// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Sweeps: every scene is checked when the file is read.

#include <gtest/gtest.h>

#include <string>

#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

TEST(SweepScenes, AMistakeTellsTheSceneAndItsValues) {
  EXPECT_EQ(
      sweep_errors({"scene.body.k: [0.1, 0.5]", "scene.body.eta_m: [0, 0.8]"}),
      "p.yaml:5:23: scene.body.k: scene 3 (scene.body.k = 0.5, "
      "scene.body.eta_m = 0.8): 0.5 is not allowed: k ≤ 1 − η_m² = "
      "0.35999999999999993 for η_m = 0.8, reached when all mass sits on "
      "the rim");
}

TEST(SweepScenes, AMistakeInAKeyThatDoesNotVaryIsToldWhereItStands) {
  EXPECT_EQ(sweep_errors({"scene.body.eta_m: {from: 0, to: 0.8, count: 2}"}),
            "p.yaml:2:43: scene.body.k: scene 1 (scene.body.eta_m = 0.8): 0.5 "
            "is not allowed: k ≤ 1 − η_m² = 0.35999999999999993 for η_m = 0.8, "
            "reached when all mass sits on the rim");
}

TEST(SweepScenes, TheFirstOfManyAreToldAndTheOthersCounted) {
  const std::string reason =
      " m is not allowed: it must be > 0, for B lies to the right of A";

  EXPECT_EQ(
      sweep_errors({"scene.finish.L: {from: -3, to: 3, count: 7}"}),
      "p.yaml:5:19: scene.finish.L: scene 0 (scene.finish.L = -3): -3" +
          reason +
          "\n"
          "p.yaml:5:19: scene.finish.L: scene 1 (scene.finish.L = -2): -2" +
          reason +
          "\n"
          "p.yaml:5:19: scene.finish.L: scene 2 (scene.finish.L = -1): -1" +
          reason + "; 1 more scene has a mistake in this key");
  EXPECT_NE(sweep_errors({"scene.finish.L: {from: -3, to: 0, count: 7000}"})
                .find("; 6997 more scenes have a mistake in this key"),
            std::string::npos);
}

TEST(SweepScenes, BoundsOfTheProgramHoldInEach) {
  EXPECT_EQ(sweep_errors({"solver.tolerance: [1e-9, 1]"}),
            "p.yaml:5:28: solver.tolerance: scene 1 (solver.tolerance = 1): "
            "\"1\" is not allowed; expected a number, from 1e-14 to 1e-6");
  EXPECT_EQ(sweep_errors({"solver.seed: {from: 1, to: 2, count: 3}"}),
            "p.yaml:5:16: solver.seed: scene 1 (solver.seed = 1.5): \"1.5\" is "
            "not an integer; expected an integer, ≥ 0");
}

TEST(SweepScenes, ConsistencyHoldsInEach) {
  EXPECT_EQ(sweep_errors({"discretisation.nodes: [21]",
                          "discretisation.degree: [5, 6]"}),
            "p.yaml:5:26: discretisation.nodes: scene 1 (discretisation.nodes "
            "= 21, discretisation.degree = 6): 21 is not allowed; nodes − 1 is "
            "a multiple of the degree 6; nearest: 19 or 25");
  EXPECT_EQ(sweep_errors({"scene.body.shape: [cylinder, bead]"}),
            "p.yaml:2:27: scene.body.radius: scene 1 (scene.body.shape = "
            "bead): a bead has no radius; allowed of a bead: shape, mass\n"
            "p.yaml:2:40: scene.body.k: scene 1 (scene.body.shape = bead): a "
            "bead has no k; allowed of a bead: shape, mass");
  EXPECT_EQ(sweep_text_errors("scene: {body: {}, finish: {L: 3, H: 1}}\n"
                              "sweep: {scene.body.shape: [bead, cylinder]}\n"),
            "p.yaml:1:9: scene.body.radius: scene 1 (scene.body.shape = "
            "cylinder): missing; expected a number in m, > 0 (r, radius of the "
            "cylinder; of a ball R)\n"
            "p.yaml:1:9: scene.body.k: scene 1 (scene.body.shape = cylinder): "
            "missing; expected a number, 0 ≤ k ≤ 1 − η_m² (k = I_cm/(m r²), "
            "moment of inertia about the centre of mass)");
}

TEST(SweepScenes, WhatAllShareIsToldOnce) {
  EXPECT_EQ(sweep_text_errors(
                "scene: {body: {shape: bead}, finish: {L: 3, H: -1}}\n"
                "discretisation: {nodes: 200}\n"
                "sweep: {scene.finish.L: [1, 2], scene.body.k: [0.1]}\n"),
            "p.yaml:1:48: scene.finish.H: -1 m is not allowed: it must be > 0, "
            "for B lies below A (z points down)\n"
            "p.yaml:2:25: discretisation.nodes: 200 is not allowed; nodes − 1 "
            "is a multiple of the degree 5; nearest: 196 or 201\n"
            "p.yaml:3:33: scene.body.k: a bead has no k; allowed of a bead: "
            "shape, mass");
}

TEST(SweepScenes, MistakesOfScenesStandBesideThoseOfTheFile) {
  EXPECT_EQ(
      sweep_text_errors("scene: {body: {shape: bead}, finish: {H: 1}}\n"
                        "sweep: {scene.finish.L: [1, -2]}\n"
                        "solver: ipopt\n"),
      "p.yaml:2:29: scene.finish.L: scene 1 (scene.finish.L = -2): -2 m "
      "is not allowed: it must be > 0, for B lies to the right of A\n"
      "p.yaml:3:9: solver: a single value was read; expected a map with "
      "the keys method, linear_solver, threads, tolerance, search, polish, "
      "certify, sensitivities, guess, seed, limits, fsolve");
}

TEST(SweepScenes, KeysUnderSomethingElseThanAMapAreNoHarm) {
  EXPECT_EQ(
      sweep_text_errors("scene: {body: {shape: bead}, finish: {L: 1, H: 1}}\n"
                        "solver: ipopt\n"
                        "sweep: {solver.guess: [cycloid, straight]}\n"),
      "p.yaml:2:9: solver: a single value was read; expected a map with "
      "the keys method, linear_solver, threads, tolerance, search, polish, "
      "certify, sensitivities, guess, seed, limits, fsolve");
}

TEST(SweepScenes, ValuesAreFinite) {
  EXPECT_EQ(sweep_errors({"scene.body.eta_m: sqrt(0.5 - k)",
                          "scene.body.k: [0.5, 0.6]"}),
            "p.yaml:5:21: sweep.scene.body.eta_m: scene 1 (scene.body.k = "
            "0.6): \"sqrt(0.5 - k)\" is not a number: its value is not finite");
  EXPECT_EQ(sweep_errors({"scene.body.mass: {from: k, to: 1e308*10*L, count: "
                          "2}"}),
            "p.yaml:5:20: sweep.scene.body.mass: scene 0: \"1e308*10*L\" is "
            "not a number: its value is not finite\n"
            "p.yaml:5:20: sweep.scene.body.mass: scene 1: \"1e308*10*L\" is "
            "not a number: its value is not finite");
}

TEST(SweepScenes, ConstantPartsAreFiniteInEach) {
  EXPECT_EQ(
      sweep_errors({"scene.finish.L: [1, 2]", "scene.body.mass: min(L, 1/0)"}),
      "p.yaml:6:20: sweep.scene.body.mass: scene 0 (scene.finish.L = 1): "
      "\"min(L, 1/0)\" is not a number: a part of it is not finite\n"
      "p.yaml:6:20: sweep.scene.body.mass: scene 1 (scene.finish.L = 2): "
      "\"min(L, 1/0)\" is not a number: a part of it is not finite");
}

TEST(SweepScenes, LogNeedsEndsOfOneSign) {
  for (const std::string ends : {"from: 0, to: 1", "from: 1, to: 0",
                                 "from: -1, to: 1", "from: 1, to: -k"}) {
    EXPECT_NE(sweep_errors({"scene.body.theta_m: {" + ends +
                            ", count: 2, spacing: log}"})
                  .find("p.yaml:5:23: sweep.scene.body.theta_m: scene 0: "
                        "spacing: log needs from and to of the same sign, and "
                        "not 0"),
              std::string::npos)
        << ends;
  }
}

TEST(SweepScenes, AreAtMostTenMillion) {
  EXPECT_EQ(sweep_errors({"scene.body.k: {from: 0, to: 1, count: 1e4}",
                          "scene.finish.L: {from: 1, to: 2, count: 1001}"}),
            "p.yaml:4:1: sweep: 10000 × 1001 scenes are too many; allowed are "
            "10 million");
  // 2^64 + … would look small.
  EXPECT_EQ(sweep_errors({"scene.body.k: {from: 0, to: 1, count: 2^23}",
                          "scene.finish.L: {from: 1, to: 2, count: 2^23}",
                          "scene.finish.H: {from: 1, to: 2, count: 2^18}"}),
            "p.yaml:4:1: sweep: 8388608 × 8388608 × 262144 scenes are too "
            "many; allowed are 10 million");
}

}  // namespace
}  // namespace brachisto::io
