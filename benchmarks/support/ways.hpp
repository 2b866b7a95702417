// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Runs of one thing solved in several ways, on meshes of several sizes. A Way
/// has a name, a Run the index `way` of its own.

#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "report/chart.hpp"
#include "support/csv.hpp"

namespace brachisto::benchmarks {

/// The index of the way that a row names.
/// \param path  of the row's file, for the message
/// \throws std::runtime_error if none is called so
template <typename Way, std::size_t size>
[[nodiscard]] int way_of(const CsvRow& row, const Way (&ways)[size],
                         const std::string& path) {
  const Way* const way = std::ranges::find(ways, row.text("way"), &Way::name);
  if (way == std::end(ways)) {
    throw std::runtime_error(path + ": no way to solve is called " +
                             row.text("way"));
  }
  return static_cast<int>(way - ways);
}

/// A chart of processor times over nodes, both logarithmic: one curve for each
/// way, without colours and marks.
/// \param path   of its files, without ending
/// \param point  of a run, std::optional<report::Datum>; none: not drawn
template <typename Way, std::size_t size, typename Run, typename Point>
[[nodiscard]] report::Chart chart_over_nodes(const std::string& path,
                                             const Way (&ways)[size],
                                             const std::vector<Run>& runs,
                                             const Point& point) {
  report::Chart chart;
  chart.name = path.substr(path.find_last_of('/') + 1);
  chart.x.label = "nodes";
  chart.x.scale = report::Scale::Logarithmic;
  chart.y.scale = report::Scale::Logarithmic;
  for (std::size_t w = 0; w < size; ++w) {
    report::Curve& curve = chart.curves.emplace_back();
    curve.id = ways[w].name;
    curve.name = ways[w].name;
    std::ranges::replace(curve.name, '_', ' ');
    for (const Run& run : runs) {
      if (static_cast<std::size_t>(run.way) != w) continue;
      const std::optional<report::Datum> at = point(run);
      if (at) curve.points.push_back(*at);
    }
  }
  return chart;
}

}  // namespace brachisto::benchmarks
