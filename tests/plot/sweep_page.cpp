// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/sweep_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "plot/pages.hpp"
#include "plot/sweep_files.hpp"
#include "plot/tables.hpp"
#include "plot/thinning.hpp"
#include "report/sweep_tables.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using report::OutputFile;
using testing::count;
using ::testing::ElementsAre;
using testing::fail;
using testing::names;
using testing::sum;
using testing::sweep_over;
using testing::sweep_report;
using testing::xml_flaw;

SweepTable plane() {
  return sweep_over(
      {{"scene.body.eta_m", 0.0, 0.5, 11}, {"scene.body.k", 0.0, 0.5, 12}},
      sum);
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The page, which is last; all documents have to be well formed.
std::string page(const SweepTable& table) {
  const std::vector<OutputFile> files = sweep_report(table);
  for (const OutputFile& file : files) {
    if (!file.name.ends_with(".svg") && !file.name.ends_with(".html")) continue;
    EXPECT_EQ(xml_flaw(file.content), "") << file.name;
  }
  EXPECT_EQ(files.back().name, "index.html");
  return files.back().content;
}

TEST(SweepReport, OfTwoAxesIsAMap) {
  const auto files = sweep_report(plane());

  EXPECT_THAT(names(files), ElementsAre("map-1"));
  // The figure is on the page.
  EXPECT_EQ(count(files.back().content, "<svg"), 1u);
  EXPECT_TRUE(says(files.back().content, "<title>τ over "));
}

TEST(SweepReport, NeedsNothingBesideItsPage) {
  const std::string html = page(plane());

  testing::expect_alone(html);
  EXPECT_FALSE(says(html, "<img"));
  EXPECT_TRUE(says(html, "charset=\"utf-8\""));
}

TEST(SweepReport, HasAMapOfFeasibilityIfItMatters) {
  SweepTable table = plane();
  table.outcomes[5].feasible = false;

  EXPECT_THAT(names(sweep_report(table)),
              ElementsAre("map-1", "map-1-feasibility"));
}

TEST(SweepReport, OfAnAxisOfFewValuesHasCurvesToo) {
  const SweepTable table = sweep_over(
      {{"scene.body.eta_m", 0.0, 0.5, 8}, {"scene.body.k", 0.0, 0.5, 12}}, sum);

  EXPECT_THAT(names(sweep_report(table)), ElementsAre("map-1", "map-1-curves"));
}

TEST(SweepReport, OfOneAxisIsACurve) {
  const SweepTable table = sweep_over(
      {{"scene.finish.H", 1.0, 1.0, 1}, {"scene.body.k", 0, 1, 9}}, sum);

  EXPECT_THAT(names(sweep_report(table)), ElementsAre("curve-1"));
}

TEST(SweepReport, OfMoreAxesHasAMapForEachValueAndSaysWhatIsLeftOut) {
  const SweepTable table = sweep_over({{"scene.finish.L", 1.0, 14.0, 14},
                                       {"scene.body.eta_m", 0.0, 0.5, 9},
                                       {"scene.body.k", 0.0, 0.5, 9}},
                                      sum);

  const std::string html = page(table);

  EXPECT_EQ(count(html, "<svg"), 12u);
  EXPECT_TRUE(says(html, "<h2><i>L</i> = 12 m</h2>"));
  EXPECT_TRUE(says(html, "2 more figures"));
}

TEST(SweepReport, TellsWhetherMapsHaveTheSameColours) {
  const auto over = [](double spread) {
    return sweep_over({{"scene.finish.L", 0.0, spread, 3},
                       {"scene.body.eta_m", 0.0, 0.5, 9},
                       {"scene.body.k", 0.0, 0.5, 9}},
                      sum);
  };

  EXPECT_TRUE(says(page(over(0.1)), "the same range"));
  EXPECT_TRUE(says(page(over(100.0)), "its own range"));
}

TEST(SweepReport, OfASampleHasAPlotPerColumn) {
  SweepTable table = sweep_over({{"scene.body.k", 0.0, 1.0, 30}}, sum);
  table.columns.push_back({"scene.body.shape", {}, {}});
  for (int i = 0; i < 30; ++i) {
    table.columns[1].words.emplace_back(i % 2 == 0 ? "one" : "other");
  }
  table.axes = {{{0, 1}, 30, false}};

  EXPECT_THAT(names(sweep_report(table)),
              ElementsAre("sample-1-1", "sample-1-2"));
}

TEST(SweepReport, OfASampleOfTwoNumbersHasTheirPlane) {
  SweepTable table = plane();
  table.axes = {{{0, 1}, 132, false}};

  EXPECT_THAT(names(sweep_report(table)),
              ElementsAre("sample-1", "sample-1-1", "sample-1-2"));
}

TEST(SweepReport, HasNoDigitBeyondTheError) {
  SweepTable table = sweep_over({{"scene.body.k", 0.0, 0.5, 3}},
                                [](const auto&) { return 5.115296057123; });
  for (SweepOutcome& outcome : table.outcomes) {
    outcome.estimated_error = 7.6e-5;  // × 5.1 = 3.9e-4
    outcome.transit_time = 5.115296057123;
  }
  for (const OutputFile& file : sweep_report(table)) {
    if (file.name.ends_with(".csv")) continue;
    EXPECT_FALSE(says(file.content, "5.11529")) << file.name;
  }
  EXPECT_TRUE(says(page(table), "<td>5.1153</td><td>5.1153</td><td>7.6e−5"));
}

TEST(SweepReport, WithoutGnuplotSaysSoAndHasTablesAndScripts) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", "/no/such/directory", 1);
  const report::DrawnFiles page = plot::sweep_report(plane(), {}, nullptr);
  ::setenv("PATH", before.c_str(), 1);

  ASSERT_EQ(page.files.size(), 4u);
  EXPECT_EQ(page.files[0].name, "map-1.csv");
  EXPECT_EQ(page.files[1].name, "map-1.gp");
  EXPECT_TRUE(says(page.missing, "map-1.svg is not drawn"));
  EXPECT_TRUE(says(page.files.back().content, "<p>map-1.svg is not drawn"));
  EXPECT_FALSE(says(page.files.back().content, "href=\"map-1.svg\""));
}

