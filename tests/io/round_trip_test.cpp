// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the program writes of its input is input again, and the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/effective_input.hpp"
#include "io/reading.hpp"

namespace brachisto::io {
namespace {

Json echo_all(const ProblemFile& problem) {
  Json document = effective_input(problem.scene, problem.options);
  document["work_precision"] = effective_section(problem, "work_precision");
  return document;
}

/// As `validate --json` and result.json have it.
std::string as_input(const Json& problem) {
  return Json{{"schema_version", 2}, {"status", "solved"}, {"input", problem}}
      .dump(2);
}

std::vector<std::filesystem::path> problem_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           BRACHISTO_SOURCE_DIR "/problems")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  return files;
}

TEST(RoundTrip, OfEveryProblem) {
  int problems = 0, sweeps = 0;
  for (const std::filesystem::path& file : problem_files()) {
    std::variant<ProblemFile, SweepFile> content;
    try {
      content = read_problem_or_sweep_file(file);
    } catch (const InputError&) {
      continue;  // scenes that are there to be refused
    }
    if (const auto* sweep = std::get_if<SweepFile>(&content)) {
      const SweepFile again = read_sweep_text(
          as_input(Json::parse(sweep->stated())), file.string());
      ASSERT_EQ(again.num_scenes(), sweep->num_scenes()) << file;
      for (const std::size_t scene : {std::size_t{0}, again.num_scenes() - 1}) {
        EXPECT_EQ(echo_all(again.problem(scene)),
                  echo_all(sweep->problem(scene)))
            << file;
      }
      ++sweeps;
    } else {
      const Json first = echo_all(std::get<ProblemFile>(content));
      const Json second = echo_all(read(as_input(first)));
      EXPECT_EQ(second.dump(), first.dump()) << file;
      ++problems;
    }
  }
  EXPECT_GE(problems, 50);
  EXPECT_GE(sweeps, 3);
}

TEST(RoundTrip, OfEveryKindOfGivenPath) {
  for (const char* path :
       {"{shape: straight}", "{curve: track, shape: parabola}",
        "{shape: circular_arc, start_angle: 80 deg}",
        "{curve: track, shape: points, points: [[0, 0], [1, 2/3], [3, 1]]}"}) {
    const std::string text =
        "scene: {body: {shape: cylinder, radius: 1/5, k: 1/2}, "
        "finish: {L: 3, H: 1}, path: " +
        std::string(path) + "}\n";

    const Json first = echo_all(read(text));

    ASSERT_TRUE(first["scene"]["path"].is_object()) << path;
    EXPECT_EQ(echo_all(read(as_input(first))).dump(), first.dump()) << path;
  }
}

TEST(RoundTrip, OfKeysThatNoProblemHas) {
  const std::string keys =
      "solver: {guess: random, seed: 7, polish: false, search: global}\n"
      "work_precision: {methods: [{fsolve: [lifted, rest]}, extremal, "
      "{rolling_time: [2]}], meshes: [5], repetitions: 2}\n";
  const Json first = echo_all(read(kBead + keys));

  EXPECT_EQ(first["solver"]["guess"], "random");
  EXPECT_EQ(first["solver"]["polish"], false);
  EXPECT_EQ(
      first["work_precision"]["methods"].dump(),
      R"([{"fsolve":["lifted","rest"]},"extremal",{"rolling_time":[2]}])");
  EXPECT_EQ(echo_all(read(as_input(first))).dump(), first.dump());
}

TEST(RoundTrip, NullIsAbsent) {
  const std::string with_nulls =
      "scene: {body: {shape: bead, mass: null, radius: null}, "
      "finish: {L: 3, H: 1}, path: null}\n"
      "discretisation: {nodes: null, elements: 40}\nsweep: null\n";

  EXPECT_EQ(echo_all(read(with_nulls)),
            echo_all(read(kBead + "discretisation: {elements: 40}\n")));
  EXPECT_EQ(echo_all(read(kBead + "solver: {seed: 3}\n", {"solver.seed=null"})),
            echo_all(read(kBead)));
}

TEST(RoundTrip, AValueLeftOutIsNotNull) {
  EXPECT_EQ(errors(kBead + "solver: {seed: }\n"),
            "p.yaml:2:10: solver.seed: no value was read; expected an integer, "
            "≥ 0");
  EXPECT_EQ(errors("scene: {body: {shape: bead}, finish: {L: 3, H: null}}\n"),
            "p.yaml:1:30: scene.finish.H: missing; expected a number in m, > 0 "
            "(H, drop from A to B)");
}

TEST(RoundTrip, NullDoesNotHideUnknownKeys) {
  EXPECT_NE(errors(kBead + "solvr: null\n").find("unknown key"),
            std::string::npos);
}

TEST(RoundTrip, BookkeepingIsIgnoredInDocumentsOfTheProgramAlone) {
  const std::string scene =
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}";

  EXPECT_EQ(errors("schema_version: 2\nvalid: true\n" + scene), "");
  EXPECT_NE(errors("valid: true\n" + scene), "");
  EXPECT_NE(errors("schema_version: 2\nstatus: solved\n" + scene), "");
}

/// They stand for the input where sweeps are told apart.
TEST(EffectiveLines, SayOfEachProblemWhatItsDocumentSays) {
  int lines = 0;
  for (const std::filesystem::path& file : problem_files()) {
    std::variant<ProblemFile, SweepFile> content;
    try {
      content = read_problem_or_sweep_file(file);
    } catch (const InputError&) {
      continue;
    }
    const auto* problem = std::get_if<ProblemFile>(&content);
    if (problem == nullptr) continue;
    Json again;
    std::istringstream text(effective_lines(problem->scene, problem->options));
    for (std::string key, value; text >> key && std::getline(text, value);) {
      std::ranges::replace(key, '.', '/');
      again[Json::json_pointer("/" + key)] = Json::parse(value);
      ++lines;
    }
    EXPECT_EQ(again, effective_input(problem->scene, problem->options)) << file;
  }
  EXPECT_GT(lines, 1000);
}

TEST(Points, OfAListAreCheckedLikeThoseOfAFile) {
  const auto with = [](const std::string& points) {
    return errors(
        "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, contact: centre, "
        "path: {shape: points, points: " +
        points + "}}\n");
  };

  EXPECT_EQ(with("[[0, 0], [1, 0.7], [3, 1]]"), "");
  EXPECT_NE(with("[[0, 0], [1], [3, 1]]").find("a list of 1 was read"),
            std::string::npos);
  EXPECT_NE(with("[[0, 0], [0, 0], [3, 1]]").find("repeats the point"),
            std::string::npos);
  EXPECT_NE(with("x.csv").find("a single value was read"), std::string::npos);
  EXPECT_NE(with("[[0, 0], [2, 1]]").find("scene.path.points"),
            std::string::npos);
  EXPECT_NE(with("[[0, 0], [3, 1]], file: x.csv").find("given twice"),
            std::string::npos);
}

}  // namespace
}  // namespace brachisto::io
