// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "report/key_label.hpp"
#include "report/sweep_plots.hpp"

namespace brachisto::report {

namespace {

constexpr std::size_t kMostFigures = 12;
constexpr std::size_t kMostScenes = 100'000;  // of a figure
constexpr std::size_t kMostCurves = 8;

/// An axis to draw along and the column that gives its values.
struct Direction {
  std::size_t axis, column;
};

/// τ of these scenes; a little around it if they are all the same.
Extent tau_range(const SweepTable& table, const Scenes& scenes) {
  const SweepDigest found = digest(table, scenes);
  if (!found.fastest) return {0.0, 1.0};
  const double low = table.outcomes[*found.fastest].tau;
  const double high = table.outcomes[*found.slowest].tau;
  constexpr double kSame = 1e-9;  // below it nothing but noise would be drawn
  if (high - low > kSame * high) return {low, high};
  return {low - 0.01 * high, high + 0.01 * high};
}

/// One range of τ for all figures, which then can be compared, unless half of
/// them would show next to nothing of their own.
std::vector<Extent> ranges(const SweepTable& table,
                           const std::vector<Scenes>& figures) {
  constexpr double kLeastShare = 0.35;
  const Extent all = tau_range(table, all_scenes(table));
  std::vector<Extent> own;
  std::size_t lost = 0;
  for (const Scenes& scenes : figures) {
    own.push_back(tau_range(table, scenes));
    lost += own.back().width() < kLeastShare * all.width();
  }
  if (2 * lost > figures.size()) return own;
  return std::vector<Extent>(figures.size(), all);
}

/// Ordered axes of more than one value, numeric or not, as asked for. Of the
/// numeric columns of an axis the first that tells all its values apart, or
/// just the first.
std::vector<Direction> directions(const SweepTable& table, bool numeric) {
  std::vector<Direction> found;
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    const SweepAxis& axis = table.axes[a];
    if (axis.count < 2 || !axis.ordered) continue;
    const auto is_numeric = [&](std::size_t c) {
      return table.columns[c].numeric();
    };
    auto number = std::ranges::find_if(axis.columns, is_numeric);
    const bool has_number = number != axis.columns.end();
    const Scenes first = scenes_along(table, {a}).front();
    const auto telling = std::ranges::find_if(axis.columns, [&](std::size_t c) {
      return is_numeric(c) && distinct(table.columns[c], first);
    });
    if (telling != axis.columns.end()) number = telling;
    if (numeric && has_number) found.push_back({a, *number});
    if (!numeric && !has_number && !axis.columns.empty()) {
      found.push_back({a, axis.columns.front()});
    }
  }
  return found;
}

/// Makes the figures of one sweep.
class Planner {
 public:
  explicit Planner(const SweepTable& table)
      : table_(table), varying_(columns_that_vary(table, all_scenes(table))) {}

  [[nodiscard]] SweepFigures figures() {
    const std::vector<Direction> numeric = directions(table_, true);
    const bool sample = std::ranges::any_of(
        table_.axes,
        [](const SweepAxis& axis) { return !axis.ordered && axis.count > 1; });
    if (sample || numeric.empty()) {
      dots();
    } else if (numeric.size() > 1) {
      maps(numeric[numeric.size() - 2], numeric.back());
    } else {
      std::optional<Direction> family;
      for (const Direction& words : directions(table_, false)) {
        if (table_.axes[words.axis].count <= kMostCurves) family = words;
      }
      curves(numeric.front(), family);
    }
    return std::move(out_);
  }

 private:
  /// Figures of these scenes, still without drawings.
  void start(const std::vector<Scenes>& groups, std::string_view kind) {
    if (groups.empty()) return;
    if (groups.front().size() > kMostScenes) {
      out_.remarks.emplace_back("The sweep has too many scenes to be drawn.");
      return;
    }
    const std::vector<Extent> tau = ranges(table_, groups);
    const std::size_t drawn = std::min(groups.size(), kMostFigures);
    if (groups.size() > 1) {
      const bool same = tau.front().low == tau.back().low &&
                        tau.front().high == tau.back().high;
      out_.remarks.emplace_back(
          same ? "All figures have the same range of <i>τ</i>."
               : "Each figure has its own range of <i>τ</i>.");
    }
    leave_out(groups.size() - drawn);
    for (std::size_t f = 0; f < drawn; ++f) {
      SweepFigure& figure = out_.figures.emplace_back();
      figure.name = fmt::format("{}-{}", kind, f + 1);
      figure.scenes = groups[f];
      figure.tau = tau[f];
      const auto same = columns_that_vary(table_, groups[f], false);
      std::set_intersection(same.begin(), same.end(), varying_.begin(),
                            varying_.end(), std::back_inserter(figure.fixed));
    }
  }

  void leave_out(std::size_t count) {
    if (count == 0) return;
    out_.remarks.push_back(
        fmt::format("{} more figures are left out; their numbers are in the "
                    "table of all scenes.",
                    count));
  }

  void maps(Direction x, Direction y) {
    const std::size_t nx = table_.axes[x.axis].count;
    const std::size_t ny = table_.axes[y.axis].count;
    const Direction along = ny >= nx ? y : x;  // if it becomes curves
    const Direction across = ny >= nx ? x : y;
    start(scenes_along(table_, {x.axis, y.axis}), "map");
    for (SweepFigure& figure : out_.figures) {
      SweepMap map{.name = figure.name,
                   .first = x.column,
                   .second = y.column,
                   .n_first = nx,
                   .n_second = ny,
                   .scenes = figure.scenes};
      const std::optional<Scenes> ordered = in_map_order(table_, map);
      if (ordered) {
        map.scenes = *ordered;
        map_drawings(figure, map);
      }
      auto plot = clear_curve_plot(figure, along, across);
      if (!plot && !ordered) plot = clear_curve_plot(figure, across, along);
      if (plot) {
        plot->name = figure.name + "-curves";
        curve_drawing(figure, *plot);
      }
      if (figure.drawings.empty()) dot_drawings(figure, {x.column, y.column});
    }
  }

