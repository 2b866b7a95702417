// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Sweeps: which scenes a file means.

#include "brachisto/io/problem_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>

#include "io/reading.hpp"
#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> paths(const SweepFile& file) {
  std::vector<std::string> all;
  for (const SweepKey& key : file.keys()) all.push_back(key.path);
  return all;
}

TEST(SweepFile, IsAProductWhoseLastKeyIsTheFastest) {
  const SweepFile file =
      sweep({"scene.finish.L: [2, 3]", "scene.body.eta_m: [0, 0.1, 0.2]"});

  EXPECT_EQ(file.num_scenes(), 6u);
  EXPECT_THAT(paths(file), ElementsAre("scene.finish.L", "scene.body.eta_m"));
  EXPECT_THAT(numbers(file, 0), ElementsAre(2, 2, 2, 3, 3, 3));
  EXPECT_THAT(numbers(file, 1), ElementsAre(0, 0.1, 0.2, 0, 0.1, 0.2));
  ASSERT_EQ(file.axes().size(), 2u);
  EXPECT_THAT(file.axes()[0].keys, ElementsAre(0u));
  EXPECT_EQ(file.axes()[0].count, 2u);
  EXPECT_TRUE(file.axes()[0].ordered);
  EXPECT_THAT(file.axes()[1].keys, ElementsAre(1u));
  EXPECT_EQ(file.axes()[1].count, 3u);
}

TEST(SweepFile, ScenesHaveExactlyTheValuesThatAreTold) {
  const SweepFile file =
      sweep({"scene.body.eta_m: {from: 0, to: sqrt(1-k), count: 41}",
             "scene.body.theta_m: {from: -90 deg, to: 90 deg, count: 61}"});

  ASSERT_EQ(file.num_scenes(), 2501u);
  for (std::size_t i = 0; i < file.num_scenes(); ++i) {
    const Scene scene = file.problem(i).scene;
    EXPECT_EQ(scene.body.eta_m, number(file, i, 0));
    EXPECT_EQ(scene.body.theta_m, number(file, i, 1));
    EXPECT_EQ(scene.body.k, 0.5);
    EXPECT_TRUE(validate(scene).empty());
  }
  EXPECT_EQ(number(file, 2500, 0), std::sqrt(0.5));
  EXPECT_EQ(number(file, 0, 1), -std::numbers::pi / 2);
  EXPECT_EQ(number(file, 30, 1), 0.0);
  EXPECT_EQ(number(file, 2500, 1), std::numbers::pi / 2);
}

TEST(SweepFile, ASceneIsTheFileWithItsValuesInPlaceOfItsOwn) {
  const SweepFile file =
      sweep({"scene.finish.H: [1.5, 1/3]", "solver.seed: [4, 5]",
             "solver.guess: [straight, random]"});

  const ProblemFile swept = file.problem(5);
  const ProblemFile single =
      read(kCylinder,
           {"scene.finish.H=1/3", "solver.seed=4", "solver.guess=random"});
  EXPECT_EQ(swept.scene.H, single.scene.H);
  EXPECT_EQ(swept.scene.L, single.scene.L);
  EXPECT_EQ(swept.options.of<Collocation>()->seed,
            single.options.of<Collocation>()->seed);
  EXPECT_EQ(swept.options.of<Collocation>()->guess,
            single.options.of<Collocation>()->guess);
}

TEST(SweepFile, WordsVaryToo) {
  const SweepFile file = sweep({"solver.method: [ipopt, extremal]"});

  EXPECT_FALSE(file.keys()[0].numeric);
  EXPECT_EQ(std::get<std::string>(file.values(1)[0]), "extremal");
  EXPECT_TRUE(file.problem(0).options.of<Collocation>());
  EXPECT_TRUE(file.problem(1).options.of<Shooting>());
}

TEST(SweepFile, KeysThatVaryNeedNoValueOfTheirOwn) {
  const SweepFile file = read_sweep_text(
      "scene: {body: {shape: bead}}\n"
      "sweep: {scene.finish.L: [1, 2], scene.finish.H: [3]}\n",
      "p.yaml");

  EXPECT_EQ(file.num_scenes(), 2u);
  EXPECT_EQ(file.problem(1).scene.L, 2.0);
  EXPECT_EQ(file.problem(1).scene.H, 3.0);
}

TEST(SweepFile, ValuesThatAreReplacedNeedNotBeGood) {
  const SweepFile file = read_sweep_text(
      "scene: {body: {shape: bead}, finish: {L: -3, H: what}}\n"
      "sweep: {scene.finish.L: [1, 2], scene.finish.H: [3]}\n",
      "p.yaml");

  EXPECT_EQ(file.problem(0).scene.L, 1.0);
}

