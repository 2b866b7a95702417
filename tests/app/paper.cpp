// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto paper, once and in full.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::content;

/// One run for all tests.
class PaperCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new testing::ScratchDirectory();
    out_ = scratch_->path() / "paper";
    testing::Process run({"paper", "--out", out_.string(), "--json"});
    const auto output = run.wait(std::chrono::seconds(3000));
    ASSERT_TRUE(output.has_value());
    ASSERT_EQ(output->code, 0) << output->err;
    document_ = Json::parse(output->out);
    // For documents.paper.
    std::ofstream("paper.json") << output->out;
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

/// The cells of the rows of a Markdown table, by the first of them.
std::map<std::string, std::vector<std::string>> rows_of_validation() {
  std::map<std::string, std::vector<std::string>> rows;
  std::istringstream lines(
      content(BRACHISTO_PROBLEMS_DIR "/../docs/validation.md"));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ")) continue;
    std::vector<std::string> cells;
    std::size_t begin = 2;
    for (std::size_t end = line.find(" |", begin); end != std::string::npos;
         end = line.find(" |", begin)) {
      cells.push_back(line.substr(begin, end - begin));
      begin = std::min(end + 3, line.size());
    }
    // A bar within a cell is escaped.
    for (std::string& cell : cells) {
      for (std::size_t at = cell.find("\\|"); at != std::string::npos;
           at = cell.find("\\|", at)) {
        cell.erase(at, 1);
      }
    }
    if (!cells.empty()) rows.emplace(cells.front(), cells);
  }
  return rows;
}

TEST_F(PaperCommand, TheDocumentationHasEveryStatementAndItsVerdict) {
  const auto rows = rows_of_validation();
  ASSERT_GE(document_["claims"].size(), 25U);
  for (const Json& claim : document_["claims"]) {
    const auto row = rows.find(claim["statement"]);
    ASSERT_NE(row, rows.end()) << claim["statement"];
    ASSERT_GE(row->second.size(), 3U) << claim["statement"];
    EXPECT_EQ(row->second[1], claim["verdict"].get<std::string>())
        << claim["statement"];
  }
}

TEST_F(PaperCommand, TheDocumentationHasEveryNumberToTheDigitsItPrints) {
  const auto rows = rows_of_validation();
  for (const Json& number : document_["comparisons"]) {
    const auto row = rows.find(number["quantity"]);
    ASSERT_NE(row, rows.end()) << number["quantity"];
    ASSERT_GE(row->second.size(), 3U) << number["quantity"];
    std::string text = row->second[2];
    const std::string minus = "−";
    if (text.starts_with(minus)) text.replace(0, minus.size(), "-");
    const std::string digits = text.substr(0, text.find(' '));
    const auto decimals =
        static_cast<int>(digits.size() - digits.find('.') - 1);
    // Half a unit of the last digit, and what this run may be off.
    EXPECT_NEAR(std::stod(digits), number["ours"],
                0.5 * std::pow(10.0, -decimals) + 3.0 * double(number["error"]))
        << number["quantity"];
  }
}

TEST_F(PaperCommand, EveryHeadingHasTheNumberOfItsFigure) {
  const std::string page = content(out_ / "index.html");
  std::set<std::string> captions;
  std::size_t figures = 0;
  for (std::size_t at = page.find("<figure>"); at != std::string::npos;
       at = page.find("<figure>", at + 1)) {
    // Its heading stands before it.
    const std::size_t above = page.rfind("<h3>", at);
    const std::string figure =
        page.substr(above, page.find("</figure>", at) - above);
    const auto between = [&](const std::string& before,
                             const std::string& after) {
      const std::size_t begin = figure.find(before) + before.size();
      return figure.substr(begin, figure.find(after, begin) - begin);
    };
    const std::string heading = between("<h3>", "</h3>");
    const std::string file =
        between("<span class=\"files\"><a href=\"", ".svg\"");
    const std::string caption = between("<figcaption>", "<span class=");
    ++figures;
    EXPECT_TRUE(captions.insert(caption).second) << heading << ": " << caption;
    if (!file.starts_with("fig")) continue;
    const int number = std::stoi(file.substr(3, 2));
    EXPECT_TRUE(heading.starts_with("Fig. " + std::to_string(number)))
        << file << ": " << heading;
  }
  EXPECT_GE(figures, 18U);
}

TEST_F(PaperCommand, TheBestOrientationsOfTheBoundaryAreKnownToSixDigits) {
  const Json& bodies = document_["as_fast_as_the_bead"]["fastest_theta_m"];
  ASSERT_GE(bodies.size(), 20U);
  EXPECT_TRUE(bodies[0]["theta_m"].is_null());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    EXPECT_LT(bodies[i]["theta_m_error"], 1e-6) << bodies[i];
  }
  EXPECT_NEAR(bodies.back()["theta_m"], -0.3271563, 1e-6);
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
  const auto output = again.wait();
  ASSERT_TRUE(output.has_value());
  EXPECT_EQ(output->code, 6);
}

}  // namespace
}  // namespace brachisto
