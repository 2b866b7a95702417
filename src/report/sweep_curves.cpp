// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "report/chart.hpp"
#include "report/key_label.hpp"
#include "report/letters.hpp"
#include "report/sweep_plots.hpp"
#include "report/text_table.hpp"

namespace brachisto::report {

namespace {

using State = SweepOutcome::State;

constexpr std::size_t kMany = 60;  // scenes of a curve, or a tenth of a cloud
constexpr std::size_t kLabelLetters = 60;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Where the scenes lie along the axis.
class Places {
 public:
  Places(const SweepColumn& column, const Scenes& scenes) : column_(column) {
    const KeyLabel label = key_label(column.key).within(kLabelLetters);
    side_.label = label.in_full(Markup::Rich, true);
    if (column.numeric()) {
      side_.scale = scale_of(column, scenes);
    } else {
      side_.words = distinct_words(column, scenes);
      side_.low = -0.6;
      side_.high = static_cast<double>(side_.words.size()) - 0.4;
    }
  }

  [[nodiscard]] const Side& side() const { return side_; }
  [[nodiscard]] double operator()(std::size_t scene) const {
    if (column_.numeric()) return shown_number(column_, scene);
    const auto word = std::ranges::find(side_.words, column_.words[scene]);
    // Multiples of the golden ratio fill the room of a word evenly.
    constexpr double kRoom = 0.5, kGoldenRatio = 0.6180339887498949;
    const double turns = static_cast<double>(scene) * kGoldenRatio;
    return static_cast<double>(word - side_.words.begin()) +
           kRoom * (turns - std::floor(turns) - 0.5);
  }
  /// Where the scale puts a scene, for straight lines.
  [[nodiscard]] double laid_out(std::size_t scene) const {
    const double x = (*this)(scene);
    return side_.scale == Scale::Logarithmic ? std::log(x) : x;
  }

 private:
  const SweepColumn& column_;
  Side side_;
};

/// A plot being put together.
class Plot {
 public:
  Plot(const SweepTable& table, const XyPlot& plot, Extent range)
      : table_(table),
        plot_(plot),
        scenes_(together(plot.curves)),
        x_(table.columns[plot.x_column], scenes_),
        range_(range) {}

  [[nodiscard]] Chart chart() {
    const double margin = 0.07 * range_.width();
    chart_.name = plot_.name;
    chart_.title = "τ against " + key_label(table_.columns[plot_.x_column].key)
                                      .within(kLabelLetters)
                                      .text(Markup::Rich, false);
    chart_.subtitle = what_is_fixed(table_, scenes_);
    chart_.x = x_.side();
    chart_.y.label = kTauLabel;
    chart_.y.low = range_.low - margin;
    chart_.y.high = range_.high + margin;
    const std::vector<std::string> colours =
        family_colours(plot_.curves.size());
    for (std::size_t c = 0; c < plot_.curves.size(); ++c) {
      add_curve(c, colours[c]);
    }
    add_states();
    add_scenes();
    for (MarkedScene& marked : marked_scenes(table_, scenes_)) {
      chart_.curves.push_back(
          {.name = std::move(marked.name),
           .points = {{x_(marked.scene), table_.outcomes[marked.scene].tau}},
           .width = 0.0,
           .mark = marked.feasible ? Mark::Diamond : Mark::Triangle,
           .mark_size = 1.8,
           .id = marked.feasible ? "minimum" : "infeasible minimum"});
    }
    return std::move(chart_);
  }

 private:
  static Scenes together(const std::vector<Scenes>& curves) {
    Scenes all;
    for (const Scenes& scenes : curves) {
      all.insert(all.end(), scenes.begin(), scenes.end());
    }
    return all;
  }
  [[nodiscard]] bool has(std::size_t scene, State state) const {
    return table_.outcomes[scene].state == state;
  }
  [[nodiscard]] double tau(std::size_t scene) const {
    return table_.outcomes[scene].tau;
  }

  /// How far τ lies from the line between its neighbours, four times as far as
  /// a line to either of them from a parabola; NaN without two of them.
  [[nodiscard]] double stray(const Scenes& scenes, std::size_t i) const {
    if (i == 0 || i + 1 >= scenes.size()) return kNone;
    const double before = x_.laid_out(scenes[i - 1]);
    const double share = (x_.laid_out(scenes[i]) - before) /
                         (x_.laid_out(scenes[i + 1]) - before);
    return std::abs(tau(scenes[i]) -
                    std::lerp(tau(scenes[i - 1]), tau(scenes[i + 1]), share));
  }

