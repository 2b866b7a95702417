// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "scaling/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "support/csv.hpp"
#include "support/power_law.hpp"

namespace brachisto::benchmarks {

std::string csv(const std::vector<Run>& runs) {
  std::string text =
      "way,nodes,verified,user_seconds,system_seconds,gigabytes,"
      "ipopt_iterations,newton_steps,tau,error,estimated_error,";
  for (std::size_t i = 0; i < kNumPhases; ++i) {
    text += fmt::format("{},", name(static_cast<Phase>(i)));
  }
  text += "fate\n";
  for (const auto& [way, nodes, record, fate] : runs) {
    text += csv_field(kWays[way].name);
    if (!record) {
      text += fmt::format(",{}{}{}\n", nodes, std::string(10 + kNumPhases, ','),
                          csv_field(fate));
      continue;
    }
    text +=
        fmt::format(",{},{},{:.4g},{:.4g},{:.4g},{},{},{:.15g},{:.2e},{:.2e},",
                    record->nodes, record->verified, record->user_seconds,
                    record->system_seconds, record->gigabytes,
                    record->iterations, record->newton_steps, record->tau,
                    record->error, record->estimated_error);
    for (const double phase : record->phases.seconds) {
      text += fmt::format("{:.3g},", phase);
    }
    text += "\n";
  }
  return text;
}

std::vector<Run> read_runs(const std::string& path) {
  std::vector<Run> runs;
  for (const CsvRow& row : read_csv(path)) {
    const Way* const way =
        std::ranges::find(kWays, row.text("way"), &Way::name);
    if (way == std::end(kWays)) {
      throw std::runtime_error(path + ": no way to solve is called " +
                               row.text("way"));
    }
    Run& run = runs.emplace_back();
    run.way = static_cast<int>(way - kWays);
    run.nodes = row.integer("nodes");
    run.fate = row.text("fate");
    if (row.text("verified").empty()) continue;
    Record& record = run.record.emplace();
    record = {.verified = row.text("verified") == "true",
              .nodes = run.nodes,
              .iterations = row.integer("ipopt_iterations"),
              .newton_steps = row.integer("newton_steps"),
              .tau = row.number("tau"),
              .error = row.number("error"),
              .estimated_error = row.number("estimated_error"),
              .user_seconds = row.number("user_seconds"),
              .system_seconds = row.number("system_seconds"),
              .phases = {},
              .gigabytes = row.number("gigabytes")};
    for (std::size_t i = 0; i < kNumPhases; ++i) {
      record.phases.seconds[i] =
          row.number(std::string(name(static_cast<Phase>(i))));
    }
  }
  return runs;
}

report::Chart chart(const std::vector<Run>& runs, const std::string& path) {
  report::Chart chart;
  chart.name = path.substr(path.find_last_of('/') + 1);
  chart.title = "Cost of a solve against the size of its mesh";
  chart.x.label = "nodes";
  chart.x.scale = report::Scale::Logarithmic;
  chart.y.label = "user CPU time of the process [s]";
  chart.y.scale = report::Scale::Logarithmic;
  constexpr report::Mark kMarks[] = {
      report::Mark::Disc,   report::Mark::Square,  report::Mark::Triangle,
      report::Mark::Circle, report::Mark::Diamond, report::Mark::Cross};
  const std::vector<std::string> colours =
      report::family_colours(std::size(kWays));
  for (std::size_t w = 0; w < std::size(kWays); ++w) {
    report::Curve curve;
    std::vector<report::Datum> large;
    for (const Run& run : runs) {
      if (static_cast<std::size_t>(run.way) != w || !run.record ||
          !run.record->verified) {
        continue;
      }
      curve.points.push_back(
          {static_cast<double>(run.record->nodes), run.record->user_seconds});
      if (run.record->nodes > 5'000) large.push_back(curve.points.back());
    }
    curve.id = kWays[w].name;
    curve.name = kWays[w].name;
    std::replace(curve.name.begin(), curve.name.end(), '_', ' ');
    if (const auto law = fit_power(large)) {
      curve.name += fmt::format(" (n^{{{:.2f}}})", law->exponent);
    }
    curve.colour = colours[w];
    curve.mark = kMarks[w];
    curve.stroke = w < 3 ? report::Stroke::Solid : report::Stroke::Dashed;
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

}  // namespace brachisto::benchmarks
