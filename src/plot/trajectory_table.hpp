// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A trajectory as its table has it, trajectory.csv, for pictures that move:
/// its rows, what lies between them, and fewer of them.

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brachisto/model/body.hpp"

namespace brachisto::plot {

/// A text is no trajectory; what() tells the line.
class NoTrajectory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where the body is at a time.
struct Pose {
  Point centre;        ///< (x_c, z_c) [m]
  double theta = 0.0;  ///< θ [rad]; 0 of a bead
  double beta = 0.0;   ///< β [rad]

  /// (x_b, z_b), eqs. (11)–(12).
  [[nodiscard]] Point contact(const Body& body) const;
  /// (x_cm, z_cm), eqs. (2)–(3).
  [[nodiscard]] Point mass_centre(const Body& body) const;
};

/// One quantity in all rows; NaN where the table is empty.
struct TableColumn {
  std::string name;
  std::vector<double> values;
};

/// The numbers of a trajectory, row by row in the order of time. Between rows
/// every quantity is the cubic polynomial of time with given values and slopes
/// at the rows: of x_c, z_c and θ the slopes are v_c cos β, v_c sin β and ω;
/// of the others those of the parabola through the row and its neighbours.
/// Under limits, where forces jump, a curve is no steeper than three times the
/// flatter chord beside the row. So does the script of the page (web/answer.js)
/// read them.
class TrajectoryTable {
 public:
  /// Reads the table that report::trajectory_csv() writes. Of rows at one time,
  /// as arcs of no length have them, the first one is kept.
  /// \throws NoTrajectory  without the columns of every table, with fewer than
  ///                       two times or with times that fall
  [[nodiscard]] static TrajectoryTable read(std::string_view csv);

  /// The first two being u and t, which rises, and with those that are asked
  /// for among the others.
  explicit TrajectoryTable(std::vector<TableColumn> columns)
      : columns_(std::move(columns)) {}

  [[nodiscard]] std::size_t size() const { return time().size(); }
  [[nodiscard]] const std::vector<TableColumn>& columns() const {
    return columns_;
  }
  /// \pre there is one of that name
  [[nodiscard]] const std::vector<double>& operator[](
      std::string_view name) const;
  [[nodiscard]] const std::vector<double>& time() const {
    return columns_[kTime].values;
  }

  /// At 0 ≤ t ≤ T.
  [[nodiscard]] Pose pose(double t) const;
  /// A quantity at 0 ≤ t ≤ T.
  [[nodiscard]] double value(std::string_view name, double t) const;

  /// The table of some of its rows, in their order.
  [[nodiscard]] TrajectoryTable with_rows(
      const std::vector<std::size_t>& rows) const;

 private:
  TrajectoryTable() = default;

  static constexpr std::size_t kTime = 1;  // behind u

  /// The row from which on a time lies, not the last one.
  [[nodiscard]] std::size_t row_before(double t) const;
  [[nodiscard]] double parabola_slope(const std::vector<double>& values,
                                      std::size_t row) const;
  [[nodiscard]] double curve_slope(const std::vector<double>& values,
                                   std::size_t row) const;

  std::vector<TableColumn> columns_;
};

}  // namespace brachisto::plot
