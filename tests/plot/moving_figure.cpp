// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/motion_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "brachisto/report/result.hpp"
#include "plot/tables.hpp"
#include "report/solutions.hpp"

namespace brachisto {
namespace {

using plot::moving_figure;
using plot::TrajectoryTable;
using report::Figure;
using testing::Incline;

/// Numbers in the rows of the body: frame, t, x_b, z_b, x_c, z_c, …
std::vector<std::vector<double>> bodies(const Figure& figure) {
  std::vector<std::vector<double>> rows;
  std::istringstream table(figure.table);
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with("body,")) continue;
    std::istringstream cells(line.substr(5));
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(std::stod(cell));
    }
  }
  return rows;
}

TEST(MovingFigure, HasTheBodyAtEqualTimes) {
  const Incline incline;
  const Figure figure =
      moving_figure(incline.scene(), TrajectoryTable::read(incline.csv(40)));

  const auto rows = bodies(figure);
  constexpr double kSevenDigits = 1e-6;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t =
        1.5 * static_cast<double>(i) / static_cast<double>(rows.size() - 1);
    const double s = 1.5 * t * t;
    EXPECT_NEAR(rows[i][1], t, kSevenDigits);
    EXPECT_NEAR(rows[i][2], s * std::cos(0.5), kSevenDigits);
    EXPECT_NEAR(rows[i][3], s * std::sin(0.5), kSevenDigits);
  }
}

TEST(MovingFigure, IsDrawnFrameByFrame) {
  for (const Solution* solution :
       {&testing::bead_solution(), &testing::limited_solution()}) {
    const auto drawn = report::draw(
        moving_figure(solution->scene,
                      TrajectoryTable::read(report::trajectory_csv(*solution))),
        report::Format::Gif, nullptr);

    ASSERT_EQ(drawn.missing, "");
    EXPECT_EQ(drawn.files.back().name, "motion.gif");
    const std::string& gif = drawn.files.back().content;
    EXPECT_TRUE(gif.starts_with("GIF89a"));
    // Each frame has an extension of its own that tells its delay, 5/100 s.
    std::size_t frames = 0;
    const std::string delay("\x21\xf9\x04", 3);
    for (std::size_t at = gif.find(delay); at != std::string::npos;
         at = gif.find(delay, at + 1)) {
      if (gif[at + 4] == 5 && gif[at + 5] == 0 && gif[at + 7] == 0) ++frames;
    }
    EXPECT_EQ(frames, 73U);
  }
}

}  // namespace
}  // namespace brachisto
