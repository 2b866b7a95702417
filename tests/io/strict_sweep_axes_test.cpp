// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What `zip` and `random` may contain, and how names may depend on each other.

#include <gtest/gtest.h>

#include <string>

#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

/// Messages of a sweep of two keys, with `zip` in line 7.
std::string zip_errors(const std::string& zip) {
  return sweep_errors(
      {"scene.finish.L: [2, 3]", "scene.finish.H: [1, 2]", "zip: " + zip});
}

TEST(StrictZip, IsAListOfKeysOrOfSuchLists) {
  const std::string expected =
      " was read; expected a list of keys that run together, or a list of such "
      "lists";

  EXPECT_EQ(zip_errors("[[scene.finish.L, scene.finish.H]]"), "");
  EXPECT_EQ(zip_errors("scene.finish.L"),
            "p.yaml:7:8: sweep.zip: a single value" + expected);
  EXPECT_EQ(zip_errors(""), "p.yaml:7:3: sweep.zip: no value" + expected);
  EXPECT_EQ(zip_errors("[scene.finish.L, [scene.finish.H]]"),
            "p.yaml:7:25: sweep.zip: a list" + expected);
}

TEST(StrictZip, NeedsTwoKeys) {
  const std::string message =
      " sweep.zip: two keys at least have to run together";

  EXPECT_EQ(zip_errors("[]"), "") << "none is as good as no zip";
  EXPECT_EQ(zip_errors("[scene.finish.L]"), "p.yaml:7:8:" + message);
  EXPECT_EQ(zip_errors("[[scene.finish.L, scene.finish.H], []]"),
            "p.yaml:7:43:" + message);
}

TEST(StrictZip, NamesKeysThatVary) {
  EXPECT_EQ(zip_errors("[scene.finish.L, scene.finish.h]"),
            "p.yaml:7:25: sweep.zip: \"scene.finish.h\" does not vary in this "
            "sweep; these do: scene.finish.L, scene.finish.H; did you mean "
            "scene.finish.H?");
  EXPECT_EQ(sweep_errors({"scene.finish.L: [2, 3]", "scene.finish.H: L/3",
                          "zip: [scene.finish.L, scene.finish.H]"}),
            "p.yaml:7:25: sweep.zip: scene.finish.H has no list and no range "
            "to run along");
  EXPECT_EQ(sweep_errors({"scene.finish.L: [2, 3]",
                          "random: {count: 2, ranges: {scene.finish.H: {from: "
                          "1, to: 2}}}",
                          "zip: [scene.finish.L, scene.finish.H]"}),
            "p.yaml:7:25: sweep.zip: scene.finish.H is random, and all random "
            "keys run together anyway");
}

TEST(StrictZip, NamesAKeyOnce) {
  EXPECT_EQ(zip_errors("[scene.finish.L, scene.finish.L]"),
            "p.yaml:7:25: sweep.zip: scene.finish.L is named twice");
}

TEST(StrictZip, NeedsEquallyManyValues) {
  EXPECT_EQ(sweep_errors({"scene.finish.L: [2, 3]",
                          "scene.finish.H: {from: 1, to: 2, count: 3}",
                          "zip: [scene.finish.L, scene.finish.H]"}),
            "p.yaml:7:8: sweep.zip: keys that run together need equally many "
            "values: scene.finish.L has 2, scene.finish.H has 3");
}

TEST(StrictRandom, HasCountAndRanges) {
  EXPECT_EQ(sweep_errors({"random: {sead: 1}"}),
            "p.yaml:5:3: sweep.random.count: missing; expected an integer, "
            "from 1 to 10 million\n"
            "p.yaml:5:3: sweep.random.ranges: missing; expected a map of the "
            "keys that are random, each with from and to\n"
            "p.yaml:5:12: sweep.random.sead: unknown key; allowed in "
            "sweep.random: seed, count, ranges; did you mean seed?");
  EXPECT_EQ(sweep_errors({"random: {count: 2.5, seed: -1, ranges: {}}"}),
            "p.yaml:5:19: sweep.random.count: \"2.5\" is not an integer; "
            "expected an integer, from 1 to 10 million\n"
            "p.yaml:5:30: sweep.random.seed: \"-1\" is not allowed; expected "
            "an integer, ≥ 0\n"
            "p.yaml:5:42: sweep.random.ranges: an empty map was read; expected "
            "a map of the keys that are random, each with from and to");
  EXPECT_EQ(sweep_errors({"random: 7"}),
            "p.yaml:5:11: sweep.random: a single value was read; expected a "
            "map with seed, count and ranges");
}