TEST(SweepReport, OfWordsAndNumbersHasACurvePerWord) {
  SweepTable table = sweep_over(
      {{"scene.contact", 0.0, 1.0, 2}, {"scene.body.k", 0.0, 1.0, 9}}, sum);
  table.columns[0].numbers.clear();
  for (int i = 0; i < 18; ++i) {
    table.columns[0].words.emplace_back(i < 9 ? "smooth" : "centre");
  }

  const auto files = sweep_report(table);

  ASSERT_EQ(files[2].name, "curve-1.svg");
  EXPECT_TRUE(says(files[2].content, "contact = smooth<"));
  EXPECT_TRUE(says(files[2].content, "contact = centre<"));
}

TEST(SweepReport, TellsTheExtremesAndTheCounts) {
  SweepTable table = plane();
  fail(table, 0);
  table.outcomes[1] = {};
  table.outcomes[7].estimated_error = 3e-9;
  table.outcomes[12].feasible = false;

  const std::string html = page(table);

  for (const std::string row :
       {"scenes</th><td>132<", "verified</th><td>130<",
        "of them feasible</th><td>129<", "failed</th><td>1<",
        "not run yet</th><td>1<", "largest estimated error</th><td>3e−9<",
        "maximum of <i>τ</i></th><td>6.00000000000<"}) {
    EXPECT_TRUE(says(html, row)) << row;
  }
}

TEST(SweepReport, SaysAtItsTopThatScenesAreMissing) {
  SweepTable table = plane();
  EXPECT_FALSE(says(page(table), "Partial"));
  fail(table, 7);
  EXPECT_FALSE(says(page(table), "Partial"));
  for (const std::size_t scene : {3U, 5U, 99U}) table.outcomes[scene] = {};

  const std::string html = page(table);

  EXPECT_TRUE(says(html, "Partial.</strong> 3 of 132 scenes"));
  EXPECT_LT(html.find("Partial."), html.find("<table"));
}

