// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/report/result.hpp"
#include "report/sweep_scenes.hpp"

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

std::string trajectory_csv(const Motion& motion) {
  std::string out =
      "u,t,x_c,z_c,x_cm,z_cm,x_b,z_b,theta,beta,v_c,omega,R_n,R_t,kappa_b\n";
  const bool rolls = motion.scene().body.rolls();
  const auto number = [](double value) {
    return fmt::format("{:.17g}", value);
  };
  const auto rolling = [&](double value) {
    return rolls ? number(value) : std::string{};
  };
  for (const TrajectoryPoint& row : motion.at_nodes()) {
    check_stop();
    const Kinematics& at = row.motion;
    fmt::format_to(std::back_inserter(out),
                   "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   number(row.u), number(row.t), number(row.centre.x),
                   number(row.centre.z), number(at.mass_centre.x),
                   number(at.mass_centre.z), number(at.contact.x),
                   number(at.contact.z), rolling(row.theta), number(row.beta),
                   number(at.v_c), rolling(at.omega), number(at.R_n),
                   rolling(at.R_t), number(at.kappa_b));
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