TEST(SweepFile, KeysInZipRunTogetherAtThePlaceOfTheFirst) {
  const SweepFile file = sweep(
      {"scene.finish.L: [2, 3]", "scene.body.k: [0.1, 0.2, 0.3]",
       "scene.finish.H: [1, 2]", "zip: [scene.finish.H, scene.finish.L]"});

  EXPECT_EQ(file.num_scenes(), 6u);
  EXPECT_THAT(numbers(file, 0), ElementsAre(2, 2, 2, 3, 3, 3));
  EXPECT_THAT(numbers(file, 1), ElementsAre(0.1, 0.2, 0.3, 0.1, 0.2, 0.3));
  EXPECT_THAT(numbers(file, 2), ElementsAre(1, 1, 1, 2, 2, 2));
  ASSERT_EQ(file.axes().size(), 2u);
  EXPECT_THAT(file.axes()[0].keys, ElementsAre(0u, 2u));
  EXPECT_THAT(file.axes()[1].keys, ElementsAre(1u));
}

TEST(SweepFile, SeveralGroupsRunTogetherEachByItself) {
  const SweepFile file =
      sweep({"zip: [[scene.finish.L, scene.finish.H], [scene.body.k, "
             "solver.guess]]",
             "scene.finish.L: [2, 3]",
             "scene.finish.H: {from: 1, to: 2, "
             "count: 2}",
             "scene.body.k: [0.1, 0.2]", "solver.guess: [cycloid, straight]"});

  EXPECT_EQ(file.num_scenes(), 4u);
  EXPECT_THAT(numbers(file, 1), ElementsAre(1, 1, 2, 2));
  EXPECT_THAT(numbers(file, 2), ElementsAre(0.1, 0.2, 0.1, 0.2));
  EXPECT_EQ(std::get<std::string>(file.values(3)[3]), "straight");
}

TEST(SweepFile, SingleValuesDoNotMultiplyTheScenes) {
  const SweepFile file =
      sweep({"scene.body.eta_m: [0, 0.5]", "scene.body.k: 1 - eta_m^2",
             "solver.guess: straight"});

  EXPECT_EQ(file.num_scenes(), 2u);
  EXPECT_EQ(file.axes().size(), 1u);
  EXPECT_EQ(file.keys().size(), 3u);
  EXPECT_THAT(numbers(file, 1), ElementsAre(1, 0.75));
  EXPECT_EQ(file.problem(1).scene.body.k, 0.75);
  EXPECT_EQ(file.problem(1).options.of<Collocation>()->guess, Guess::Straight);
}

TEST(SweepFile, WithoutAnAxisThereIsOneScene) {
  EXPECT_EQ(sweep({"scene.body.k: 0.3"}).num_scenes(), 1u);
}

TEST(SweepFile, WarmStartIsOnUnlessTurnedOff) {
  EXPECT_FALSE(sweep({"scene.body.k: [0.3]"}).warm_start());
  EXPECT_TRUE(sweep({"scene.body.k: [0.3]", "warm_start: true"}).warm_start());
  EXPECT_FALSE(
      sweep({"scene.body.k: [0.3]", "warm_start: false"}).warm_start());
}

TEST(SweepFile, KeepsTracksIfAskedTo) {
  EXPECT_FALSE(sweep({"scene.body.k: [0.3]"}).keeps_tracks());
  EXPECT_FALSE(sweep({"scene.body.k: [0.3]", "keep: nothing"}).keeps_tracks());
  EXPECT_TRUE(sweep({"scene.body.k: [0.3]", "keep: tracks"}).keeps_tracks());
}

TEST(SweepFile, ScenesBeyondTheLastAreOutOfRange) {
  const SweepFile file = sweep({"scene.body.k: [0.1, 0.2]"});

  EXPECT_THROW(static_cast<void>(file.problem(2)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(file.values(2)), std::out_of_range);
}

TEST(SweepFile, IsReadFromDisk) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / "sweep_file_test.yaml";
  std::ofstream(path) << kCylinder << section({"scene.body.k: [0.1, 0.2]"});

  EXPECT_EQ(read_sweep_file(path).num_scenes(), 2u);
  EXPECT_TRUE(
      std::holds_alternative<SweepFile>(read_problem_or_sweep_file(path)));
  std::ofstream(path) << kCylinder;
  EXPECT_TRUE(
      std::holds_alternative<ProblemFile>(read_problem_or_sweep_file(path)));
  EXPECT_TRUE(std::holds_alternative<SweepFile>(
      read_problem_or_sweep_file(path, {"sweep={scene.body.k: [0.1]}"})));
  std::filesystem::remove(path);
  EXPECT_THROW(static_cast<void>(read_sweep_file(path)), IoError);
  EXPECT_THROW(static_cast<void>(read_problem_or_sweep_file(path)), IoError);
}

TEST(SweepFile, TheProblemFilesOfSweepsAreGood) {
  const std::filesystem::path folder = BRACHISTO_SOURCE_DIR "/problems/sweeps";

  EXPECT_EQ(read_sweep_file(folder / "small.yaml").num_scenes(), 35u);
  const SweepFile map = read_sweep_file(folder / "map_eta_theta.yaml");
  EXPECT_EQ(map.num_scenes(), 2501u);
  EXPECT_EQ(map.problem(2500).scene.body.eta_m, std::sqrt(0.5));
  EXPECT_EQ(
      map.problem(2500).options.of<Collocation>()->discretisation.tolerance,
      1e-10);
}

}  // namespace
}  // namespace brachisto::io
