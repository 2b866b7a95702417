// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/chart.hpp"
#include "report/key_label.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"
#include "report/sweep_plots.hpp"

namespace brachisto::report {

namespace {

/// Fills that differ in grey too.
constexpr std::array kFills{"#4477aa", "#eeb04a", "#bbccee",
                            "#aa5577", "#88bb88", "#555555"};
constexpr std::size_t kMostKinks = 12;

/// What tells one structure from another: the limits of the arcs, one after
/// the other, and whether the last one reaches B.
struct Structure {
  std::vector<std::string> limits;
  bool to_B = false;

  explicit Structure(const std::vector<SweepArc>& arcs) {
    constexpr double kNear = 1e-9;  // shares of the time
    for (const SweepArc& arc : arcs) {
      limits.push_back(arc.limit);
      to_B = arc.to > 1.0 - kNear;
    }
  }
  friend bool operator==(const Structure&, const Structure&) = default;
};

bool overlap(const SweepArc& a, const SweepArc& b) {
  return a.limit == b.limit && a.from <= b.to && b.from <= a.to;
}

/// Arcs without one in `others` that they go on in.
std::vector<SweepArc> missing_from(const std::vector<SweepArc>& others,
                                   const std::vector<SweepArc>& arcs) {
  std::vector<SweepArc> missing;
  std::ranges::copy_if(
      arcs, std::back_inserter(missing), [&](const SweepArc& arc) {
        return std::ranges::none_of(
            others, [&](const SweepArc& other) { return overlap(arc, other); });
      });
  return missing;
}

/// "friction at 0.57 ends": what changes from one scene to the next, places in
/// shares of the time.
std::string change_in_words(const std::vector<SweepArc>& before,
                            const std::vector<SweepArc>& after) {
  std::vector<std::string> changes;
  const auto tell = [&](const std::vector<SweepArc>& arcs, const char* what) {
    for (const SweepArc& arc : arcs) {
      changes.push_back(fmt::format("{} at {:.2f} {}", arc.limit,
                                    0.5 * (arc.from + arc.to), what));
    }
  };
  tell(missing_from(after, before), "ends");
  tell(missing_from(before, after), "begins");
  if (changes.empty() && before.size() != after.size()) {
    changes.push_back(before.size() < after.size() ? "one arc becomes two"
                                                   : "two arcs become one");
  }
  const bool at_B = Structure(before).to_B;
  if (changes.empty() && at_B != Structure(after).to_B && !before.empty()) {
    changes.push_back(fmt::format("{} {} B", before.back().limit,
                                  at_B ? "leaves" : "reaches"));
  }
  if (changes.empty()) changes.emplace_back("other arcs");
  return fmt::format("{}", fmt::join(changes, ", "));
}

class StructurePlot {
 public:
  StructurePlot(const SweepTable& table, const XyPlot& plot, std::size_t curve)
      : table_(table),
        column_(table.columns[plot.x_column]),
        scenes_(sorted_by(column_, plot.curves[curve])) {
    constexpr std::size_t kLetters = 60;
    const KeyLabel label = key_label(column_.key).within(kLetters);
    symbol_ = label.text(Markup::Rich, false);
    chart_.name = plot.curves.size() == 1
                      ? fmt::format("{}-limits", plot.name)
                      : fmt::format("{}-limits-{}", plot.name, curve + 1);
    chart_.title = "Where limits hold against " + symbol_;
    chart_.subtitle = what_is_fixed(table, scenes_);
    if (plot.family && !scenes_.empty()) {
      const std::string family =
          place(table, {*plot.family}, scenes_.front(), Markup::Rich);
      if (chart_.subtitle.find(family) == std::string::npos) {
        chart_.subtitle = family + ", " + chart_.subtitle;
      }
    }
    chart_.x.label = label.in_full(Markup::Rich, true);
    told_ = fmt::format("Where limits hold along the path, against {}",
                        label.text(Markup::Html, false));
    chart_.x.scale = scale_of(column_, scenes_);
    chart_.y.label = "share of the transit time";
    chart_.y.low = 0.0;
    chart_.y.high = 1.0;
  }

  /// Whether there is anything to draw.
  [[nodiscard]] bool any() const {
    return column_.numeric() &&
           std::ranges::any_of(scenes_, [&](std::size_t scene) {
             return !arcs(scene).empty();
           });
  }

  [[nodiscard]] Chart chart() {
    if (scenes_.size() > 1) {
      chart_.x.low = shown(0);
      chart_.x.high = shown(scenes_.size() - 1);
    }
    for (std::size_t i = 0; i < scenes_.size();) i = add_bands(i);
    add_kinks();
    add_failed();
    return std::move(chart_);
  }

