// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/sweep_csv.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/csv.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

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
