// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "report/solutions.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {
namespace {

using report::trajectory_csv;
using testing::bead_solution;
using testing::limited_solution;
using testing::off_centred_solution;

/// Lines of cells; a missing newline at the end would lose the last line.
std::vector<std::vector<std::string>> cells(const std::string& text) {
  std::vector<std::vector<std::string>> table(1);
  std::string cell;
  for (const char c : text) {
    if (c != ',' && c != '\n') {
      cell += c;
      continue;
    }
    table.back().push_back(cell);
    cell.clear();
    if (c == '\n') table.emplace_back();
  }
  table.pop_back();
  return table;
}

TEST(TrajectoryCsv, HasTheHeaderThatOtherProgramsRelyOn) {
  const std::string text = trajectory_csv(*off_centred_solution().motion());

  EXPECT_EQ(
      text.substr(0, text.find('\n')),
      "u,t,x_c,z_c,x_cm,z_cm,x_b,z_b,theta,beta,v_c,omega,R_n,R_t,kappa_b");
}

TEST(TrajectoryCsv, HasOneRowPerNode) {
  for (const Solution* solution : {&off_centred_solution(), &bead_solution()}) {
    const auto table = cells(trajectory_csv(*solution->motion()));

    ASSERT_EQ(table.size(),
              static_cast<std::size_t>(solution->program()->nodes) + 1);
    for (const auto& row : table) EXPECT_EQ(row.size(), 15u);
  }
}

TEST(TrajectoryCsv, NumbersComeBackBitForBit) {
  const Trajectory& path = *trajectory_of(off_centred_solution());
  const std::vector<TrajectoryPoint> rows = path.at_nodes();

  const auto table = cells(trajectory_csv(path));

  ASSERT_EQ(table.size(), rows.size() + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Kinematics& motion = rows[i].motion;
    const std::vector<double> expected{rows[i].u,
                                       rows[i].t,
                                       rows[i].centre.x,
                                       rows[i].centre.z,
                                       motion.mass_centre.x,
                                       motion.mass_centre.z,
                                       motion.contact.x,
                                       motion.contact.z,
                                       rows[i].theta,
                                       rows[i].beta,
                                       motion.v_c,
                                       motion.omega,
                                       motion.R_n,
                                       motion.R_t,
                                       motion.kappa_b};
    for (std::size_t c = 0; c < expected.size(); ++c) {
      EXPECT_EQ(std::stod(table[i + 1][c]), expected[c])
          << table[0][c] << " in row " << i;
    }
  }
}

TEST(TrajectoryCsv, EveryNumberOfARollingBodyIsFinite) {
  for (const auto& row :
       cells(trajectory_csv(*off_centred_solution().motion()))) {
    if (row[0] == "u") continue;
    for (const std::string& cell : row) {
      EXPECT_TRUE(std::isfinite(std::stod(cell))) << cell;
    }
  }
}

std::size_t column(const std::vector<std::string>& head,
                   const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(head, name) - head.begin());
}

TEST(TrajectoryCsv, OfASceneWithoutLimitsHasNoColumnsOfLimits) {
  EXPECT_EQ(trajectory_csv(off_centred_solution()),
            trajectory_csv(*off_centred_solution().motion()));
}

TEST(TrajectoryCsv, NamesTheLimitsThatAreActiveAtARow) {
  const Solution& solution = limited_solution();
  const std::vector<TrajectoryPoint> rows = solution.motion()->at_nodes();

  const auto table = cells(trajectory_csv(solution));

  ASSERT_EQ(table.size(), rows.size() + 1);
  const std::size_t active = column(table[0], "active");
  EXPECT_EQ(active, 15u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double sigma = rows[i].sigma;
    const bool friction =
        (0.125 <= sigma && sigma <= 0.25) || (0.5 <= sigma && sigma <= 0.75);
    const bool load = 0.6875 <= sigma && sigma <= 0.8125;
    const std::string expected = friction && load ? "friction+normal_force.max"
                                 : friction       ? "friction"
                                 : load           ? "normal_force.max"
                                                  : "";
    EXPECT_EQ(table[i + 1][active], expected) << "at " << sigma;
  }
}

TEST(TrajectoryCsv, HasTheSlackOfEveryBound) {
  const auto table = cells(trajectory_csv(limited_solution()));
  const auto cell = [&](std::size_t row, const std::string& name) {
    return std::stod(table[row].at(column(table[0], name)));
  };
  const double r = limited_solution().scene.body.radius;

  for (std::size_t i = 1; i < table.size(); ++i) {
    EXPECT_EQ(table[i].size(), 19u);
    EXPECT_DOUBLE_EQ(cell(i, "slack_friction"),
                     0.5 * cell(i, "R_n") - std::abs(cell(i, "R_t")));
    EXPECT_DOUBLE_EQ(cell(i, "slack_normal_force.max"), 5.0 - cell(i, "R_n"));
    // The wall is at x = 4, the angle π of its normal rounded.
    EXPECT_NEAR(cell(i, "slack_clear_of.half_plane"), 4.0 - r - cell(i, "x_c"),
                1e-14);
  }
}

TEST(TrajectoryCsv, LeavesEmptyWhatABeadDoesNotHave) {
  const auto table = cells(trajectory_csv(*bead_solution().motion()));

  for (std::size_t i = 1; i < table.size(); ++i) {
    for (std::size_t c = 0; c < table[i].size(); ++c) {
      const std::string& column = table[0][c];
      const bool rolling =
          column == "theta" || column == "omega" || column == "R_t";
      EXPECT_EQ(table[i][c].empty(), rolling) << column << " in row " << i;
    }
  }
}

TEST(TrajectoryCsv, RunsFromRestAtAToBInTheTransitTime) {
  const Trajectory& path = *trajectory_of(off_centred_solution());

  const auto table = cells(trajectory_csv(path));

  EXPECT_EQ(std::stod(table[1][1]), 0.0);
  EXPECT_EQ(std::stod(table[1][10]), 0.0);
  // To rounding and the tangency of the contact.
  EXPECT_NEAR(std::stod(table.back()[1]), path.transit_time(), 1e-14);
  EXPECT_NEAR(std::stod(table.back()[6]), 3.0, 1e-9);
  EXPECT_NEAR(std::stod(table.back()[7]), 1.0, 1e-9);
}

TEST(TrajectoryColumns, HaveTheNumbersAndWordsOfTheTable) {
  for (const Solution* solution :
       {&off_centred_solution(), &bead_solution(), &limited_solution()}) {
    const auto table = cells(trajectory_csv(*solution));

    const auto columns = report::trajectory_columns(*solution);

    ASSERT_EQ(columns.size(), table[0].size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const report::TrajectoryColumn& column = columns[c];
      EXPECT_EQ(column.name, table[0][c]);
      const bool words = column.name == "active";
      ASSERT_EQ(column.numbers.size(), words ? 0 : table.size() - 1);
      ASSERT_EQ(column.words.size(), words ? table.size() - 1 : 0);
      for (std::size_t i = 1; i < table.size(); ++i) {
        const std::string& cell = table[i][c];
        if (words) {
          EXPECT_EQ(column.words[i - 1], cell);
        } else if (cell.empty()) {
          EXPECT_TRUE(std::isnan(column.numbers[i - 1])) << column.name;
        } else {
          EXPECT_EQ(column.numbers[i - 1], std::stod(cell)) << column.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace brachisto