  /// What the chart shows, HTML.
  [[nodiscard]] std::string caption() const { return told_ + "."; }

 private:
  [[nodiscard]] const std::vector<SweepArc>& arcs(std::size_t scene) const {
    return table_.outcomes[scene].arcs;
  }
  [[nodiscard]] bool verified(std::size_t i) const {
    return table_.outcomes[scenes_[i]].state == SweepOutcome::State::Verified;
  }
  [[nodiscard]] double shown(std::size_t i) const {
    return shown_number(column_, scenes_[i]);
  }
  /// Half-way between a scene and the next one, as the axis is laid out.
  [[nodiscard]] double behind(std::size_t i) const {
    const double a = shown(i), b = shown(i + 1);
    return chart_.x.scale == Scale::Logarithmic ? std::sqrt(a * b)
                                                : 0.5 * (a + b);
  }
  /// Whether the next scene has the same arcs.
  [[nodiscard]] bool goes_on(std::size_t i) const {
    return i + 1 < scenes_.size() && verified(i) && verified(i + 1) &&
           Structure(arcs(scenes_[i])) == Structure(arcs(scenes_[i + 1]));
  }

  /// The bands of scene i and all that have the same arcs; the one behind.
  std::size_t add_bands(std::size_t first) {
    std::size_t last = first;
    while (goes_on(last)) ++last;
    if (!verified(first)) return last + 1;
    const double left = first > 0 ? behind(first - 1) : shown(first);
    const double right = last + 1 < scenes_.size() ? behind(last) : shown(last);
    for (std::size_t arc = 0; arc < arcs(scenes_[first]).size(); ++arc) {
      const auto of = [&](std::size_t i) -> const SweepArc& {
        return arcs(scenes_[i])[arc];
      };
      Area band{.outline = {{left, of(first).from}}};
      for (std::size_t i = first; i <= last; ++i) {
        band.outline.push_back({shown(i), of(i).from});
      }
      band.outline.push_back({right, of(last).from});
      band.outline.push_back({right, of(last).to});
      for (std::size_t i = last + 1; i-- > first;) {
        band.outline.push_back({shown(i), of(i).to});
      }
      band.outline.push_back({left, of(first).to});
      const std::string& limit = of(first).limit;
      const auto [known, is_new] = fills_.try_emplace(limit, fills_.size());
      if (is_new) band.name = limit;
      band.fill = kFills.at(known->second % kFills.size());
      chart_.areas.push_back(std::move(band));
    }
    return last + 1;
  }

  /// Where neighbours have other arcs.
  void add_kinks() {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < scenes_.size(); ++i) {
      if (!verified(i) || !verified(i + 1) || goes_on(i)) continue;
      const double x = behind(i);
      Curve line{.points = {{x, 0.0}, {x, 1.0}},
                 .stroke = Stroke::Dashed,
                 .width = 1.2,
                 .id = fmt::format("kink {}", ++count)};
      if (count == 1) line.name = "between scenes with other arcs";
      if (count <= kMostKinks) {
        told_ +=
            fmt::format("{} {} … {}, {}", count == 1 ? ". Arcs change at" : ";",
                        printed(shown(i), 4), printed(shown(i + 1), 4),
                        xml_escaped(change_in_words(arcs(scenes_[i]),
                                                    arcs(scenes_[i + 1]))));
      } else if (count == kMostKinks + 1) {
        told_ += "; and more";
      }
      chart_.curves.push_back(std::move(line));
    }
  }

  void add_failed() {
    Curve failed{.width = 0.0,
                 .mark = Mark::Cross,
                 .mark_size = scenes_.size() > 60 ? 0.6 : 1.0,
                 .id = "failed"};
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      if (table_.outcomes[scenes_[i]].state == SweepOutcome::State::Failed) {
        failed.points.push_back({shown(i), 0.0});
      }
    }
    if (failed.points.empty()) return;
    failed.name = fmt::format("no verified result ({})", failed.points.size());
    chart_.curves.push_back(std::move(failed));
  }

  const SweepTable& table_;
  const SweepColumn& column_;
  Scenes scenes_;
  std::string symbol_;
  std::string told_;
  std::map<std::string, std::size_t> fills_;  ///< by limit
  Chart chart_;
};

}  // namespace

std::optional<SweepDrawing> structure_drawing(const SweepTable& table,
                                              const XyPlot& plot,
                                              std::size_t curve) {
  StructurePlot structure(table, plot, curve);
  if (!structure.any()) return std::nullopt;
  Figure figure = chart_figure(structure.chart());
  return SweepDrawing{std::move(figure), structure.caption()};
}

}  // namespace brachisto::report