  void curves(Direction x, std::optional<Direction> family) {
    std::vector<std::size_t> inner{x.axis};
    if (family) inner.push_back(family->axis);
    start(scenes_along(table_, inner), "curve");
    for (SweepFigure& figure : out_.figures) {
      curve_drawing(figure, curve_plot(figure, x, family));
    }
  }

  void dots() {
    if (varying_.empty()) return;
    start({all_scenes(table_)}, "sample");
    if (out_.figures.empty()) return;
    std::vector<std::size_t> drawn = varying_;
    drawn.resize(std::min(varying_.size(), kMostFigures));
    leave_out(varying_.size() - drawn.size());
    SweepFigure& figure = out_.figures.front();
    if (drawn.size() == 2 && table_.columns[drawn[0]].numeric() &&
        table_.columns[drawn[1]].numeric()) {
      figure.drawings.push_back(
          {scatter_figure(table_,
                          {.name = figure.name,
                           .first = drawn[0],
                           .second = drawn[1],
                           .scenes = figure.scenes},
                          figure.tau),
           fmt::format("<i>τ</i> over {} and {}.", label(drawn[0]),
                       label(drawn[1]))});
    }
    dot_drawings(figure, drawn);
  }

  void map_drawings(SweepFigure& figure, const SweepMap& map) const {
    figure.drawings.push_back(
        {map_figure(table_, map, figure.tau),
         fmt::format("<i>τ</i> over {} and {}.", label(map.first),
                     label(map.second))});
    if (digest(table_, map.scenes).infeasible == 0) return;
    SweepMap feasibility = map;
    feasibility.name += "-feasibility";
    figure.drawings.push_back({feasibility_figure(table_, feasibility),
                               "The scenes whose body would lift off or come "
                               "to a fold of its path."});
  }

  void curve_drawing(SweepFigure& figure, const XyPlot& plot) const {
    std::string caption =
        fmt::format("<i>τ</i> against {}", label(plot.x_column));
    if (plot.family) {
      caption += fmt::format(" for each {}", label(*plot.family));
    }
    figure.drawings.push_back(
        {xy_figure(table_, plot, figure.tau), caption + "."});
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
      if (auto structure = structure_drawing(table_, plot, c)) {
        figure.drawings.push_back(std::move(*structure));
      }
    }
  }

  void dot_drawings(SweepFigure& figure,
                    const std::vector<std::size_t>& columns) const {
    for (std::size_t d = 0; d < columns.size(); ++d) {
      XyPlot plot;
      plot.name = fmt::format("{}-{}", figure.name, d + 1);
      plot.x_column = columns[d];
      plot.curves = {figure.scenes};
      plot.joined = false;
      figure.drawings.push_back(
          {xy_figure(table_, plot, figure.tau),
           fmt::format("<i>τ</i> against {}, whatever the other keys are.",
                       label(columns[d]))});
    }
  }

  /// τ over one axis for each value of another, both ascending; joined if no
  /// value of the first is there twice.
  [[nodiscard]] XyPlot curve_plot(const SweepFigure& figure, Direction x,
                                  std::optional<Direction> family) const {
    XyPlot plot;
    plot.name = figure.name;
    plot.x_column = x.column;
    plot.curves.resize(family ? table_.axes[family->axis].count : 1);
    for (const std::size_t scene : figure.scenes) {
      plot.curves[family ? index_along(table_, family->axis, scene) : 0]
          .push_back(scene);
    }
    for (Scenes& scenes : plot.curves) {
      scenes = sorted_by(table_.columns[x.column], std::move(scenes));
      plot.joined = plot.joined && distinct(table_.columns[x.column], scenes);
    }
    if (!family) return plot;
    plot.family = family->column;
    // By what tells them apart.
    Scenes first;
    for (const Scenes& scenes : plot.curves) first.push_back(scenes.front());
    std::vector<Scenes> curves;
    for (const std::size_t scene :
         sorted_by(table_.columns[family->column], first)) {
      const auto at = std::ranges::find(first, scene);
      curves.push_back(
          plot.curves[static_cast<std::size_t>(at - first.begin())]);
    }
    plot.curves = std::move(curves);
    return plot;
  }

  /// The same if the curves are few, can be joined, and have one value each.
  [[nodiscard]] std::optional<XyPlot> clear_curve_plot(
      const SweepFigure& figure, Direction x, Direction family) const {
    if (table_.axes[family.axis].count > kMostCurves) return std::nullopt;
    XyPlot plot = curve_plot(figure, x, family);
    const bool told =
        std::ranges::all_of(plot.curves, [&](const Scenes& scenes) {
          const auto varying = columns_that_vary(table_, scenes);
          return !std::ranges::binary_search(varying, family.column);
        });
    if (!told || !plot.joined) return std::nullopt;
    return plot;
  }

  [[nodiscard]] std::string label(std::size_t column) const {
    return key_label(table_.columns[column].key).text(Markup::Html, false);
  }

  const SweepTable& table_;
  std::vector<std::size_t> varying_;
  SweepFigures out_;
};

}  // namespace

SweepFigures sweep_figures(const SweepTable& table) {
  return Planner(table).figures();
}

}  // namespace brachisto::report
