// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "peers/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "support/csv.hpp"
#include "support/table.hpp"
#include "support/ways.hpp"

namespace brachisto::benchmarks {

Record median(std::span<const Record> records) {
  const auto of = [&](auto Record::*member) {
    std::vector<double> values;
    for (const Record& one : records) {
      values.push_back(static_cast<double>(one.*member));
    }
    return percentile(std::move(values), 0.5);
  };
  Record out = records.front();
  out.solved = std::ranges::all_of(records, &Record::solved);
  out.made_seconds = of(&Record::made_seconds);
  out.solve_seconds = of(&Record::solve_seconds);
  out.evaluation_seconds = of(&Record::evaluation_seconds);
  out.gigabytes = of(&Record::gigabytes);
  return out;
}

std::string csv(const std::vector<Run>& runs) {
  std::string text =
      "way,nodes,repeats,solved,variables,iterations,error,residual,"
      "made_seconds,solve_seconds,evaluation_seconds,gigabytes,fate\n";
  for (const auto& [way, nodes, repeats, record, fate] : runs) {
    text +=
        fmt::format("{},{},{},", csv_field(kWays[way].name), nodes, repeats);
    if (!record) {
      text += fmt::format(",,,,,,,,,{}\n", csv_field(fate));
      continue;
    }
    text += fmt::format("{},{},{},{:.2e},{:.1e},{:.3g},{:.3g},{:.3g},{:.3g},\n",
                        record->solved, record->variables, record->iterations,
                        record->error, record->residual, record->made_seconds,
                        record->solve_seconds, record->evaluation_seconds,
                        record->gigabytes);
  }
  return text;
}

std::vector<Run> read_runs(const std::string& path) {
  std::vector<Run> runs;
  for (const CsvRow& row : read_csv(path)) {
    Run& run = runs.emplace_back();
    run.way = way_of(row, kWays, path);
    run.nodes = row.integer("nodes");
    run.repeats = row.integer("repeats");
    run.fate = row.text("fate");
    if (row.text("solved").empty()) continue;
    run.record = {.solved = row.text("solved") == "true",
                  .variables = row.integer("variables"),
                  .iterations = row.integer("iterations"),
                  .error = row.number("error"),
                  .residual = row.number("residual"),
                  .made_seconds = row.number("made_seconds"),
                  .solve_seconds = row.number("solve_seconds"),
                  .evaluation_seconds = row.number("evaluation_seconds"),
                  .gigabytes = row.number("gigabytes")};
  }
  return runs;
}

std::string markdown(const std::vector<Run>& runs) {
  Rows rows{{"way", "nodes", "iterations", "solve [s]", "of that evaluation",
             "to make or read it [s]", "peak [MB]", "error of τ", "residual"}};
  for (const Run& run : runs) {
    const char* const name = kWays[run.way].name;
    if (!run.record) {
      rows.push_back({name, fmt::format("{}", run.nodes), run.fate, "", "", "",
                      "", "", ""});
      continue;
    }
    const Record& record = *run.record;
    rows.push_back({name, fmt::format("{}", run.nodes),
                    fmt::format("{}{}", record.iterations,
                                record.solved ? "" : ", not solved"),
                    fmt::format("{:.2g}", record.solve_seconds),
                    fmt::format("{:.2g}", record.evaluation_seconds),
                    fmt::format("{:.2g}", record.made_seconds),
                    fmt::format("{:.0f}", 1e3 * record.gigabytes),
                    fmt::format("{:.1e}", record.error),
                    fmt::format("{:.0e}", record.residual)});
  }
  return markdown_table(rows);
}

report::Chart chart(const std::vector<Run>& runs, const std::string& path) {
  using Point = std::optional<report::Datum>;
  report::Chart chart =
      chart_over_nodes(path, kWays, runs, [](const Run& run) -> Point {
        if (!run.record || !run.record->solved) return std::nullopt;
        return Point(
            {static_cast<double>(run.nodes), run.record->solve_seconds});
      });
  chart.title = "The same program, solved by peers";
  chart.y.label = "processor time of the solve [s]";
  constexpr report::Mark kMarks[] = {report::Mark::Disc, report::Mark::Square,
                                     report::Mark::Triangle,
                                     report::Mark::Diamond};
  const std::vector<std::string> colours =
      report::family_colours(std::size(kMarks));
  for (std::size_t w = 0; w < std::size(kWays); ++w) {
    const auto peer = static_cast<std::size_t>(kWays[w].peer);
    report::Curve& curve = chart.curves[w];
    curve.colour = colours[peer];
    curve.mark = kMarks[peer];
    curve.stroke = kWays[w].formulation == Formulation::RollingTime
                       ? report::Stroke::Solid
                       : report::Stroke::Dashed;
  }
  return chart;
}

}  // namespace brachisto::benchmarks
