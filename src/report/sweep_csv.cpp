// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/sweep_csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace brachisto::report {

namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string{};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

}  // namespace

std::string sweep_csv(const SweepTable& table, const Scenes& scenes) {
  std::string out = "scene";
  for (const SweepColumn& column : table.columns) {
    out += "," + quoted(column.key);
  }
  out +=
      ",state,status,feasible,tau,transit_time,estimated_error,end_angle,"
      "message\n";
  for (const std::size_t scene : scenes) {
    const SweepOutcome& outcome = table.outcomes[scene];
    const bool verified = outcome.state == SweepOutcome::State::Verified;
    out += fmt::format("{}", scene);
    for (const SweepColumn& column : table.columns) {
      out += "," + (column.numeric() ? number(column.numbers[scene])
                                     : quoted(column.words[scene]));
    }
    const char* feasible = outcome.feasible ? "true" : "false";
    out += fmt::format(",{},{},{},{},{},{},{},{}\n", name(outcome.state),
                       quoted(outcome.status), verified ? feasible : "",
                       number(outcome.tau), number(outcome.transit_time),
                       number(outcome.estimated_error),
                       number(outcome.end_angle), quoted(outcome.message));
  }
  return out;
}

}  // namespace brachisto::report
