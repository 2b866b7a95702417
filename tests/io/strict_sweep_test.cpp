// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the section `sweep` may contain.

#include <gtest/gtest.h>

#include <string>

#include "io/reading.hpp"
#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

const std::string kExpectedSweep =
    "expected a map of the keys that vary, as in {scene.body.eta_m: [0, 1/3]}";

TEST(StrictSweep, AFunctionIsNoQuantity) {
  EXPECT_EQ(sweep_errors({"scene.body.eta_m: [0, tan]"}),
            "p.yaml:5:25: sweep.scene.body.eta_m: \"tan\" is not a number: "
            "\"tan\" is a function, whose argument follows in parentheses; "
            "expected a number, 0 ≤ η_m < 1");
}

TEST(StrictSweep, OneProblemHasNone) {
  EXPECT_EQ(errors(kCylinder + section({"scene.body.k: [0.1]"})),
            "p.yaml:4:1: sweep: this section makes the file a sweep of many "
            "scenes, not one problem; `brachisto sweep FILE` solves them all");
}

TEST(StrictSweep, ASweepHasOne) {
  EXPECT_EQ(sweep_text_errors(kCylinder),
            "p.yaml:1:1: sweep: missing; " + kExpectedSweep +
                "; for a single scene there is `brachisto solve FILE`");
}

TEST(StrictSweep, IsAMapWithAKeyAtLeast) {
  EXPECT_EQ(sweep_text_errors(kCylinder + "sweep: {}\n"),
            "p.yaml:4:1: sweep: no key varies; " + kExpectedSweep);
  EXPECT_EQ(sweep_text_errors(kCylinder + "sweep: {warm_start: false}\n"),
            "p.yaml:4:1: sweep: no key varies; " + kExpectedSweep);
  EXPECT_EQ(sweep_text_errors(kCylinder + "sweep:\n"),
            "p.yaml:4:1: sweep: no value was read; " + kExpectedSweep);
  EXPECT_EQ(sweep_text_errors(kCylinder + "sweep: [1]\n"),
            "p.yaml:4:8: sweep: a list was read; " + kExpectedSweep);
}

TEST(StrictSweep, UnknownKeysGetTheNearestKnown) {
  EXPECT_EQ(sweep_errors({"scene.body.eta: [0]"}),
            "p.yaml:5:3: sweep.scene.body.eta: unknown key; allowed in sweep: "
            "keys of the problem in full, such as scene.body.eta_m, and zip, "
            "random, warm_start, keep; did you mean scene.body.eta_m?");
  EXPECT_NE(sweep_errors({"zap: [0]"}).find("did you mean zip?"),
            std::string::npos);
}

TEST(StrictSweep, KeysAreWrittenInFull) {
  EXPECT_EQ(sweep_errors({"eta_m: [0]"}),
            "p.yaml:5:3: sweep.eta_m: a key that varies is written in full: "
            "scene.body.eta_m");
  EXPECT_EQ(sweep_errors({"tolerance: [0]"}),
            "p.yaml:5:3: sweep.tolerance: a key that varies is written in "
            "full: discretisation.tolerance or solver.tolerance");
  EXPECT_EQ(sweep_errors(
                {"solver: {limits: {iterations: [1]}}", "scene.finish: [1]"}),
            "p.yaml:5:3: sweep.solver: a map; its keys vary one by one, each "
            "written with dots: solver.method, solver.linear_solver, "
            "solver.threads, solver.tolerance, solver.search, solver.polish, "
            "solver.certify, "
            "solver.sensitivities, solver.guess, solver.seed, "
            "solver.limits.iterations, "
            "solver.limits.seconds, solver.fsolve.quadrature, "
            "solver.fsolve.datum, solver.fsolve.slopes, "
            "solver.fsolve.epsilon, solver.fsolve.variant\n"
            "p.yaml:6:3: sweep.scene.finish: a map; its keys vary one by one, "
            "each written with dots: scene.finish.L, scene.finish.H");
}

