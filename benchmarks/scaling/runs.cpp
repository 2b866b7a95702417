// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "scaling/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "support/csv.hpp"
#include "support/power_law.hpp"
#include "support/ways.hpp"

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
    Run& run = runs.emplace_back();
    run.way = way_of(row, kWays, path);
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
  using Point = std::optional<report::Datum>;
  report::Chart chart =
      chart_over_nodes(path, kWays, runs, [](const Run& run) -> Point {
        if (!run.record || !run.record->verified) return std::nullopt;
        return Point(
            {static_cast<double>(run.record->nodes), run.record->user_seconds});
      });
  chart.title = "Cost of a solve against the size of its mesh";
  chart.y.label = "user CPU time of the process [s]";
  constexpr report::Mark kMarks[] = {
      report::Mark::Disc,   report::Mark::Square,  report::Mark::Triangle,
      report::Mark::Circle, report::Mark::Diamond, report::Mark::Cross};
  const std::vector<std::string> colours =
      report::family_colours(std::size(kWays));
  for (std::size_t w = 0; w < std::size(kWays); ++w) {
    report::Curve& curve = chart.curves[w];
    std::vector<report::Datum> large;
    std::ranges::copy_if(
        curve.points, std::back_inserter(large),
        [](const report::Datum& point) { return point.x > 5'000; });
    if (const auto law = fit_power(large)) {
      curve.name += fmt::format(" (n^{{{:.2f}}})", law->exponent);
    }
    curve.colour = colours[w];
    curve.mark = kMarks[w];
    curve.stroke = w < 3 ? report::Stroke::Solid : report::Stroke::Dashed;
  }
  return chart;
}

}  // namespace brachisto::benchmarks
