// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto paper, once and in full.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/command.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string content(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// One run for all tests.
class PaperCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new testing::ScratchDirectory();
    out_ = scratch_->path() / "paper";
    testing::Process run({"paper", "--out", out_.string(), "--json"});
    const auto output = run.wait(std::chrono::seconds(500));
    ASSERT_TRUE(output.has_value());
    ASSERT_EQ(output->code, 0) << output->err;
    document_ = Json::parse(output->out);
  }
  static void TearDownTestSuite() {
    delete scratch_;
    scratch_ = nullptr;
  }
  static const Json& comparison(const std::string& quantity) {
    for (const Json& row : document_["comparisons"]) {
      if (row["quantity"] == quantity) return row;
    }
    throw std::runtime_error("no comparison of " + quantity);
  }

  static inline testing::ScratchDirectory* scratch_ = nullptr;
  static inline fs::path out_;
  static inline Json document_;
};

TEST_F(PaperCommand, AgreesWithValuesComputedElsewhere) {
  // Indirect method and closed forms, twelve digits.
  EXPECT_NEAR(comparison("τ, off-centred cylinder, L = 3")["ours"],
              5.093444466618, 1e-9);
  EXPECT_NEAR(comparison("τ, off-centred cylinder, L = 2")["ours"],
              3.904264219696, 1e-9);
  EXPECT_NEAR(comparison("τ, bead, L = 3")["ours"], 4.510563136746752, 1e-9);
  EXPECT_NEAR(comparison("length of the track, uniform cylinder")["ours"],
              3.664719129859678, 1e-7);
}

TEST_F(PaperCommand, EveryErrorBarIsSmall) {
  for (const Json& row : document_["comparisons"]) {
    EXPECT_GE(row["error"], 0.0) << row;
    EXPECT_LT(row["error"], 1e-3) << row;
  }
}

TEST_F(PaperCommand, TheFastestOrientationsAreKnownToSixDigits) {
  ASSERT_GE(document_["fastest_orientations"].size(), 10U);
  for (const Json& row : document_["fastest_orientations"]) {
    EXPECT_LT(row["error"], 1e-6) << row;
  }
}

TEST_F(PaperCommand, EveryFigureHasThreeFiles) {
  std::size_t figures = 0;
  for (const auto& entry : fs::directory_iterator(out_)) {
    if (entry.path().extension() != ".svg") continue;
    ++figures;
    const std::string stem = entry.path().stem().string();
    EXPECT_EQ(testing::xml_flaw(content(entry.path())), "") << stem;
    EXPECT_TRUE(fs::exists(out_ / (stem + ".csv"))) << stem;
    EXPECT_TRUE(fs::exists(out_ / (stem + ".gp"))) << stem;
  }
  EXPECT_GE(figures, 18U);
}

TEST_F(PaperCommand, ThePageNeedsNothingBesideIt) {
  const std::string page = content(out_ / "index.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  for (const char* outside : {"src=", "<link", "@import", "url(http"}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
}

TEST_F(PaperCommand, RefusesToReplaceWhatIsThere) {
  testing::Process again({"paper", "--out", out_.string()});
  const auto output = again.wait(std::chrono::seconds(20));
  ASSERT_TRUE(output.has_value());
  EXPECT_EQ(output->code, 6);
}

}  // namespace
}  // namespace brachisto