TEST(StrictSweep, SomeKeysCannotVary) {
  EXPECT_EQ(sweep_errors({"version: [1]", "constraints: [1]"}),
            "p.yaml:5:3: sweep.version: the version of the file format cannot "
            "vary\n"
            "p.yaml:6:3: sweep.constraints: reserved for a later version of "
            "brachisto");
}

TEST(StrictSweep, KeysVaryOnce) {
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1]", "scene.body.k: [0.2]"}),
            "p.yaml:6:3: sweep.scene.body.k: repeated key; first given in "
            "line 5");
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1]",
                          "random: {count: 2, ranges: {scene.body.k: {from: "
                          "0, to: 1}}}"}),
            "p.yaml:6:31: sweep.random.ranges.scene.body.k: repeated key; "
            "sweep.scene.body.k varies it already");
}

TEST(StrictSweep, ListsHaveValuesOfOneKind) {
  EXPECT_EQ(sweep_errors({"scene.body.k: []"}),
            "p.yaml:5:17: sweep.scene.body.k: an empty list was read; expected "
            "a list, a map with from, to and count, or one number");
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1, tenth, [1], 0.2]"}),
            "p.yaml:5:23: sweep.scene.body.k: \"tenth\" is not a number: "
            "\"tenth\" has no meaning here; expected a number, 0 ≤ k ≤ 1 − "
            "η_m²\n"
            "p.yaml:5:30: sweep.scene.body.k: a list was read; expected a "
            "number, 0 ≤ k ≤ 1 − η_m²");
  EXPECT_EQ(sweep_errors({"solver.guess: [random, strait, 3, ~]"}),
            "p.yaml:5:26: sweep.solver.guess: \"strait\" was read; expected "
            "cycloid or straight or random; did you mean straight?\n"
            "p.yaml:5:34: sweep.solver.guess: \"3\" was read; expected cycloid "
            "or straight or random\n"
            "p.yaml:5:37: sweep.solver.guess: no value was read; expected "
            "cycloid or straight or random");
}

TEST(StrictSweep, KeysHaveAValue) {
  EXPECT_EQ(sweep_errors({"scene.body.k:", "solver.guess:"}),
            "p.yaml:5:3: sweep.scene.body.k: no value was read; expected a "
            "list, a map with from, to and count, or one number\n"
            "p.yaml:6:3: sweep.solver.guess: no value was read; expected a "
            "list of words: cycloid or straight or random");
}

TEST(StrictSweep, RangesHaveFromToAndCount) {
  EXPECT_EQ(sweep_errors({"scene.body.k: {form: 0}"}),
            "p.yaml:5:3: sweep.scene.body.k.from: missing; expected a number, "
            "0 ≤ k ≤ 1 − η_m²\n"
            "p.yaml:5:3: sweep.scene.body.k.count: missing; expected an "
            "integer, from 1 to 10 million\n"
            "p.yaml:5:3: sweep.scene.body.k.to: missing; expected a number, "
            "0 ≤ k ≤ 1 − η_m²\n"
            "p.yaml:5:18: sweep.scene.body.k.form: unknown key; allowed in "
            "sweep.scene.body.k: from, to, count, spacing; did you mean "
            "from?");
  EXPECT_EQ(sweep_errors({"scene.body.k: {from: sqr(2), to: [1], count: 2, "
                          "spacing: logarithmic}"}),
            "p.yaml:5:24: sweep.scene.body.k.from: \"sqr(2)\" is not a number: "
            "\"sqr\" has no meaning here; did you mean sqrt?; expected a "
            "number, 0 ≤ k ≤ 1 − η_m²\n"
            "p.yaml:5:36: sweep.scene.body.k.to: a list was read; expected a "
            "number, 0 ≤ k ≤ 1 − η_m²\n"
            "p.yaml:5:60: sweep.scene.body.k.spacing: \"logarithmic\" was "
            "read; expected linear or log");
  EXPECT_EQ(sweep_errors({"solver.guess: {from: cycloid, to: random, count: "
                          "2}"}),
            "p.yaml:5:17: sweep.solver.guess: a map was read; expected a list "
            "of words: cycloid or straight or random");
}

