// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/xy_plot_svg.hpp"

#include <algorithm>

#include "report/chart.hpp"
#include "report/key_axis.hpp"
#include "report/key_label.hpp"
#include "report/legend.hpp"
#include "report/letters.hpp"

namespace brachisto::report {

namespace {

using State = SweepOutcome::State;

constexpr double kWidth = 720.0;
constexpr PlotArea kArea{80.0, 690.0, 40.0, 400.0};
constexpr double kLabelSize = 13.0;  // of the labels at the curves
constexpr double kLeader = 22.0;     // from a curve to its label
constexpr double kLeastLabels = 108.0, kMostLabels = 210.0;
constexpr std::size_t kLettersOfValue = 13;
constexpr double kBetweenCrosses = 11.0;

/// A plot being drawn, layer by layer.
class Drawing {
 public:
  Drawing(const SweepTable& table, const XyPlot& plot, ValueRange range)
      : table_(table),
        plot_(plot),
        area_(area_of(table, plot)),
        scenes_(together(plot.curves)),
        digest_(digest(table, scenes_)),
        x_(table.columns[plot.x_column], scenes_, area_),
        tau_(make_axis(range)),
        legend_(svg_, {area_.left, area_.bottom + x_.depth(area_) + 26.0},
                kWidth - 8.0) {}

  void frame();
  void curve(const Scenes& scenes, const std::string& colour);
  void crosses(const Scenes& scenes, std::size_t row, std::string_view colour);
  void labels(const std::vector<std::string>& colours);
  void minima();
  void legend();
  [[nodiscard]] std::string document() const;

 private:
  static PlotArea area_of(const SweepTable& table, const XyPlot& plot);
  static Scenes together(const std::vector<Scenes>& curves) {
    Scenes all;
    for (const Scenes& scenes : curves) {
      all.insert(all.end(), scenes.begin(), scenes.end());
    }
    return all;
  }
  static Axis make_axis(ValueRange range) {
    const double margin = 0.07 * (range.high - range.low);
    return {Scale::Linear, range.low - margin, range.high + margin,
            kArea.bottom, kArea.top};
  }
  [[nodiscard]] bool has(std::size_t scene, State state) const {
    return table_.outcomes[scene].state == state;
  }
  [[nodiscard]] Pixel at(std::size_t scene) const {
    return {x_(scene), tau_(table_.outcomes[scene].tau)};
  }
  void lines(const Scenes& scenes, std::string_view colour);

