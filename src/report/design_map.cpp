// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/design_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "report/sweep_plots.hpp"

namespace brachisto::report {

namespace {

/// Colours end where a fifth of the bodies is slower, so that they tell quick
/// ones apart.
ValueRange range_of_quick(const SweepTable& table) {
  constexpr double kShare = 0.8;
  std::vector<double> tau;
  for (const SweepOutcome& outcome : table.outcomes) {
    if (std::isfinite(outcome.tau)) tau.push_back(outcome.tau);
  }
  if (tau.empty()) return {0.0, 1.0};
  std::ranges::sort(tau);
  const auto last =
      static_cast<std::size_t>(kShare * static_cast<double>(tau.size() - 1));
  return {tau.front(), std::max(tau[last], tau.front() * (1.0 + 1e-9))};
}

/// The value of a step for a column.
std::optional<double> value_of(const DesignStep& step,
                               const SweepColumn& column) {
  for (const auto& [name, value] : step.values) {
    if (key_of_design(name) == column.key) return value;
  }
  return std::nullopt;
}

}  // namespace

std::string key_of_design(const std::string& name) {
  if (name == "r") return "scene.body.radius";
  return name.starts_with("part_") ? "" : "scene.body." + name;
}

Figure design_map_figure(const SweepTable& table,
                         const std::vector<DesignPath>& paths) {
  SweepMap map{.name = "design_map",
               .first = table.axes[0].columns.front(),
               .second = table.axes[1].columns.front(),
               .n_first = table.axes[0].count,
               .n_second = table.axes[1].count,
               .scenes = Scenes(table.outcomes.size())};
  std::iota(map.scenes.begin(), map.scenes.end(), std::size_t{0});
  if (std::optional<Scenes> ordered = in_map_order(table, map)) {
    map.scenes = *std::move(ordered);
  }
  for (const DesignPath& path : paths) {
    MapWay way;
    for (const DesignStep& step : path) {
      const auto first = value_of(step, table.columns[map.first]);
      const auto second = value_of(step, table.columns[map.second]);
      if (first && second) way.push_back({*first, *second});
    }
    map.ways.push_back(std::move(way));
  }
  return map_figure(table, map, range_of_quick(table));
}

}  // namespace brachisto::report
