// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The flag --set KEY=VALUE and sweeps.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

using ::testing::ElementsAre;

TEST(SweepOverrides, ReplaceWhatDoesNotVary) {
  const SweepFile file =
      sweep({"scene.body.eta_m: {from: 0, to: sqrt(1-k), count: 2}"},
            {"scene.body.k=0.75", "solver.guess=straight"});

  EXPECT_THAT(numbers(file), ElementsAre(0, 0.5));
  EXPECT_EQ(file.problem(0).options.of<Collocation>()->guess, Guess::Straight);
}

TEST(SweepOverrides, ReplaceWordsOfTheSection) {
  EXPECT_TRUE(
      sweep({"scene.body.k: [0.1]"}, {"sweep.warm_start=true"}).warm_start());
}

TEST(SweepOverrides, TakeAKeyAwayByNull) {
  const std::vector<std::string> said{
      "scene.body.k: [0.1, 0.2]", "scene.finish.L: [2, 3]",
      "zip: [scene.body.k, scene.finish.L]", "warm_start: true"};
  EXPECT_EQ(sweep(said).num_scenes(), 2u);
  EXPECT_EQ(sweep(said, {"sweep.zip=null"}).num_scenes(), 4u);
  EXPECT_FALSE(sweep(said, {"sweep.warm_start=null"}).warm_start());
  EXPECT_EQ(
      sweep(said, {"sweep.zip=null", "sweep.scene.body.k=null"}).num_scenes(),
      2u);
  EXPECT_EQ(sweep({"random: {seed: 2, count: 5, ranges: {scene.body.k: {from: "
                   "0.1, to: 1, spacing: log}}}"},
                  {"sweep.random.seed=null",
                   "sweep.random.ranges.scene.body.k.spacing=null"})
                .num_scenes(),
            5u);
}

TEST(SweepOverrides, TakeKeysOfTheProblemAsOneKeyOfTheSection) {
  EXPECT_THAT(numbers(sweep({"scene.body.k: {from: 0, to: 1, count: 9}"},
                            {"sweep.scene.body.k.count=3"})),
              ElementsAre(0, 0.5, 1));
  EXPECT_THAT(numbers(sweep({"scene.body.k: {from: 0, to: 1, count: 9}"},
                            {"sweep.scene.body.k=[0.1, 0.2]"})),
              ElementsAre(0.1, 0.2));
  EXPECT_EQ(
      sweep({"scene.body.k: [0.1, 0.2]"}, {"sweep.scene.finish.L=[1, 2, 3]"})
          .num_scenes(),
      6u);
}

TEST(SweepOverrides, ReachRandomRanges) {
  const SweepFile file = sweep(
      {"random: {count: 5, ranges: {scene.body.k: {from: 0, to: 1}}}"},
      {"sweep.random.count=2", "sweep.random.ranges.scene.body.k.from=0.9999"});

  EXPECT_EQ(file.num_scenes(), 2u);
  EXPECT_GE(number(file, 0, 0), 0.9999);
}

TEST(SweepOverrides, ReplaceTheSection) {
  EXPECT_EQ(
      sweep({"nonsense: 3"}, {"sweep={scene.body.k: [0.1, 0.2]}"}).num_scenes(),
      2u);
}

TEST(SweepOverrides, MayMakeASweepOfAProblem) {
  EXPECT_EQ(
      read_sweep_text(kCylinder, "p.yaml", {"sweep.scene.body.k=[0.1, 0.2]"})
          .num_scenes(),
      2u);
}

TEST(SweepOverrides, OfAKeyThatVariesWouldHaveNoEffect) {
  EXPECT_EQ(sweep_errors({"scene.body.k: [0.1]"}, {"scene.body.k=0.3"}),
            "--set scene.body.k=0.3: scene.body.k: this key varies, so that "
            "the override has no effect; --set sweep.scene.body.k=VALUE "
            "replaces how it varies");
}

TEST(SweepOverrides, ErrorsNameTheOverride) {
  EXPECT_EQ(sweep_errors({"scene.body.k: {from: 0, to: 1, count: 9}"},
                         {"sweep.scene.body.k.count=0"}),
            "--set sweep.scene.body.k.count=0: sweep.scene.body.k.count: "
            "\"0\" is not allowed; expected an integer, from 1 to 10 million");
  EXPECT_EQ(
      sweep_errors({"scene.body.k: [0.1]"}, {"sweep.scene.finish.L=[2, -2]"}),
      "--set sweep.scene.finish.L=[2, -2]: scene.finish.L: scene 1 "
      "(scene.body.k = 0.1, scene.finish.L = -2): -2 m is not allowed: "
      "it must be > 0, for B lies to the right of A");
}

}  // namespace
}  // namespace brachisto::io