  const SweepTable& table_;
  const XyPlot& plot_;
  PlotArea area_;
  Scenes scenes_;
  SweepDigest digest_;
  KeyAxis x_;
  Axis tau_;
  Svg svg_;
  Legend legend_;
  double top_ = 0.0;
};

/// Leaves room at the right for the labels of a family.
PlotArea Drawing::area_of(const SweepTable& table, const XyPlot& plot) {
  PlotArea area = kArea;
  if (!plot.family) return area;
  const SweepColumn& column = table.columns[*plot.family];
  std::size_t longest =
      letters(key_label(column.key).text(Markup::Plain, false));
  for (const Scenes& scenes : plot.curves) {
    if (scenes.empty()) continue;
    const std::string value = shown_value(column, scenes.front());
    longest = std::max(longest, std::min(kLettersOfValue, letters(value)));
  }
  area.right =
      kWidth - kLeader -
      std::clamp(width_of(longest, kLabelSize), kLeastLabels, kMostLabels);
  return area;
}

void Drawing::frame() {
  if (digest_.verified > 0) {
    for (const double value : tau_.ticks(7)) {
      svg_.line({area_.left, tau_(value)}, {area_.right, tau_(value)},
                "stroke=\"#e6e6e6\" stroke-width=\"1\"");
    }
    draw_y_axis(svg_, area_, tau_, tau_label_svg());
  }
  draw_frame(svg_, area_);
  x_.draw(svg_, area_);
  top_ = draw_heading(svg_, area_, table_, plot_.fixed, scenes_);
}

void Drawing::lines(const Scenes& scenes, std::string_view colour) {
  std::vector<Pixel> run;
  const auto end_run = [&] {
    if (run.size() > 1) {
      svg_.polyline(run, fmt::format("class=\"curve\" fill=\"none\" "
                                     "stroke=\"{}\" stroke-width=\"1.7\" "
                                     "stroke-linejoin=\"round\"",
                                     colour));
    }
    run.clear();
  };
  for (const std::size_t scene : scenes) {
    if (has(scene, State::Verified)) {
      run.push_back(at(scene));
    } else {
      end_run();
    }
  }
  end_run();
}

void Drawing::curve(const Scenes& scenes, const std::string& colour) {
  constexpr std::size_t kMany = 300;
  constexpr std::size_t kManyOnACurve = 60;
  if (plot_.joined) lines(scenes, colour);
  const bool many = scenes.size() > (plot_.joined ? kManyOnACurve : kMany);
  const double width = many ? 3.6 : 6.0;
  // Lines of no length with round ends are dots in few letters.
  std::string feasible, infeasible;
  for (const std::size_t scene : scenes) {
    if (!has(scene, State::Verified)) continue;
    const Pixel p = at(scene);
    (table_.outcomes[scene].feasible ? feasible : infeasible) +=
        fmt::format("M{:.1f},{:.1f}h0", p.x, p.y);
  }
  const auto dots = [&](const std::string& data, std::string_view ink,
                        double size) {
    if (data.empty()) return;
    svg_.put(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
        "stroke-linecap=\"round\"/>\n",
        data, ink, size);
  };
  dots(feasible, colour, width);
  dots(infeasible, colour, width + 0.8);
  dots(infeasible, "#ffffff", width - 1.6);
}

void Drawing::crosses(const Scenes& scenes, std::size_t row,
                      std::string_view colour) {
  for (const std::size_t scene : scenes) {
    if (!has(scene, State::Failed)) continue;
    const double y = area_.bottom - kBetweenCrosses * static_cast<double>(row);
    draw_cross(svg_, {x_(scene), y},
               fmt::format("class=\"failed\" stroke=\"{}\"", colour));
  }
}

/// Values of the family at the right, each beside the end of its curve or as
/// near as the others allow.
void Drawing::labels(const std::vector<std::string>& colours) {
  constexpr double kLine = 17.0;
  struct Label {
    std::size_t curve;
    Pixel end;
    double y;
  };
  std::vector<Label> found;
  for (std::size_t c = 0; c < plot_.curves.size(); ++c) {
    const Scenes& scenes = plot_.curves[c];
    const auto last = std::find_if(
        scenes.rbegin(), scenes.rend(),
        [&](std::size_t scene) { return has(scene, State::Verified); });
    if (last != scenes.rend()) found.push_back({c, at(*last), at(*last).y});
  }
  std::sort(found.begin(), found.end(),
            [](const Label& a, const Label& b) { return a.y < b.y; });
  // Down until each has its line, then up from the bottom of the plot.
  double free = area_.top + kLine;
  for (Label& label : found) {
    label.y = std::max(label.y, free);
    free = label.y + kLine;
  }
  free = area_.bottom - 4.0;
  for (auto label = found.rbegin(); label != found.rend(); ++label) {
    label->y = std::min(label->y, free);
    free = label->y - kLine;
  }
  const SweepColumn& column = table_.columns[*plot_.family];
  for (const Label& label : found) {
    const std::string& colour = colours[label.curve];
    svg_.polyline({label.end,
                   {area_.right + 4.0, label.end.y},
                   {area_.right + kLeader - 3.0, label.y}},
                  fmt::format("fill=\"none\" stroke=\"{}\" "
                              "stroke-width=\"0.8\" stroke-dasharray=\"2 2\"",
                              colour));
    const std::size_t scene = plot_.curves[label.curve].front();
    svg_.text(
        {area_.right + kLeader, label.y + 4.5},
        fmt::format("font-size=\"13\" fill=\"{}\"", colour),
        xml_escaped(shortened(shown_value(column, scene), kLettersOfValue)));
  }
  svg_.text({area_.right + kLeader, area_.top}, "font-size=\"13\"",
            key_label(column.key)
                .within(letters_within(kMostLabels, kLabelSize))
                .text(Markup::Svg, false));
}

void Drawing::minima() {
  draw_minima(svg_, digest_, [&](std::size_t scene) { return at(scene); });
  legend_.minima(table_, scenes_);
}

void Drawing::legend() {
  if (digest_.infeasible > 0) {
    legend_.dot(
        "fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"1.2\"",
        fmt::format("infeasible: the body could not follow the track ({})",
                    digest_.infeasible));
  }
  if (digest_.failed > 0) {
    legend_.cross(fmt::format("no verified result ({})", digest_.failed));
  }
}

std::string Drawing::document() const {
  const KeyLabel x = key_label(table_.columns[plot_.x_column].key);
  return svg_.document(
      kWidth, legend_.bottom() + 2.0,
      document_title("τ against " + x.text(Markup::Plain, false), table_,
                     plot_.fixed, scenes_),
      top_);
}

}  // namespace

std::string xy_plot_svg(const SweepTable& table, const XyPlot& plot,
                        ValueRange range) {
  const std::vector<std::string> colours = family_colours(plot.curves.size());
  Drawing drawing(table, plot, range);
  drawing.frame();
  std::size_t row = 0;
  for (std::size_t c = 0; c < plot.curves.size(); ++c) {
    drawing.curve(plot.curves[c], colours[c]);
    drawing.crosses(plot.curves[c], row, plot.family ? colours[c] : "#111111");
    row += digest(table, plot.curves[c]).failed > 0;
  }
  if (plot.family) drawing.labels(colours);
  drawing.minima();
  drawing.legend();
  return drawing.document();
}

}  // namespace brachisto::report
