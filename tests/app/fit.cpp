// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto fit: what it writes, and what it refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/shell.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::content;
using ::testing::HasSubstr;
using testing::Output;
using testing::run;
using testing::ScratchDirectory;

constexpr const char* kRolling = "scene.losses.rolling";
const std::string kFitFolder = std::string(BRACHISTO_PROBLEMS_DIR) + "/fit/";

/// The marble on its arc, with further words.
Output fit_marble(const std::vector<std::string>& words,
                  const std::string& times = kFitFolder + "marble.csv") {
  std::vector<std::string> all{"fit", kFitFolder + "marble.yaml", times};
  all.insert(all.end(), words.begin(), words.end());
  return run(all);
}

/// The same to times of this text.
Output fit_to(const std::string& text, const std::vector<std::string>& words) {
  const ScratchDirectory scratch;
  const fs::path file = scratch.path() / "times.csv";
  std::ofstream(file, std::ios::binary) << text;
  return fit_marble(words, file.string());
}

TEST(Fit, WritesTheModelThatPredictsNext) {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "fitted";

  const Output done =
      fit_marble({"--parameter", kRolling, "--offset", "--out", out.string()});

  ASSERT_EQ(done.code, 0) << done.err;
  for (const char* name :
       {"fit.json", "fit.yaml", "residuals.csv", "residuals.gp"}) {
    EXPECT_TRUE(fs::exists(out / name)) << name;
  }
  const auto document = nlohmann::json::parse(content(out / "fit.json"));
  // The times were made with c = 0.03.
  const auto& found = document.at("estimates").at(0);
  EXPECT_NEAR(found.at("value").get<double>(), 0.03,
              2.0 * found.at("standard_error").get<double>());
  const Output next = run({"solve", (out / "fit.yaml").string(), "--json"});
  ASSERT_EQ(next.code, 0) << next.err;
  EXPECT_NEAR(nlohmann::json::parse(next.out).at("transit_time").get<double>(),
              document.at("transit_time").get<double>(), 1e-12);
  // Nothing is replaced unasked.
  EXPECT_EQ(fit_marble({"--parameter", kRolling, "--out", out.string()}).code,
            6);
}

TEST(Fit, HoldsTheAnswerWhereNoPathIsGiven) {
  const ScratchDirectory scratch;
  const std::string times = (scratch.path() / "times.csv").string();
  // What it takes without friction, and 3 % more.
  std::ofstream(times) << "s,t\n1,0.482\n2,0.713\n3,0.923\n3.3,0.989\n";

  const Output done = run(
      {"fit", std::string(BRACHISTO_PROBLEMS_DIR) + "/paper/fig06_bead.yaml",
       times, "--parameter", "scene.losses.sliding", "--json"});

  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(nlohmann::json::parse(done.out).at("rows"), 4);
}

TEST(Fit, RefusesWhatCannotBeFitted) {
  const Output near = fit_marble({"--parameter", "scene.losses.roling"});
  EXPECT_EQ(near.code, 2);
  EXPECT_THAT(near.err, HasSubstr("did you mean scene.losses.rolling?"));
  const Output bead = fit_marble({"--parameter", "scene.losses.sliding"});
  EXPECT_EQ(bead.code, 2);
  EXPECT_THAT(bead.err, HasSubstr("scene.losses.sliding is of a bead"));
  const Output twice =
      fit_marble({"--parameter", kRolling, "--parameter", kRolling});
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.err, HasSubstr("scene.losses.rolling is given twice"));
  const Output parts =
      fit_marble({"--parameter", "scene.body.k", "--set", "scene.body.k=null",
                  "--set", "scene.body.parts=['disc:m=1']"});
  EXPECT_EQ(parts.code, 2) << parts.err;
  EXPECT_THAT(parts.err, HasSubstr("not allowed beside parts"));
}

TEST(Fit, OfNoTimesIsAMatterOfFiles) {
  const Output done =
      run({"fit", std::string(BRACHISTO_PROBLEMS_DIR) + "/fit/marble.yaml",
           "nowhere.csv", "--parameter", kRolling});
  EXPECT_EQ(done.code, 6);
  EXPECT_THAT(done.err, HasSubstr("nowhere.csv: cannot be opened"));
}

TEST(Fit, RefusesTimesInOneLine) {
  const std::vector<std::string> words{"--parameter", kRolling};
  const Output unsorted = fit_to("s,t\n0.5,0.5\n0.7,0.4\n", words);
  EXPECT_EQ(unsorted.code, 3);
  EXPECT_THAT(unsorted.err, HasSubstr("times.csv:3:1: t = 0.4 s is not after"));
  const Output none = fit_to("s,t\n0.5,nan\n", words);
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("times.csv:2:5: t: \"nan\" is not a number"));
  const Output few = fit_to("s,t\n0.5,0.5\n", words);
  EXPECT_EQ(few.code, 4);
  EXPECT_THAT(few.err, HasSubstr("1 row cannot tell 1 number"));
}

TEST(Fit, TellsWhatTimesCannotTellApart) {
  const Output done = fit_marble(
      {"--parameter", kRolling, "--parameter", "scene.body.k", "--set",
       "scene.path.shape=straight", "--set", "scene.path.start_angle=null",
       "--set", "scene.finish.L=1.4", "--json"});

  EXPECT_EQ(done.code, 4);
  EXPECT_THAT(done.err, HasSubstr("cannot tell scene.losses.rolling and "
                                  "scene.body.k apart"));
  EXPECT_EQ(nlohmann::json::parse(done.out).at("status"), "cannot_fit");
}

}  // namespace
}  // namespace brachisto
