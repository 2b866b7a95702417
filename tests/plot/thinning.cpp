// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "brachisto/report/result.hpp"
#include "plot/tables.hpp"
#include "report/solutions.hpp"

namespace brachisto {
namespace {

using plot::shown_range;
using plot::ShownCurve;
using plot::thinned;
using plot::ThinnedTable;
using plot::TrajectoryTable;
using report::Extent;
using testing::Incline;

/// Many rows of a motion with some turns.
const TrajectoryTable& many_rows() {
  static const TrajectoryTable kTable = [] {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = 4;
    mesh.elements = 400;
    return TrajectoryTable::read(report::trajectory_csv(
        solve(testing::reference("reference_case").scene(), options)));
  }();
  return kTable;
}

const Body& reference_body() {
  static const Body kBody = testing::reference("reference_case").scene().body;
  return kBody;
}

std::vector<ShownCurve> force() {
  return {{"R_n", shown_range(many_rows(), many_rows()["R_n"])}};
}

TEST(Thinning, LeavesAllRowsWhereThereIsRoom) {
  const std::size_t n = many_rows().size();

  const ThinnedTable all = thinned(many_rows(), reference_body(), force(), n);

  EXPECT_EQ(all.table.size(), n);
  EXPECT_EQ(all.of_rows, n);
  EXPECT_EQ(all.path_error, 0.0);
  EXPECT_EQ(all.curve_error, 0.0);
}

TEST(Thinning, KeepsBothEndsAndSoManyRowsAtMost) {
  for (const std::size_t most : {20U, 100U, 500U}) {
    const ThinnedTable few =
        thinned(many_rows(), reference_body(), force(), most);

    EXPECT_LE(few.table.size(), most);
    EXPECT_EQ(few.of_rows, many_rows().size());
    EXPECT_EQ(few.table.time().front(), 0.0);
    EXPECT_EQ(few.table.time().back(), many_rows().time().back());
  }
}

TEST(Thinning, TellsTheErrorAtTheRowsLeftOut) {
  const ThinnedTable few = thinned(many_rows(), reference_body(), force(), 60);

  double path = 0.0, curve = 0.0;
  const TrajectoryTable& all = many_rows();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double t = all.time()[i];
    const Point c = few.table.pose(t).centre;
    const Point b = few.table.pose(t).contact(reference_body());
    path = std::max({path, std::hypot(c.x - all["x_c"][i], c.z - all["z_c"][i]),
                     std::hypot(b.x - all["x_b"][i], b.z - all["z_b"][i])});
    const Extent range = force().front().range;
    if (all["R_n"][i] < range.low || all["R_n"][i] > range.high) continue;
    curve =
        std::max(curve, std::abs(few.table.value("R_n", t) - all["R_n"][i]) /
                            range.width());
  }
  EXPECT_GT(path, 0.0);
  EXPECT_EQ(few.path_error, path);
  EXPECT_EQ(few.curve_error, curve);
}

TEST(Thinning, WithMoreRowsErrsLess) {
  const ThinnedTable few = thinned(many_rows(), reference_body(), force(), 50);
  const ThinnedTable more =
      thinned(many_rows(), reference_body(), force(), 400);

  EXPECT_LT(more.path_error, few.path_error);
  EXPECT_LT(more.curve_error, few.curve_error);
  // A thousandth of a picture is less than a pixel.
  EXPECT_LT(more.path_error, 1e-3 * 3.0);
  EXPECT_LT(more.curve_error, 1e-3);
}

TEST(Thinning, OfWhatIsStraightTakesNoTime) {
  const Incline incline;
  const auto table = TrajectoryTable::read(incline.csv(50'000));

  const ThinnedTable few = thinned(table, incline.scene().body, {}, 1000);

  // The motion is a square of time, which cubics have exactly.
  EXPECT_LE(few.table.size(), 1000U);
  EXPECT_LT(few.path_error, 1e-13);
}

TEST(Thinning, OfWhatNothingThinsTakesRowsAtEqualSteps) {
  Incline rough;
  rough.normal = [](int row) { return row % 2 == 0 ? 0.0 : 1.0; };
  const auto table = TrajectoryTable::read(rough.csv(9001));

  const ThinnedTable few =
      thinned(table, rough.scene().body,
              {{"R_n", shown_range(table, table["R_n"])}}, 1001);

  EXPECT_EQ(few.table.size(), 1001U);
  EXPECT_EQ(few.table.time()[1], table.time()[9]);
  EXPECT_GT(few.curve_error, plot::kCoarsest);
  EXPECT_LT(few.path_error, 1e-13);  // the motion is a square of time
}

TEST(ShownRange, LeavesOutPolesAndTheStart) {
  Incline incline;
  incline.normal = [](int row) {
    if (row < 3) return 1e6;
    return row == 500 ? -1e9 : std::sin(0.1 * row);
  };
  const auto table = TrajectoryTable::read(incline.csv(1000));

  const Extent range = shown_range(table, table["R_n"]);

  EXPECT_NEAR(range.low, -1.0, 0.01);
  EXPECT_NEAR(range.high, 1.0, 0.01);
}

TEST(ShownRange, HasAllOfWhatIsModerate) {
  Incline incline;
  incline.normal = [](int row) { return 0.001 * row; };
  const auto table = TrajectoryTable::read(incline.csv(1001));

  const Extent range = shown_range(table, table["R_n"]);

  EXPECT_EQ(range.low, 0.02);  // where a fiftieth of the time is over
  EXPECT_EQ(range.high, 1.0);
}

}  // namespace
}  // namespace brachisto
