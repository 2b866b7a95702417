// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/design_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "math/angle.hpp"
#include "report/scale.hpp"
#include "report/sweep_plots.hpp"
#include "report/text_table.hpp"

namespace brachisto::report {

namespace {

/// Colours end where a fifth of the bodies is slower, so that they tell quick
/// ones apart.
Extent range_of_quick(const SweepTable& table) {
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

/// The key of the scene that a number of a design is the value of; empty if it
/// is none, as the place of a part.
std::string key_of_design(const std::string& name) {
  if (name == "r") return "scene.body.radius";
  return name.starts_with("part_") ? "" : "scene.body." + name;
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

namespace {

/// "η_m = 0.77096, θ_m = −11.076°, k = 0".
std::string body_in_words(const NamedNumbers& values) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : values) {
    parts.push_back(name == "theta_m"
                        ? fmt::format("θ_m = {:.6f}°", math::in_degrees(value))
                        : fmt::format("{} = {:.8g}{}",
                                      name == "eta_m" ? "η_m" : name, value,
                                      name == "r" ? " m" : ""));
  }
  return with_minus_signs(fmt::format("{}", fmt::join(parts, ", ")));
}

/// Of one minimum, without the body: "τ = 3.9775616, feasible, from 5
/// searches".
std::string minimum_in_words(const DesignMinimum& minimum) {
  return fmt::format("τ = {:.10g}{}{}{}, from {} search{}", minimum.tau,
                     minimum.stationary ? "" : ", NO MINIMUM",
                     minimum.verified ? "" : ", NOT VERIFIED",
                     minimum.feasible ? ", feasible" : ", INFEASIBLE",
                     minimum.found_from, minimum.found_from == 1 ? "" : "es");
}

/// "θ_m = −30°: dτ/d(bound) = 0.2 per rad".
std::string bound_in_words(const BoundOfDesign& held) {
  return with_minus_signs(
      held.name == "theta_m"
          ? fmt::format("θ_m = {:.6g}°: dτ/d(bound) = {:.6g} per rad",
                        math::in_degrees(held.bound), held.multiplier)
          : fmt::format("{} = {:.6g}: dτ/d(bound) = {:.6g}", held.name,
                        held.bound, held.multiplier));
}

/// Searches that led nowhere, the first few with the reason.
void add_lost(std::string& out, const std::vector<LostSearch>& lost) {
  constexpr std::size_t kShown = 5;
  std::string_view label = "lost";
  for (const auto& [search, reason] :
       std::span(lost).first(std::min(lost.size(), kShown))) {
    add_line(out, label, fmt::format("search {}: {}", search, reason));
    label = "";
  }
  if (lost.size() > kShown) {
    add_line(out, "", fmt::format("and {} more", lost.size() - kShown));
  }
}

}  // namespace

void add_design(std::string& out, const DesignAnswer& design) {
  if (design.best) {
    add_line(out, design.stopped ? "quickest so far" : "quickest found",
             fmt::format("{}, of {} searches",
                         body_in_words(design.best->values), design.searches));
    for (const BoundOfDesign& held : design.best->bounds_active) {
      add_line(out, "", "at its bound " + bound_in_words(held));
    }
  } else if (!design.minima.empty()) {
    add_line(out, "quickest found", "none; why, the remarks on the minima say");
  }
  std::string_view label = "minima";
  for (const DesignMinimum& minimum : design.minima) {
    add_line(out, label,
             fmt::format("{}: {}", minimum_in_words(minimum),
                         body_in_words(minimum.values)));
    label = "";
    for (const std::string& why : minimum.remarks)
      add_line(out, "", "  " + why);
  }
  add_line(
      out, "searched",
      fmt::format("{} searches from {} bodies, of which {} led nowhere; {} "
                  "closed solutions, {:.2f} s CPU",
                  design.searches, design.starts, design.lost.size(),
                  design.solves, design.cpu_seconds));
  add_lost(out, design.lost);
}

}  // namespace brachisto::report
