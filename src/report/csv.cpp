// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
#include "report/arc_structure.hpp"
#include "report/rich_text.hpp"
#include "report/sweep_scenes.hpp"
#include "trajectory/stated_limits.hpp"

namespace brachisto::report {

std::string csv_field(std::string_view text) {
  // A spreadsheet takes it for a formula, perhaps behind a tab or an end of
  // line.
  const bool formula = text.find_first_of("=+-@\t\r\n") == 0;
  const char* before = formula ? "'" : "";
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return before + std::string(text);
  }
  return fmt::format("\"{}{}\"", before, replaced(text, "\"", "\"\""));
}

namespace {

/// 17 digits.
std::string in_full(double value) {
  return fmt::format("{:.17g}", value);
}
/// The same; empty if it is no number.
std::string if_known(double value) {
  return std::isfinite(value) ? in_full(value) : "";
}

/// A column that every trajectory has.
struct Column {
  TrajectoryColumnText text;
  double (*value)(const TrajectoryPoint&);
  bool rolling = false;  ///< a bead has none
};

constexpr Column kColumns[] = {
    {{"u", "s", "rolling time"}, [](const TrajectoryPoint& p) { return p.u; }},
    {{"t", "s", "time"}, [](const TrajectoryPoint& p) { return p.t; }},
    {{"x_c", "m", "x of the centre"},
     [](const TrajectoryPoint& p) { return p.centre.x; }},
    {{"z_c", "m", "z of the centre, down"},
     [](const TrajectoryPoint& p) { return p.centre.z; }},
    {{"x_cm", "m", "x of the centre of mass"},
     [](const TrajectoryPoint& p) { return p.motion.mass_centre.x; }},
    {{"z_cm", "m", "z of the centre of mass"},
     [](const TrajectoryPoint& p) { return p.motion.mass_centre.z; }},
    {{"x_b", "m", "x of the track"},
     [](const TrajectoryPoint& p) { return p.motion.contact.x; }},
    {{"z_b", "m", "z of the track"},
     [](const TrajectoryPoint& p) { return p.motion.contact.z; }},
    {{"theta", "rad", "θ"},
     [](const TrajectoryPoint& p) { return p.theta; },
     true},
    {{"beta", "rad", "β, continuous slope angle"},
     [](const TrajectoryPoint& p) { return p.beta; }},
    {{"v_c", "m/s", "speed of the centre"},
     [](const TrajectoryPoint& p) { return p.motion.v_c; }},
    {{"omega", "rad/s", "ω, angular speed"},
     [](const TrajectoryPoint& p) { return p.motion.omega; },
     true},
    {{"R_n", "m g", "normal force, which presses body and track"},
     [](const TrajectoryPoint& p) { return p.motion.R_n; }},
    {{"R_t", "m g", "tangential force, along the motion"},
     [](const TrajectoryPoint& p) { return p.motion.R_t; },
     true},
    {{"kappa_b", "1/m", "curvature of the track"},
     [](const TrajectoryPoint& p) { return p.motion.kappa_b; }}};

/// A column of a trajectory: a number per row, which a bead may not have, or
/// words.
struct Cells {
  std::string name;
  std::function<double(const TrajectoryPoint&)> number = {};
  std::function<std::string(const TrajectoryPoint&)> words = {};
};

std::vector<Cells> cells_of(const Motion& motion) {
  std::vector<Cells> columns;
  for (const Column& column : kColumns) {
    columns.push_back({std::string(column.text.name)});
    if (motion.scene().body.rolls() || !column.rolling) {
      columns.back().number = column.value;
    }
  }
  return columns;
}

std::vector<Cells> cells_of(const Solution& solution) {
  std::vector<Cells> columns = cells_of(*solution.motion());
  if (!solution.scene.limits.any()) return columns;
  columns.push_back(
      {"active", {}, [&](const TrajectoryPoint& row) {
         return fmt::format(
             "{}", fmt::join(holding_at(row.sigma, solution.limits), "+"));
       }});
  for (const StatedLimit& limit : stated_limits(solution.scene)) {
    columns.push_back({"slack_" + limit.name, limit.slack});
  }
  return columns;
}

std::string csv(const Motion& motion, const std::vector<Cells>& columns) {
  std::string out = csv_row(columns, &Cells::name);
  for (const TrajectoryPoint& row : motion.at_nodes()) {
    check_stop();
    out += csv_row(columns, [&](const Cells& column) -> std::string {
      if (column.words) return column.words(row);
      return column.number ? in_full(column.number(row)) : "";
    });
  }
  return out;
}

}  // namespace

std::string trajectory_csv(const Motion& motion) {
  return csv(motion, cells_of(motion));
}

std::string trajectory_csv(const Solution& solution) {
  return csv(*solution.motion(), cells_of(solution));
}

std::vector<TrajectoryColumnText> trajectory_column_texts() {
  std::vector<TrajectoryColumnText> texts;
  for (const Column& column : kColumns) texts.push_back(column.text);
  return texts;
}

std::vector<TrajectoryColumn> trajectory_columns(const Solution& solution) {
  const std::vector<TrajectoryPoint> rows = solution.motion()->at_nodes();
  std::vector<TrajectoryColumn> columns;
  for (const Cells& cells : cells_of(solution)) {
    TrajectoryColumn& column = columns.emplace_back();
    column.name = cells.name;
    for (const TrajectoryPoint& row : rows) {
      if (cells.words) {
        column.words.push_back(cells.words(row));
      } else {
        column.numbers.push_back(
            cells.number ? cells.number(row)
                         : std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
  return columns;
}

std::string sweep_csv(const SweepTable& table) {
  std::string out = "scene";
  for (const SweepColumn& column : table.columns) {
    out += "," + csv_field(column.key);
  }
  out +=
      ",state,status,feasible,tau,transit_time,estimated_error,end_angle,"
      "message\n";
  for (const std::size_t scene : all_scenes(table)) {
    const SweepOutcome& outcome = table.outcomes[scene];
    const bool verified = outcome.state == SweepOutcome::State::Verified;
    out += fmt::format("{}", scene);
    for (const SweepColumn& column : table.columns) {
      out += "," + (column.numeric() ? if_known(column.numbers[scene])
                                     : csv_field(column.words[scene]));
    }
    const char* feasible = outcome.feasible ? "true" : "false";
    out += fmt::format(",{},{},{},{},{},{},{},{}\n", name(outcome.state),
                       csv_field(outcome.status), verified ? feasible : "",
                       if_known(outcome.tau), if_known(outcome.transit_time),
                       if_known(outcome.estimated_error),
                       if_known(outcome.end_angle), csv_field(outcome.message));
  }
  return out;
}

}  // namespace brachisto::report
