// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/report/result.hpp"
#include "report/sweep_scenes.hpp"
#include "trajectory/stated_limits.hpp"

namespace brachisto::report {

bool begins_as_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) !=
                              std::string_view::npos;
}

std::string csv_field(std::string_view text) {
  const char* before = begins_as_formula(text) ? "'" : "";
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

constexpr std::string_view kColumns =
    "u,t,x_c,z_c,x_cm,z_cm,x_b,z_b,theta,beta,v_c,omega,R_n,R_t,kappa_b";

/// The cells of `kColumns`.
std::string cells(const TrajectoryPoint& row, bool rolls) {
  const auto rolling = [&](double value) {
    return rolls ? in_full(value) : std::string{};
  };
  const Kinematics& at = row.motion;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                     in_full(row.u), in_full(row.t), in_full(row.centre.x),
                     in_full(row.centre.z), in_full(at.mass_centre.x),
                     in_full(at.mass_centre.z), in_full(at.contact.x),
                     in_full(at.contact.z), rolling(row.theta),
                     in_full(row.beta), in_full(at.v_c), rolling(at.omega),
                     in_full(at.R_n), rolling(at.R_t), in_full(at.kappa_b));
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
  std::string out = std::string(kColumns) + '\n';
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
  std::string out = std::string(kColumns) + ",active";
  for (const StatedLimit& limit : limits) out += ",slack_" + limit.name;
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