TEST(SweepReport, ShowsDrawingsThatAreTooLargeForAPageFromTheirFiles) {
  const auto square = [](std::size_t side) {
    return sweep_over({{"scene.body.eta_m", 0.0, 0.5, side},
                       {"scene.body.k", 0.0, 0.5, side}},
                      sum);
  };

  const std::string small = page(square(100));
  EXPECT_EQ(count(small, "<svg"), 1u);
  EXPECT_FALSE(says(small, "<img"));

  const std::string large = page(square(250));
  EXPECT_EQ(count(large, "<svg"), 0u);
  EXPECT_TRUE(says(large, "<img src=\"map-1.svg\""));
  EXPECT_LT(large.size(), 100'000u);
}

TEST(SweepReport, ListsWhyScenesFailed) {
  SweepTable table = plane();
  EXPECT_FALSE(says(page(table), "Failed scenes"));
  for (std::size_t i = 0; i < 3; ++i) fail(table, i, "slope < 1 & no end");

  const std::string html = page(table);

  EXPECT_TRUE(says(html, "3 of 132 scenes"));
  EXPECT_EQ(count(html, "slope &lt; 1 &amp; no end"), 3u);
  EXPECT_EQ(count(html, "<td>max_iterations</td>"), 6u);  // also in the table
}

TEST(SweepReport, ListsNoMoreFailuresThanCanBeRead) {
  SweepTable table = sweep_over({{"scene.body.k", 0.0, 1.0, 250}}, sum);
  for (std::size_t i = 0; i < 250; ++i) fail(table, i, "the cause");

  const std::string html = page(table);

  EXPECT_EQ(count(html, "<td class=\"words\">the cause"), 200u);
  EXPECT_TRUE(says(html, "50 more"));
}

TEST(SweepReport, HasATableOfAllScenesUnlessItIsTooLong) {
  const std::string few = page(plane());
  const std::string many =
      page(sweep_over({{"scene.body.k", 0.0, 1.0, 3001}}, sum));

  EXPECT_EQ(count(few, "<details>"), 1u);
  EXPECT_EQ(count(few, "<td>solved</td>"), 132u);
  EXPECT_EQ(count(many, "<details>"), 0u);
  EXPECT_TRUE(says(many, "scenes.csv"));
}

TEST(SweepReport, ShowsAnglesInDegreesAndSymbolsOfThePaper) {
  const SweepTable table =
      sweep_over({{"scene.body.eta_m", 0.0, 0.5, 11},
                  {"scene.body.theta_m", -90 * testing::kDegree, 0.0, 10}},
                 sum);

  const std::string html = page(table);

  EXPECT_TRUE(says(html, "<i>θ</i><sub>m</sub>\u00A0[°]"));
  EXPECT_TRUE(says(html, "−90° to 0°"));
  EXPECT_TRUE(says(html, "<sub>m</sub> = −90°"));
}

TEST(SweepReport, EscapesWhatComesFromElsewhere) {
  SweepTable table = plane();
  table.title = "k < 1 & <b>bold</b>";
  table.columns[0].key = "scene.\"x\"<y>&z";
  fail(table, 3, std::string("bell \a and <script>"));

  const std::string html = page(table);

  EXPECT_TRUE(says(html, "<title>k &lt; 1 &amp; &lt;b&gt;"));
  EXPECT_FALSE(says(html, "and <script>"));
  EXPECT_FALSE(says(html, "\a"));
}

TEST(SweepReport, OfNothingSaysSo) {
  const auto files = sweep_report({});

  EXPECT_THAT(names(files), ElementsAre());
  EXPECT_TRUE(says(page({}), "no scenes"));
  EXPECT_EQ(count(files[0].content, "\n"), 1u);
}

TEST(SweepReport, OfOneSceneIsATable) {
  SweepTable table =
      sweep_over({{"scene.finish.L", 3.0, 3.0, 1}, {"scene.body.k", 1, 1, 1}},
                 [](const std::vector<double>&) { return 4.510563136747; });

  EXPECT_THAT(names(sweep_report(table)), ElementsAre());
  EXPECT_TRUE(says(page(table), "4.51056313675<"));
}

TEST(SweepReport, OfFailuresOnlyIsStillAPage) {
  for (SweepTable table :
       {plane(), sweep_over({{"scene.body.k", 0.0, 1.0, 9}}, sum),
        sweep_over({{"scene.body.k", 0.0, 1.0, 1}}, sum)}) {
    for (std::size_t i = 0; i < table.outcomes.size(); ++i) fail(table, i);

    EXPECT_TRUE(says(page(table), "verified</th><td>0<"));
  }
}

TEST(SweepReport, OfWhatDoesNotFitIsAnError) {
  SweepTable table = plane();
  table.columns[1].numbers.pop_back();
  EXPECT_THROW((void)sweep_report(table), std::invalid_argument);

  table = plane();
  table.outcomes.pop_back();
  EXPECT_THROW((void)sweep_report(table), std::invalid_argument);

  table = plane();
  table.axes[0].columns = {2};
  EXPECT_THROW((void)sweep_report(table), std::invalid_argument);

  table = plane();
  table.outcomes[0].tau = SweepOutcome::kNone;
  EXPECT_THROW((void)sweep_report(table), std::invalid_argument);
}

/// The cells of a picture.
const nlohmann::ordered_json& cells_of(const nlohmann::ordered_json& data,
                                       const std::string& name) {
  return *std::ranges::find_if(data["figures"], [&](const auto& figure) {
    return figure["name"] == name;
  });
}

/// Where gnuplot drew marks of a kind, from left to right.
std::map<double, double> marks(const std::string& svg,
                               const std::string& kind) {
  std::map<double, double> found;
  const std::regex mark("#" + kind +
                        "' transform='translate\\(([0-9.]+),([0-9.]+)\\)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), mark), end; it != end;
       ++it) {
    found[std::stod((*it)[1])] = std::stod((*it)[2]);
  }
  return found;
}

TEST(SweepCells, AreOneForEachSceneOfAPicture) {
  const auto data = testing::data_of(page(plane()));

  const auto cells = cells_of(data, "map-1");
  std::vector<std::size_t> scenes = cells["scenes"];
  std::ranges::sort(scenes);
  ASSERT_EQ(scenes.size(), 132u);
  EXPECT_EQ(std::ranges::adjacent_find(scenes), scenes.end());
  EXPECT_EQ(scenes.back(), 131u);
  EXPECT_EQ(cells["x"].size(), 132u);
  EXPECT_EQ(cells["y"].size(), 132u);
  EXPECT_EQ(cells["row"], 12);
  EXPECT_EQ(cells["meet"], true);
}

/// Whether the cells lie where gnuplot draws the marks of those that failed,
/// here one in each row, to its hundredth of a pixel and our tenth.
void expect_cells_under_crosses(SweepTable table, const std::string& name) {
  for (std::size_t i = 0; i < 11; ++i) fail(table, 12 * i + i);
  const auto files = sweep_report(table);
  const auto svg = std::ranges::find(files, name + ".svg", &OutputFile::name);
  const auto crosses = marks(svg->content, "gpPt1");
  const auto data = testing::data_of(files.back().content);
  const auto cells = cells_of(data, name);
  ASSERT_GE(crosses.size(), 11u);
  for (std::size_t i = 0; i < cells["scenes"].size(); ++i) {
    if (cells["scenes"][i] !=
        12 * (cells["scenes"][i].get<std::size_t>() / 13) +
            cells["scenes"][i].get<std::size_t>() / 13) {
      continue;
    }
    const double x = cells["x"][i], y = cells["y"][i];
    const bool there = std::ranges::any_of(crosses, [&](const auto& cross) {
      return std::hypot(cross.first - x, cross.second - y) < 0.1;
    });
    EXPECT_TRUE(there) << name << ": " << x << ", " << y;
  }
}

TEST(SweepCells, LieWhereGnuplotDrawsTheirScenes) {
  expect_cells_under_crosses(plane(), "map-1");
  // On an axis of logarithms too.
  expect_cells_under_crosses(
      testing::list_over(
          {{"scene.body.eta_m",
            {.1, .11, .12, .15, .2, .3, .5, .7, 1., 3., 10.}},
           {"scene.body.k", {0., .1, .2, .3, .4, .5, .6, .7, .8, .9, 1., 1.1}}},
          sum),
      "map-1");
}

TEST(SweepCells, OfACurveAreItsPoints) {
  SweepTable table = sweep_over({{"scene.body.k", 0.0, 1.0, 9}}, sum);
  fail(table, 4);

  const auto files = sweep_report(table);
  const auto data = testing::data_of(files.back().content);

  const auto cells = cells_of(data, "curve-1");
  EXPECT_EQ(cells["row"], 9);
  EXPECT_EQ(cells["meet"], false);
  ASSERT_EQ(files[2].name, "curve-1.svg");
  const auto crosses = marks(files[2].content, "gpPt1");
  const bool there = std::ranges::any_of(crosses, [&](const auto& cross) {
    return std::hypot(cross.first - cells["x"][4].get<double>(),
                      cross.second - cells["y"][4].get<double>()) < 0.1;
  });
  EXPECT_TRUE(there);
}

TEST(SweepCells, TellWhatTheTableOfAllScenesHas) {
  SweepTable table = plane();
  table.outcomes[5].feasible = false;
  const auto files = sweep_report(table);
  const std::string& csv = files[files.size() - 2].content;
  const std::string& html = files.back().content;
  const std::string rows = html.substr(html.find("<table id=\"scenes\""));
  const std::regex row(
      "<tr><td>([0-9]+)</td><td>[^<]*</td><td>[^<]*</td><td>([0-9.]+)</td>"
      "<td>[^<]*</td><td>[^<]*</td><td>(yes|no)</td><td>solved</td></tr>");
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::sregex_iterator it(rows.begin(), rows.end(), row);
  for (std::size_t scene = 0; scene < 132; ++scene, ++it) {
    ASSERT_TRUE(std::getline(lines, line));
    ASSERT_NE(it, std::sregex_iterator());
    std::vector<std::string> fields;
    std::istringstream cells(line);
    for (std::string field; std::getline(cells, field, ',');) {
      fields.push_back(field);
    }
    EXPECT_EQ((*it)[1], fields[0]);
    // Rounded to the digits that the error, 1e-11 of τ, leaves.
    EXPECT_NEAR(std::stod((*it)[2]), std::stod(fields[6]),
                1e-11 * std::stod(fields[6]));
    EXPECT_EQ((*it)[3] == "yes", fields[5] == "true");
  }
}

TEST(SweepCells, SayWhatIsNotAsItShouldBe) {
  SweepTable table = plane();
  table.outcomes[5].feasible = false;
  table.outcomes[5].infeasible_because = {"the track folds"};
  table.outcomes[6].folds = {0.25};
  fail(table, 7, "it <stalls>");
  table.outcomes[8] = {};

  const auto data = testing::data_of(page(table));

  EXPECT_EQ(data["infeasible"], nlohmann::ordered_json({5}));
  EXPECT_EQ(data["folded"], nlohmann::ordered_json({6}));
  EXPECT_EQ(data["unsolved"], nlohmann::ordered_json({7}));
  EXPECT_EQ(data["missing"], nlohmann::ordered_json({8}));
  EXPECT_EQ(data["remarks"]["5"], "Infeasible: the track folds");
  EXPECT_EQ(data["remarks"]["6"],
            "Its branch from the cycloid turned at η_m = 0.25.");
  EXPECT_EQ(data["remarks"]["7"], "it <stalls>");
  EXPECT_EQ(data["remarks"].size(), 3u);
}

TEST(SweepTracks, AreOnThePageOnlyIfTheyWereKept) {
  const testing::Incline incline;
  const auto motion = plot::TrajectoryTable::read(incline.csv(60));
  std::vector<plot::SweepTrack> tracks;
  for (const std::size_t scene : {3u, 17u}) {
    tracks.push_back({scene, incline.scene(),
                      plot::kept_track(motion, incline.scene().body)});
  }
  tracks.push_back({20, incline.scene(), {{"rows", "none"}}});

  const std::string with =
      plot::sweep_report(plane(), tracks, nullptr).files.back().content;
  const std::string without = page(plane());

  EXPECT_EQ(xml_flaw(with), "");
  testing::expect_alone(with);
  const auto data = testing::data_of(with);
  EXPECT_EQ(data["tracks"].size(), 2u);
  EXPECT_EQ(data["tracks"]["17"]["rows"], tracks[1].kept["rows"]);
  EXPECT_EQ(data["tracks"]["17"]["body"]["radius"], incline.radius);
  EXPECT_TRUE(says(with, "id=\"stage\""));
  EXPECT_FALSE(says(without, "id=\"stage\""));
  EXPECT_TRUE(testing::data_of(without)["tracks"].empty());
}

TEST(SweepCells, AreNotOnAPageThatDoesNotListItsScenes) {
  const std::string html =
      page(sweep_over({{"scene.body.k", 0.0, 1.0, 3001}}, sum));

  EXPECT_FALSE(says(html, "<script"));
  EXPECT_FALSE(says(html, "arrow keys"));
}

}  // namespace
}  // namespace brachisto
