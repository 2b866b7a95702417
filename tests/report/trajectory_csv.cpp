// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "report/solutions.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {
namespace {

using report::trajectory_csv;
using testing::bead_solution;
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

}  // namespace
}  // namespace brachisto