TEST(StrictRandom, RangesHaveTwoEnds) {
  const auto error = [](const std::string& range) {
    return sweep_errors({"random: {count: 2, ranges: {" + range + "}}"});
  };

  EXPECT_EQ(error("scene.body.k: [0, 1]"),
            "p.yaml:5:45: sweep.random.ranges.scene.body.k: a list was read; "
            "expected a map with from, to and, if need be, spacing");
  EXPECT_EQ(error("scene.body.k: {from: 0, to: 1, count: 3}"),
            "p.yaml:5:62: sweep.random.ranges.scene.body.k.count: unknown key; "
            "allowed in sweep.random.ranges.scene.body.k: from, to, spacing");
  EXPECT_EQ(error("scene.body.k: {from: 0}"),
            "p.yaml:5:31: sweep.random.ranges.scene.body.k.to: missing; "
            "expected a number, 0 ≤ k ≤ 1 − η_m²");
  EXPECT_EQ(error("k: {from: 0, to: 1}"),
            "p.yaml:5:31: sweep.random.ranges.k: a key that varies is written "
            "in full: scene.body.k");
}

TEST(StrictRandom, OnlyRealNumbersAre) {
  EXPECT_EQ(sweep_errors({"random: {count: 2, ranges: {solver.seed: {from: 0, "
                          "to: 1}}}"}),
            "p.yaml:5:31: sweep.random.ranges.solver.seed: only real numbers "
            "can be random, and this key has an integer, ≥ 0");
  EXPECT_EQ(sweep_errors({"random: {count: 2, ranges: {solver.guess: {from: 0, "
                          "to: 1}}}"}),
            "p.yaml:5:31: sweep.random.ranges.solver.guess: only real numbers "
            "can be random, and this key has cycloid or straight or random");
}

TEST(StrictNames, HaveAValue) {
  EXPECT_EQ(
      sweep_text_errors("scene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n"
                        "sweep: {scene.body.mass: [r, k + r]}\n"),
      "p.yaml:2:26: sweep.scene.body.mass: \"r\" names r, but "
      "scene.body.radius has no value, neither outside of the sweep nor in it\n"
      "p.yaml:2:26: sweep.scene.body.mass: \"k + r\" names k, but scene.body.k "
      "has no value, neither outside of the sweep nor in it");
}

TEST(StrictNames, WhoseValueIsAMistakeAreNotCalledMissing) {
  EXPECT_EQ(sweep_text_errors(
                "scene: {body: {shape: bead}, finish: {L: three, H: 1}}\n"
                "sweep: {scene.body.mass: [L]}\n"),
            "p.yaml:1:42: scene.finish.L: \"three\" is not a number: \"three\" "
            "has no meaning here; expected a number in m, > 0");
}

TEST(StrictNames, DoNotDependOnThemselves) {
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1, k]"}),
            "p.yaml:5:17: sweep.scene.body.k: its value depends on itself: "
            "scene.body.k needs scene.body.k");
  EXPECT_EQ(sweep_errors({"scene.finish.L: 2*H", "scene.body.mass: L",
                          "scene.finish.H: {from: 1, to: k, count: 2}",
                          "scene.body.k: 1/L"}),
            "p.yaml:5:19: sweep.scene.finish.L: its value depends on itself: "
            "scene.finish.L needs scene.finish.H needs scene.body.k needs "
            "scene.finish.L");
}

}  // namespace
}  // namespace brachisto::io
