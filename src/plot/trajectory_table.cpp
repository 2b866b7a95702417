// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/trajectory_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <ranges>
#include <system_error>

#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"

namespace brachisto::plot {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What every table has.
const std::vector<report::TrajectoryColumnText>& needed_columns() {
  static const auto kColumns = report::trajectory_column_texts();
  return kColumns;
}

/// Cuts a text off at a letter; takes the rest if there is none.
std::string_view taken(std::string_view& text, char end) {
  const std::size_t at = text.find(end);
  const std::string_view piece = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return piece;
}

double number(std::string_view cell, std::size_t line) {
  if (cell.empty()) return kNone;
  double value = kNone;
  const auto [end, error] =
      std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) {
    throw NoTrajectory(fmt::format("line {}: {} is no number", line, cell));
  }
  return value;
}

/// The cubic on [0, h] with values a, b and slopes da, db at its ends, at the
/// share s of h.
double cubic(double s, double h, double a, double b, double da, double db) {
  const double r = 1.0 - s;
  return r * r * ((1.0 + 2.0 * s) * a + s * h * da) +
         s * s * ((1.0 + 2.0 * r) * b - r * h * db);
}

}  // namespace

Point Pose::contact(const Body& body) const {
  return {centre.x - body.radius * std::sin(beta),
          centre.z + body.radius * std::cos(beta)};
}

Point Pose::mass_centre(const Body& body) const {
  const double offset = body.radius * body.eta_m;
  return {centre.x + offset * std::cos(theta),
          centre.z + offset * std::sin(theta)};
}

TrajectoryTable TrajectoryTable::read(std::string_view csv) {
  TrajectoryTable table;
  std::string_view head = taken(csv, '\n');
  constexpr std::string_view kActive = "active";
  std::vector<bool> numeric;
  while (!head.empty()) {
    const std::string_view name = taken(head, ',');
    numeric.push_back(name != kActive);
    if (numeric.back()) table.columns_.push_back({std::string(name), {}});
  }
  const auto& needed = needed_columns();
  const auto name = &report::TrajectoryColumnText::name;
  if (!std::ranges::equal(needed,
                          table.columns_ | std::views::take(needed.size()), {},
                          name, &TableColumn::name)) {
    throw NoTrajectory(
        fmt::format("line 1 does not begin with {}",
                    fmt::join(needed | std::views::transform(name), ",")));
  }
  for (std::size_t line = 2; !csv.empty(); ++line) {
    check_stop();
    std::string_view row = taken(csv, '\n');
    const auto cells = static_cast<std::size_t>(std::ranges::count(row, ','));
    if (cells + 1 != numeric.size()) {
      throw NoTrajectory(fmt::format("line {} has {} cell(s), not {}", line,
                                     cells + 1, numeric.size()));
    }
    auto column = table.columns_.begin();
    for (const bool is_number : numeric) {
      const std::string_view cell = taken(row, ',');
      if (is_number) (column++)->values.push_back(number(cell, line));
    }
  }
  const std::vector<double>& t = table.time();
  std::vector<std::size_t> rows{0};
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!(t[i] >= t[i - 1])) {  // written so that a NaN does not grow
      throw NoTrajectory(fmt::format("line {}: the time does not grow", i + 2));
    }
    if (t[i] > t[rows.back()]) rows.push_back(i);
  }
  constexpr std::size_t kFewest = 2;
  if (t.empty() || rows.size() < kFewest) {
    throw NoTrajectory("there are no two rows of different times");
  }
  return rows.size() == t.size() ? table : table.with_rows(rows);
}

const std::vector<double>& TrajectoryTable::operator[](
    std::string_view name) const {
  return std::ranges::find(columns_, name, &TableColumn::name)->values;
}

std::size_t TrajectoryTable::row_before(double t) const {
  const std::vector<double>& times = time();
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  return static_cast<std::size_t>(after - times.begin()) - 1;
}

double TrajectoryTable::parabola_slope(const std::vector<double>& values,
                                       std::size_t row) const {
  const std::vector<double>& t = time();
  const std::size_t last = t.size() - 1;
  if (last == 1) return (values[1] - values[0]) / (t[1] - t[0]);
  const std::size_t i = std::clamp<std::size_t>(row, 1, last - 1);
  const double h = t[i] - t[i - 1], k = t[i + 1] - t[i];
  const double before = (values[i] - values[i - 1]) / h;
  const double after = (values[i + 1] - values[i]) / k;
  const double middle = (k * before + h * after) / (h + k);
  if (row == i) return middle;
  return row < i ? 2.0 * before - middle : 2.0 * after - middle;
}

double TrajectoryTable::curve_slope(const std::vector<double>& values,
                                    std::size_t row) const {
  const double slope = parabola_slope(values, row);
  if (columns_.size() == needed_columns().size()) return slope;
  const auto chord = [&](std::size_t i) {
    return std::abs((values[i + 1] - values[i]) / (time()[i + 1] - time()[i]));
  };
  const std::size_t last = size() - 1;
  const double most = 3.0 * std::min(chord(row == 0 ? 0 : row - 1),
                                     chord(std::min(row, last - 1)));
  return std::min(std::max(slope, -most), most);
}

double TrajectoryTable::value(std::string_view name, double t) const {
  const std::vector<double>& values = (*this)[name];
  const std::size_t i = row_before(t);
  const double h = time()[i + 1] - time()[i];
  return cubic((t - time()[i]) / h, h, values[i], values[i + 1],
               curve_slope(values, i), curve_slope(values, i + 1));
}

Pose TrajectoryTable::pose(double t) const {
  const std::size_t i = row_before(t);
  const double h = time()[i + 1] - time()[i];
  const double s = (t - time()[i]) / h;
  const auto at = [&](std::string_view name, auto&& slope) {
    const std::vector<double>& values = (*this)[name];
    return cubic(s, h, values[i], values[i + 1], slope(i), slope(i + 1));
  };
  const std::vector<double>&v = (*this)["v_c"], &beta = (*this)["beta"],
        &omega = (*this)["omega"];
  Pose pose;
  pose.centre.x =
      at("x_c", [&](std::size_t j) { return v[j] * std::cos(beta[j]); });
  pose.centre.z =
      at("z_c", [&](std::size_t j) { return v[j] * std::sin(beta[j]); });
  pose.beta =
      at("beta", [&](std::size_t j) { return parabola_slope(beta, j); });
  const double theta = at("theta", [&](std::size_t j) { return omega[j]; });
  if (!std::isnan(theta)) pose.theta = theta;
  return pose;
}

TrajectoryTable TrajectoryTable::with_rows(
    const std::vector<std::size_t>& rows) const {
  TrajectoryTable table;
  for (const TableColumn& column : columns_) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const std::size_t row : rows) values.push_back(column.values[row]);
    table.columns_.push_back({column.name, std::move(values)});
  }
  return table;
}

}  // namespace brachisto::plot
