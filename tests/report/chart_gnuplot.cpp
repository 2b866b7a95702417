// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "report/chart.hpp"
#include "report/charts.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::chart_of_everything;
using brachisto::testing::sampled;

/// Runs the script of a chart beside its file; what it complained about.
std::string complaints(const Chart& chart) {
  const brachisto::testing::ScratchDirectory directory;
  const std::filesystem::path& at = directory.path();
  std::ofstream(at / (chart.name + ".csv")) << chart_csv(chart);
  std::ofstream(at / (chart.name + ".gp")) << chart_gnuplot(chart);
  const std::string command =
      "cd '" + at.string() + "' && gnuplot " + chart.name + ".gp > said 2>&1";
  const bool failed = std::system(command.c_str()) != 0;
  std::ifstream in(at / "said");
  std::string said{std::istreambuf_iterator<char>(in), {}};
  if (failed) said += "exit code not 0";
  std::error_code none;
  const auto size =
      std::filesystem::file_size(at / (chart.name + ".pdf"), none);
  if (none || size < 1000) said += "no drawing";
  return said;
}

class ChartGnuplot : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "gnuplot is not installed";
    }
  }
};

TEST_F(ChartGnuplot, DrawsEverythingWithoutAWarning) {
  EXPECT_EQ(complaints(chart_of_everything()), "");
}

TEST_F(ChartGnuplot, DrawsLogarithmicAxes) {
  Chart chart;
  chart.name = "order";
  chart.x.scale = chart.y.scale = Scale::Logarithmic;
  chart.curves = {sampled("N^{−4}", 10.0, 1e3, 50,
                          [](double n) { return std::pow(n, -4.0); })};

  EXPECT_EQ(complaints(chart), "");
}

TEST_F(ChartGnuplot, DrawsAFrameIfThereIsNothingElse) {
  Chart chart;
  chart.name = "empty";

  EXPECT_EQ(complaints(chart), "");
}

TEST(ChartScript, FiltersTheRowsOfEachCurve) {
  const std::string script = chart_gnuplot(chart_of_everything());

  EXPECT_NE(script.find("data = 'all.csv'"), std::string::npos);
  EXPECT_NE(script.find("(strcol(1) eq 'ηm (2)' ? $2 : NaN):3 with points"),
            std::string::npos);
  EXPECT_NE(script.find("set size ratio -1"), std::string::npos);
}

}  // namespace
}  // namespace brachisto::report
