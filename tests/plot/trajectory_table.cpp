// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/trajectory_table.hpp"

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

using plot::NoTrajectory;
using plot::Pose;
using plot::TrajectoryTable;
using testing::bead_solution;
using testing::Incline;
using testing::kTableHead;
using testing::limited_solution;
using testing::off_centred_solution;

TEST(TrajectoryTable, HasWhatWasWritten) {
  const Solution& solution = off_centred_solution();

  const auto table = TrajectoryTable::read(report::trajectory_csv(solution));

  const std::vector<TrajectoryPoint> rows = solution.motion()->at_nodes();
  ASSERT_EQ(table.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(table.time()[i], rows[i].t);
    EXPECT_EQ(table["x_c"][i], rows[i].centre.x);
    EXPECT_EQ(table["theta"][i], rows[i].theta);
    EXPECT_EQ(table["R_n"][i], rows[i].motion.R_n);
    EXPECT_EQ(table["kappa_b"][i], rows[i].motion.kappa_b);
  }
}

TEST(TrajectoryTable, HasNoNumbersOfWhatABeadDoesNotHave) {
  const auto table =
      TrajectoryTable::read(report::trajectory_csv(bead_solution()));

  EXPECT_TRUE(std::isnan(table["theta"].back()));
  EXPECT_TRUE(std::isinf(table["kappa_b"].front()));
  EXPECT_EQ(table.pose(0.5 * table.time().back()).theta, 0.0);
}

TEST(TrajectoryTable, HasTheSlacksOfLimitsBesideTheirNames) {
  const auto table =
      TrajectoryTable::read(report::trajectory_csv(limited_solution()));

  const TrajectoryPoint last = limited_solution().motion()->at_nodes().back();
  EXPECT_EQ(table["slack_normal_force.max"].back(), 5.0 - last.motion.R_n);
}

TEST(TrajectoryTable, IsExactWhereTheMotionIsASquareOfTime) {
  const Incline incline;
  const auto table = TrajectoryTable::read(incline.csv(4));

  for (const double t : {0.0, 0.1, 0.5, 0.77, 1.3, 1.5}) {
    const Pose pose = table.pose(t);

    // A few roundings of numbers of order one.
    constexpr double kRounding = 1e-14;
    const double s = 1.5 * t * t;
    EXPECT_NEAR(pose.theta, s / 0.25, 4.0 * kRounding);
    const Point contact = pose.contact(incline.scene().body);
    EXPECT_NEAR(contact.x, s * std::cos(0.5), kRounding);
    EXPECT_NEAR(contact.z, s * std::sin(0.5), kRounding);
  }
}

/// The error of a cubic with given slopes is h⁴/384 times a fourth derivative:
/// with every second row left out it grows sixteenfold.
TEST(TrajectoryTable, MissesTheMotionBetweenRowsByTheFourthPowerOfTheirStep) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 4;
  mesh.elements = 64;
  const Solution solution =
      solve(testing::reference("reference_case").scene(), options);
  const auto all = TrajectoryTable::read(report::trajectory_csv(solution));
  const auto error = [&](std::size_t step) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < all.size(); i += step) rows.push_back(i);
    const TrajectoryTable few = all.with_rows(rows);
    double largest = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Pose pose = few.pose(all.time()[i]);
      largest = std::max(largest, std::hypot(pose.centre.x - all["x_c"][i],
                                             pose.centre.z - all["z_c"][i]));
    }
    return largest;
  };

  const double ratio = error(16) / error(8);

  EXPECT_GT(ratio, 8.0);
  EXPECT_LT(ratio, 32.0);
}

/// A slack beside the columns of every table tells that there are limits.
std::string with_slack(const std::string& csv) {
  std::string out;
  std::istringstream rows(csv);
  std::string cell = ",slack_floor";
  for (std::string row; std::getline(rows, row); cell = ",0") {
    out += row + cell + "\n";
  }
  return out;
}

TEST(TrajectoryTable, UnderLimitsDoesNotLeaveTheValuesBesideAJump) {
  Incline incline;
  incline.normal = [](int row) { return row < 5 ? 1.0 : 3.0; };
  const auto table = TrajectoryTable::read(with_slack(incline.csv(10)));

  for (int i = 0; i <= 300; ++i) {
    const double value = table.value("R_n", 1.5 * i / 300.0);

    constexpr double kRounding = 1e-14;
    EXPECT_GE(value, 1.0 - kRounding);
    EXPECT_LE(value, 3.0 + kRounding);
  }
}

TEST(TrajectoryTable, KeepsTheFirstOfRowsAtOneTime) {
  const std::string csv = Incline().csv(3);
  const std::string row = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);

  EXPECT_EQ(TrajectoryTable::read(csv + row).size(), 3U);
}

/// What is said of a text that is no trajectory.
std::string refusal(const std::string& csv) {
  try {
    (void)TrajectoryTable::read(csv);
  } catch (const NoTrajectory& error) {
    return error.what();
  }
  return "none";
}

TEST(TrajectoryTable, RefusesOtherTextsWithTheLine) {
  const std::string good = Incline().csv(3), head = kTableHead;
  const std::string row = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n";

  EXPECT_EQ(refusal(good), "none");
  EXPECT_TRUE(refusal("").starts_with("line 1"));
  EXPECT_TRUE(refusal("x,z\n0,0\n").starts_with("line 1"));
  EXPECT_EQ(refusal(head), "there are no two rows of different times");
  EXPECT_EQ(refusal(head + row + row),
            "there are no two rows of different times");
  EXPECT_EQ(refusal(good + row), "line 5: the time does not grow");
  EXPECT_EQ(refusal(head + row + "0,1,x,0,0,0,0,0,0,0,0,0,0,0,0\n"),
            "line 3: x is no number");
  EXPECT_EQ(refusal(head + row + "0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,7\n"),
            "line 3 has 16 cell(s), not 15");
  // A row that was cut off.
  EXPECT_EQ(refusal(head + row + "0,1,0,0\n"), "line 3 has 4 cell(s), not 15");
  EXPECT_EQ(refusal(head + row + "\n"), "line 3 has 1 cell(s), not 15");
}

}  // namespace
}  // namespace brachisto
