// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
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
  std::string out = std::string("\"") + before;
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

namespace {

/// 17 digits.
std::string in_full(double value) {
  return fmt::format("{:.17g}", value);
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

constexpr const char* kActive = "active";
constexpr const char* kSlack = "slack_";

std::string names_of_columns() {
  std::string names;
  for (const Column& column : kColumns) {
    if (!names.empty()) names += ',';
    names += column.text.name;
  }
  return names;
}

/// The cells of `kColumns`.
std::string cells(const TrajectoryPoint& row, bool rolls) {
  std::string out;
  for (const Column& column : kColumns) {
    if (!out.empty()) out += ',';
    if (rolls || !column.rolling) out += in_full(column.value(row));
  }
  return out;
}

/// Names of the limits that hold as equations at a place, joined by +.
std::string active_at(double sigma, const std::vector<LimitOnPath>& limits) {
  std::string names;
  for (const LimitOnPath& limit : limits) {
    const bool active =
        std::ranges::any_of(limit.active, [&](const ActiveArc& arc) {
          return arc.sigma.from <= sigma && sigma <= arc.sigma.to;
        });
    if (active) names += (names.empty() ? "" : "+") + limit.name;
  }
  return names;
}

}  // namespace

std::string trajectory_csv(const Motion& motion) {
  std::string out = names_of_columns() + '\n';
  for (const TrajectoryPoint& row : motion.at_nodes()) {
    check_stop();
    out += cells(row, motion.scene().body.rolls()) + '\n';
  }
  return out;
}

std::string trajectory_csv(const Solution& solution) {
  const Motion& motion = *solution.motion();
  if (!solution.scene.limits.any()) return trajectory_csv(motion);
  const std::vector<StatedLimit> limits = stated_limits(solution.scene);
  std::string out = names_of_columns() + ',' + kActive;
  for (const StatedLimit& limit : limits) {
    out += std::string(",") + kSlack + limit.name;
  }
  out += '\n';
  for (const TrajectoryPoint& row : motion.at_nodes()) {
    check_stop();
    out += cells(row, motion.scene().body.rolls()) + ',' +
           active_at(row.sigma, solution.limits);
    for (const StatedLimit& limit : limits) {
      out += ',' + in_full(limit.slack(row));
    }
    out += '\n';
  }
  return out;
}

std::vector<TrajectoryColumnText> trajectory_column_texts() {
  std::vector<TrajectoryColumnText> texts;
  for (const Column& column : kColumns) texts.push_back(column.text);
  return texts;
}

std::vector<TrajectoryColumn> trajectory_columns(const Solution& solution) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Motion& motion = *solution.motion();
  const bool rolls = motion.scene().body.rolls();
  const std::vector<TrajectoryPoint> rows = motion.at_nodes();
  const auto numbers_of = [&](const auto& value) {
    std::vector<double> numbers;
    numbers.reserve(rows.size());
    for (const TrajectoryPoint& row : rows) numbers.push_back(value(row));
    return numbers;
  };
  std::vector<TrajectoryColumn> columns;
  for (const Column& column : kColumns) {
    columns.push_back({std::string(column.text.name),
                       rolls || !column.rolling
                           ? numbers_of(column.value)
                           : std::vector<double>(rows.size(), kNone),
                       {}});
  }
  if (!solution.scene.limits.any()) return columns;
  columns.push_back({kActive, {}, {}});
  for (const TrajectoryPoint& row : rows) {
    columns.back().words.push_back(active_at(row.sigma, solution.limits));
  }
  for (const StatedLimit& limit : stated_limits(solution.scene)) {
    columns.push_back({kSlack + limit.name, numbers_of(limit.slack), {}});
  }
  return columns;
}

namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string{};
}

}  // namespace

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
      out += "," + (column.numeric() ? number(column.numbers[scene])
                                     : csv_field(column.words[scene]));
    }
    const char* feasible = outcome.feasible ? "true" : "false";
    out += fmt::format(",{},{},{},{},{},{},{},{}\n", name(outcome.state),
                       csv_field(outcome.status), verified ? feasible : "",
                       number(outcome.tau), number(outcome.transit_time),
                       number(outcome.estimated_error),
                       number(outcome.end_angle), csv_field(outcome.message));
  }
  return out;
}

}  // namespace brachisto::report
