// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Pages of comparisons, from measurements that were made up.

#include "comparison/pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "comparison/finding.hpp"
#include "plot/pages.hpp"
#include "report/xml.hpp"

namespace brachisto::comparison {
namespace {

using testing::expect_alone;
using testing::has;
using testing::xml_flaw;
using Kind = ComparedMethod::Kind;
using Outcome = Measurement::Outcome;

const std::string kReason = "R < 0 & no \"progress\": 1e-3 is left";

Subject bead() {
  Subject subject;
  subject.problem.scene.body = Body::bead();
  subject.problem.scene.L = 3.0;
  subject.problem.scene.H = 1.0;
  return subject;
}

Measurement with_start(double seconds) {
  Measurement run;
  run.outcome = Outcome::Solved;
  run.cpu = {seconds};
  run.start = {0.25 * seconds};
  return run;
}

Measurement failed(Outcome outcome) {
  Measurement run;
  run.outcome = outcome;
  run.cause = kReason;
  run.cpu = {0.1};
  return run;
}

std::string content(const report::DrawnFiles& made, const std::string& name) {
  const auto found =
      std::ranges::find(made.files, name, &report::OutputFile::name);
  return found == made.files.end() ? "" : found->content;
}

WorkPrecision work_precision() {
  WorkPrecision found{
      bead(), {}, {.tau = 4.5, .error = 1e-14, .by = "a judge"}};
  PrecisionLine line{rolling_time(1), {}};
  for (const int mesh : {10, 20, 40, 80}) {
    line.points.push_back(
        {{.mesh = mesh}, with_start(1e-4 * mesh), 3e-5 / (mesh * mesh), {}});
  }
  found.lines.push_back(line);
  PrecisionLine none{discrete_system(DiscreteArm::Rest), {}};
  for (const int mesh : {10, 20}) {
    none.points.push_back({{.mesh = mesh}, failed(Outcome::Failed), {}, {}});
  }
  none.order.why_not = "too few meshes";
  found.lines.push_back(none);
  found.left_out.push_back({{.kind = Kind::ArcLength}, "it takes no air"});
  return found;
}

TEST(ComparisonPage, OfWorkAndPrecisionIsWholeAndAlone) {
  const WorkPrecision found = work_precision();

  const report::DrawnFiles made = files_of(found, nullptr);

  ASSERT_EQ(made.files.back().name, "index.html") << "written last";
  const std::string& page = made.files.back().content;
  EXPECT_EQ(xml_flaw(page), "");
  expect_alone(page);
  const std::vector<std::string> names = work_precision_file_names();
  for (const report::OutputFile& file : made.files) {
    EXPECT_TRUE(std::ranges::find(names, file.name) != names.end())
        << file.name;
  }
}

TEST(ComparisonPage, HasTheSentenceThenThePictureThenFoldedTables) {
  const WorkPrecision found = work_precision();

  const std::string page = content(files_of(found, nullptr), "index.html");

  const std::size_t sentence =
      page.find("<h1>" + in_a_sentence(parties_of(found)) + "</h1>");
  ASSERT_NE(sentence, std::string::npos) << page.substr(0, 6000);
  const std::size_t picture = page.find("<figure>");
  const std::size_t table = page.find("<table");
  EXPECT_LT(sentence, picture);
  EXPECT_LT(picture, table);
  for (std::size_t at = table; at != std::string::npos;
       at = page.find("<table", at + 1)) {
    const std::size_t open = page.rfind("<details>", at);
    ASSERT_NE(open, std::string::npos);
    EXPECT_GT(page.find("</details>", open), at) << "folded";
  }
}

TEST(ComparisonPage, TellsWhatHasNoResultInWords) {
  const std::string page =
      content(files_of(work_precision(), nullptr), "index.html");

  EXPECT_TRUE(has(page, "<li>arc_length: it takes no air</li>"));
  // Once for both meshes.
  EXPECT_TRUE(has(page,
                  "<li>fsolve rest on 10, 20: R &lt; 0 &amp; no "
                  "&quot;progress&quot;: 1e-3 is left</li>"))
      << page.substr(page.find("<ul"), 500);
  EXPECT_TRUE(has(page, "too few meshes"));
}

TEST(ComparisonPage, HasTheTimeOnTheMeshApart) {
  const report::DrawnFiles made = files_of(work_precision(), nullptr);

  // Three quarters of 1 ms on the first mesh.
  EXPECT_TRUE(has(content(made, "work_precision_mesh.csv"), ",0.00075\n"))
      << content(made, "work_precision_mesh.csv");
  EXPECT_TRUE(has(content(made, "work_precision.csv"), ",0.001\n"));
}

MethodComparison comparison() {
  MethodComparison made{bead(), {}, Reference{.tau = 4.5, .error = 1e-14}, {}};
  made.rows = {
      {"rolling_time", {.kind = Kind::Adaptive}, with_start(0.004), 1e-11},
      {"rolling_time p = 5", rolling_time(5), with_start(0.004), 1.1e-11},
      {"fsolve rest", discrete_system(DiscreteArm::Rest), with_start(0.2),
       1e-3},
      {"arc_length", {.kind = Kind::ArcLength}, failed(Outcome::Refused)}};
  return made;
}

TEST(ComparisonPage, OfMethodsHasANameAtEachMark) {
  const report::DrawnFiles made = files_of(comparison(), nullptr);

  const std::string page = content(made, "index.html");
  EXPECT_EQ(xml_flaw(page), "");
  expect_alone(page);
  EXPECT_TRUE(has(page,
                  "<h1>To an error of 1e−6 the program needs 4 ms; fsolve does "
                  "not reach it (at best 1e−3); arc_length does not take such "
                  "a scene.</h1>"))
      << page.substr(page.find("<h1>"), 300);
  const std::string script = content(made, "compare.gp");
  for (const char* label : {"rolling", "fsolve rest"}) {
    EXPECT_TRUE(has(script, label)) << label;
  }
  EXPECT_TRUE(has(page, "<li>arc_length: R &lt; 0"));
  const std::vector<std::string> names = comparison_file_names();
  for (const report::OutputFile& file : made.files) {
    EXPECT_TRUE(std::ranges::find(names, file.name) != names.end())
        << file.name;
  }
}

TEST(ComparisonPage, WithoutAReferenceHasNoPicture) {
  MethodComparison made = comparison();
  made.reference.reset();
  for (ComparisonRow& row : made.rows) row.error.reset();

  const report::DrawnFiles files = files_of(made, nullptr);

  EXPECT_EQ(xml_flaw(content(files, "index.html")), "");
  EXPECT_FALSE(has(content(files, "index.html"), "<figure>"));
}

}  // namespace
}  // namespace brachisto::comparison