  /// Whether a line from scene i to the next one shows what is there.
  [[nodiscard]] bool resolved(const Scenes& scenes, std::size_t i) const {
    constexpr double kMost = 4.0 * 0.02;
    const double most = kMost * range_.width();
    const double here = stray(scenes, i), next = stray(scenes, i + 1);
    return (here <= most || next <= most) && !(here > most) && !(next > most);
  }

  void add_curve(std::size_t index, const std::string& colour) {
    const Scenes& scenes = plot_.curves[index];
    Curve curve{.name = plot_.family && !scenes.empty()
                            ? place(table_, {*plot_.family}, scenes.front(),
                                    Markup::Rich)
                            : "",
                .stroke = stroke_of(index),
                .colour = colour,
                .mark = Mark::Disc};
    constexpr std::size_t kManyDots = 10 * kMany;
    curve.mark_size = scenes.size() > kManyDots ? 0.25 : 0.5;
    if (!plot_.joined) curve.width = 0.0;
    bool whole = plot_.joined;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (!has(scenes[i], State::Verified)) {
        whole = false;
        continue;
      }
      curve.points.push_back({x_(scenes[i]), tau(scenes[i])});
      if (!plot_.joined || i + 1 == scenes.size() || resolved(scenes, i)) {
        continue;
      }
      whole = false;
      curve.points.push_back({kNone, kNone});
    }
    // A line says it all; on dashes many dots would hide them.
    if (whole && scenes.size() > kMany) curve.mark = Mark::None;
    chart_.curves.push_back(std::move(curve));
  }

  void add_states() {
    Curve infeasible{.width = 0.0,
                     .mark = Mark::Circle,
                     .mark_size = scenes_.size() > kMany ? 0.9 : 1.2,
                     .id = "infeasible"};
    Curve failed = infeasible;
    failed.mark = Mark::Cross;
    failed.id = "failed";
    for (const std::size_t scene : scenes_) {
      if (has(scene, State::Failed)) {
        failed.points.push_back({x_(scene), *chart_.y.low});
      } else if (has(scene, State::Verified) &&
                 !table_.outcomes[scene].feasible) {
        infeasible.points.push_back({x_(scene), tau(scene)});
      }
    }
    const auto add = [&](Curve& curve, std::string_view what) {
      if (curve.points.empty()) return;
      curve.name = fmt::format("{} ({})", what, curve.points.size());
      chart_.curves.push_back(std::move(curve));
    };
    add(infeasible, "infeasible: the body could not follow the track");
    add(failed, "no verified result");
  }

  /// What has no τ lies at the bottom, where the crosses are.
  void add_scenes() {
    for (const std::size_t scene : scenes_) {
      const bool drawn = has(scene, State::Verified);
      chart_.scenes.push_back(
          {scene, {x_(scene), drawn ? tau(scene) : *chart_.y.low}});
    }
    const std::size_t first = plot_.curves.front().size();
    const bool alike = std::ranges::all_of(
        plot_.curves, [&](const Scenes& one) { return one.size() == first; });
    if (plot_.joined && alike) chart_.scenes_per_curve = first;
  }

  const SweepTable& table_;
  const XyPlot& plot_;
  Scenes scenes_;
  Places x_;
  Extent range_;
  Chart chart_;
};

}  // namespace

std::vector<MarkedScene> marked_scenes(const SweepTable& table,
                                       const Scenes& scenes) {
  constexpr std::size_t kLetters = 88;  // that fit beside a mark
  constexpr double kFinest = 1e-7;      // error that is told, relative
  const SweepDigest found = digest(table, scenes);
  const bool sample = std::ranges::any_of(
      table.axes, [](const SweepAxis& axis) { return !axis.ordered; });
  const std::string least =
      fmt::format("minimum of the {}", sample ? "sample" : "grid");
  std::vector<MarkedScene> out;
  const auto mark = [&](std::optional<std::size_t> scene, bool feasible,
                        const std::string& what) {
    if (!scene) return;
    const std::string where =
        place(table, columns_that_vary(table, scenes), *scene, Markup::Rich);
    const double tau = table.outcomes[*scene].tau;
    const double error =
        std::max(table.outcomes[*scene].estimated_error, kFinest) * tau;
    out.push_back(
        {*scene,
         shortened(fmt::format("{}: τ = {}{}{}", what, within_error(tau, error),
                               where.empty() ? "" : " at ", where),
                   kLetters),
         feasible});
  };
  mark(found.fastest_feasible, true,
       least + (found.infeasible > 0 ? ", feasible" : ""));
  mark(
      found.faster_infeasible, false,
      found.fastest_feasible ? "less, but infeasible" : least + ", infeasible");
  return out;
}

Figure xy_figure(const SweepTable& table, const XyPlot& plot, Extent range) {
  return chart_figure(Plot(table, plot, range).chart());
}

}  // namespace brachisto::report