TEST(StrictSweep, CountsAreIntegersFromOneOn) {
  const auto error = [](const std::string& count) {
    return sweep_errors(
        {"scene.body.k: {from: 0, to: 1, count: " + count + "}"});
  };
  const std::string begin = "p.yaml:5:41: sweep.scene.body.k.count: ";
  const std::string end = "; expected an integer, from 1 to 10 million";

  EXPECT_EQ(error("2.5"), begin + "\"2.5\" is not an integer" + end);
  EXPECT_EQ(error("0"), begin + "\"0\" is not allowed" + end);
  EXPECT_EQ(error("-3"), begin + "\"-3\" is not allowed" + end);
  EXPECT_EQ(error("1e7+1"), begin + "\"1e7+1\" is not allowed" + end);
  EXPECT_EQ(error("1e300"), begin + "\"1e300\" is not allowed" + end);
  EXPECT_EQ(error("plenty"),
            begin +
                "\"plenty\" is not a number: \"plenty\" has no "
                "meaning here" +
                end);
  EXPECT_EQ(error("L"), begin +
                            "\"L\" is not a number: \"L\" has no meaning here; "
                            "only numbers of the section sweep may name "
                            "quantities" +
                            end);
  EXPECT_EQ(error("{}"), begin + "a map was read" + end);
}

TEST(StrictSweep, OneValueHasNoEndToGoTo) {
  EXPECT_EQ(sweep_errors({"scene.body.k: {from: 0, to: 1, count: 1}"}),
            "p.yaml:5:31: sweep.scene.body.k.to: not used: with count 1 there "
            "is only the value from; leave to out");
}

TEST(StrictSweep, WarmStartIsTrueOrFalse) {
  EXPECT_EQ(
      sweep_errors({"scene.body.k: [0.1]", "warm_start: yes"}),
      "p.yaml:6:15: sweep.warm_start: \"yes\" was read; expected false or "
      "true");
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1]", "warm_start: [true]"}),
            "p.yaml:6:15: sweep.warm_start: a list was read; expected false or "
            "true");
}

TEST(StrictSweep, WhatIsKeptIsNothingOrTracks) {
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1]", "keep: track"}),
            "p.yaml:6:9: sweep.keep: \"track\" was read; expected nothing or "
            "tracks; did you mean tracks?");
}

TEST(StrictSweep, AllMistakesAreReportedAtOnce) {
  EXPECT_EQ(
      sweep_text_errors("scene:\n"
                        "  body: {shape: cylinder, raduis: 1, k: 1/2}\n"
                        "  finish: {L: 3, H: -1}\n"
                        "sweep:\n"
                        "  scene.body.radius: [0.2, x]\n"
                        "  scene.body.eta: [0]\n"),
      "p.yaml:2:27: scene.body.raduis: unknown key; allowed in scene.body: "
      "shape, radius, eta_m, theta_m, k, inertia, rails, groove, parts, mass; "
      "did you mean radius?\n"
      "p.yaml:3:21: scene.finish.H: -1 m is not allowed: it must be > 0, for B "
      "lies below A (z points down)\n"
      "p.yaml:5:28: sweep.scene.body.radius: \"x\" is not a number: \"x\" has "
      "no meaning here; expected a number in m, > 0\n"
      "p.yaml:6:3: sweep.scene.body.eta: unknown key; allowed in sweep: keys "
      "of the problem in full, such as scene.body.eta_m, and zip, random, "
      "warm_start, keep; did you mean scene.body.eta_m?");
}

TEST(StrictSweep, NamesAreForTheSectionOnly) {
  EXPECT_EQ(errors(cylinder("radius: 1/3, k: 1/2, eta_m: sqrt(1-k)")),
            "p.yaml:3:55: scene.body.eta_m: \"sqrt(1-k)\" is not a number: "
            "\"k\" has no meaning here; only numbers of the section sweep may "
            "name quantities; expected a number, 0 ≤ η_m < 1");
}

}  // namespace
}  // namespace brachisto::io
