// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "comparison/finding.hpp"
#include "comparison/looks.hpp"
#include "comparison/pictures.hpp"
#include "comparison/statistics.hpp"
#include "report/chart.hpp"
#include "report/rich_text.hpp"
#include "report/track_kind.hpp"

namespace brachisto::comparison {

std::string in_words(const Subject& subject) {
  const Scene& scene = subject.problem.scene;
  std::string text = report::in_words(scene);
  if (subject.limited()) {
    text += fmt::format("; {}: {}", report::track_kind(scene),
                        report::limits_in_words(scene));
  }
  return text;
}

std::vector<Picture> pictures_of(const MethodComparison& made) {
  constexpr double kRoom = 4.0;  // factors at the sides, for names
  constexpr double kBar = 0.9;   // of a range of times [px]
  if (!made.reference) return {};
  report::Chart chart;
  chart.name = "compare";
  chart.title = "Processor time against error, method by method";
  chart.subtitle = in_words(made.subject);
  chart.x.label = "relative error of τ";
  chart.y.label = "processor time [s]";
  chart.x.scale = chart.y.scale = report::Scale::Logarithmic;
  chart.notes_apart = true;
  report::Extent xs, ys;
  for (const ComparisonRow& row : made.rows) {
    if (!row.error || row.run.cpu.empty()) continue;
    const Look look = look_of(row.method, 1, 0);
    const Spread times = spread_of(row.run.cpu);
    const double x = std::max({*row.error, made.reference->error,
                               std::numeric_limits<double>::epsilon()});
    const std::string name = report::as_rich_text(row.label);
    chart.curves.push_back({.name = {},
                            .points = {{x, times.least}, {x, times.greatest}},
                            .colour = look.colour,
                            .width = kBar,
                            .id = row.label + " spread"});
    chart.curves.push_back({.name = {},
                            .points = {{x, times.median}},
                            .colour = look.colour,
                            .width = 0.0,
                            .mark = look.mark,
                            .mark_size = 1.0,
                            .id = row.label});
    chart.notes.push_back(
        {.at = {x, times.median}, .text = name, .mark = report::Mark::None});
    xs.include(x);
    ys.include(times.least);
    ys.include(times.greatest);
  }
  if (chart.curves.empty()) return {};
  xs.include(kSpokenError);
  chart.x.low = xs.low / kRoom;
  chart.x.high = xs.high * kRoom;
  chart.y.low = ys.low / kRoom;
  chart.y.high = ys.high * kRoom;
  chart.curves.push_back(line_of_spoken_error(*chart.y.low, *chart.y.high));
  if (made.reference->error > *chart.x.low) {
    chart.areas.push_back({.name = "error of the reference",
                           .outline = {{*chart.x.low, *chart.y.low},
                                       {made.reference->error, *chart.y.low},
                                       {made.reference->error, *chart.y.high},
                                       {*chart.x.low, *chart.y.high}},
                           .fill = "#d9e6f2"});
  }
  return {
      {report::chart_figure(chart),
       fmt::format("Each mark is a method, those with a mesh on {} nodes; "
                   "the nearer to the lower left, the better.",
                   made.options.nodes) +
           (made.subject.limited()
                ? " The extremal method begins on the arcs that the program "
                  "found, whose time is part of its own."
                : "")}};
}

}  // namespace brachisto::comparison
