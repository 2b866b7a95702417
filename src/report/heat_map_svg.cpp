// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/heat_map_svg.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "report/colour_bar.hpp"
#include "report/contour_labels.hpp"
#include "report/contours.hpp"
#include "report/key_label.hpp"
#include "report/legend.hpp"
#include "report/map_geometry.hpp"

namespace brachisto::report {

namespace {

using State = SweepOutcome::State;

constexpr double kWidth = 720.0;
constexpr PlotArea kArea{80.0, 590.0, 40.0, 430.0};
constexpr PlotArea kColourBar{612.0, 630.0, kArea.top, kArea.bottom};
constexpr int kLevels = 12;
constexpr std::string_view kFeasible = "#e3e8ee";
constexpr std::string_view kInfeasible = "#68788a";
constexpr std::string_view kMissing =
    "class=\"missing\" fill=\"#ffffff\" stroke=\"#c4c4c4\" "
    "stroke-width=\"0.6\"";

/// A map being drawn, layer by layer.
class Drawing {
 public:
  Drawing(const SweepTable& table, const SweepMap& map)
      : table_(table),
        map_(map),
        digest_(digest(table, map.scenes)),
        geometry_(map_geometry(table, map, kArea)),
        hatch_(map.name + "-hatch") {
    define_hatch(svg_, hatch_);
  }

  [[nodiscard]] const SweepDigest& found() const { return digest_; }
  void cells(const std::function<std::string(const SweepOutcome&)>& colour);
  void contours(ValueRange range, const std::vector<double>& levels);
  void edge_of_infeasible();
  void minima();
  void colour_bar(ValueRange range, const std::vector<double>& levels);
  void frame();
  [[nodiscard]] Legend& legend() { return legend_; }
  void legend_of_states();
  [[nodiscard]] std::string document(std::string_view what) const;

 private:
  [[nodiscard]] const SweepOutcome& outcome(std::size_t i,
                                            std::size_t j) const {
    return table_.outcomes[map_.scenes[geometry_.lattice.at(i, j)]];
  }
  [[nodiscard]] std::string path(std::size_t i, std::size_t j) const;
  [[nodiscard]] std::vector<std::pair<Pixel, Pixel>> edges_of_infeasible()
      const;
  [[nodiscard]] Pixel place_of(std::size_t scene) const;

  const SweepTable& table_;
  const SweepMap& map_;
  SweepDigest digest_;
  MapGeometry geometry_;
  std::string hatch_;
  Svg svg_;
  Legend legend_{svg_, {kArea.left, kArea.bottom + 68.0}, kWidth - 8.0};
  double top_ = 0.0;
};

/// Outline of a cell as path data; empty where the cell has no place.
std::string Drawing::path(std::size_t i, std::size_t j) const {
  std::string data;
  for (const Pixel& p : geometry_.cells.outline(i, j)) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
    data += fmt::format("{}{:.1f},{:.1f}", data.empty() ? "M" : "L", p.x, p.y);
  }
  return data + "Z";
}

void Drawing::cells(
    const std::function<std::string(const SweepOutcome&)>& colour) {
  std::map<std::string, std::string> verified;  // path data by colour
  std::string others;
  for (std::size_t i = 0; i < map_.nx; ++i) {
    for (std::size_t j = 0; j < map_.ny; ++j) {
      const std::string data = path(i, j);
      if (data.empty()) continue;
      switch (outcome(i, j).state) {
        case State::Verified:
          verified[colour(outcome(i, j))] += data;
          break;
        case State::Failed:
          others += fmt::format(
              "<path class=\"failed\" d=\"{}\" fill=\"url(#{})\" "
              "stroke=\"#222222\" stroke-width=\"0.6\"/>\n",
              data, hatch_);
          break;
        case State::Missing:
          others += fmt::format("<path d=\"{}\" {}/>\n", data, kMissing);
          break;
      }
    }
  }
  // The stroke closes the hairlines that viewers leave between neighbours.
  for (const auto& [fill, data] : verified) {
    svg_.put(
        "<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"0.7\"/>\n",
        data, fill, fill);
  }
  svg_.put("{}", others);
}

void Drawing::contours(ValueRange range, const std::vector<double>& levels) {
  LabelPlaces places(kArea);
  constexpr double kFromRing = 40.0;
  constexpr double kFromEdge = 24.0;
  constexpr double kFromHole = 26.0;
  for (std::size_t node = 0; node < map_.scenes.size(); ++node) {
    if (table_.outcomes[map_.scenes[node]].state != State::Verified) {
      places.avoid(geometry_.lattice.nodes[node], kFromHole);
    }
  }
  for (const auto& scene :
       {digest_.fastest_feasible, digest_.faster_infeasible}) {
    if (scene) places.avoid(place_of(*scene), kFromRing);
  }
  for (const auto& [a, b] : edges_of_infeasible()) {
    places.avoid({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, kFromEdge);
  }
  std::string labels;
  begin_clip(svg_, kArea, map_.name + "-frame");
  for (const double level : levels) {
    const Colour ground = colour_at(range.share(level));
    const std::string_view ink = ink_on(ground);
    const std::string text = printed(level);
    for (const auto& line : contour_lines(geometry_.lattice, level)) {
      svg_.polyline(line,
                    fmt::format("class=\"contour\" fill=\"none\" stroke=\"{}\" "
                                "stroke-width=\"0.9\" stroke-opacity=\"0.8\" "
                                "stroke-linejoin=\"round\"",
                                ink));
      const auto label = places.find(line);
      if (!label) continue;
      // A rim in the colour of the level interrupts the line.
      labels += fmt::format(
          "<text transform=\"translate({:.1f} {:.1f}) rotate({:.1f})\" "
          "text-anchor=\"middle\" dy=\"4\" font-size=\"11.5\" fill=\"{}\" "
          "stroke=\"{}\" stroke-width=\"7\" stroke-linejoin=\"round\" "
          "paint-order=\"stroke\">{}</text>\n",
          label->at.x, label->at.y, label->angle, ink, hex(ground), text);
    }
  }
  end_clip(svg_);
  svg_.put("{}", labels);
}

/// The edges between feasible and infeasible scenes.
std::vector<std::pair<Pixel, Pixel>> Drawing::edges_of_infeasible() const {
  std::vector<std::pair<Pixel, Pixel>> edges;
  const auto differ = [&](const SweepOutcome& a, const SweepOutcome& b) {
    return a.state == State::Verified && b.state == State::Verified &&
           a.feasible != b.feasible;
  };
  const Cells& cells = geometry_.cells;
  for (std::size_t i = 0; i < map_.nx; ++i) {
    for (std::size_t j = 0; j < map_.ny; ++j) {
      if (path(i, j).empty()) continue;
      const Pixel corner = cells.corner(i, j);
      if (i > 0 && differ(outcome(i - 1, j), outcome(i, j))) {
        edges.emplace_back(corner, cells.corner(i, j + 1));
      }
      if (j > 0 && differ(outcome(i, j - 1), outcome(i, j))) {
        edges.emplace_back(corner, cells.corner(i + 1, j));
      }
    }
  }
  return edges;
}

void Drawing::edge_of_infeasible() {
  std::string data;
  for (const auto& [a, b] : edges_of_infeasible()) {
    data += fmt::format("M{:.1f},{:.1f}L{:.1f},{:.1f}", a.x, a.y, b.x, b.y);
  }
  if (!data.empty()) draw_edge(svg_, data);
}

Pixel Drawing::place_of(std::size_t scene) const {
  const auto node = std::find(map_.scenes.begin(), map_.scenes.end(), scene) -
                    map_.scenes.begin();
  return geometry_.lattice.nodes[static_cast<std::size_t>(node)];
}

void Drawing::minima() {
  draw_minima(svg_, digest_,
              [&](std::size_t scene) { return place_of(scene); });
  legend_.minima(table_, map_.scenes);
}

void Drawing::colour_bar(ValueRange range, const std::vector<double>& levels) {
  draw_colour_bar(svg_, kColourBar, range, levels, map_.name + "-colours",
                  tau_label_svg());
}

void Drawing::frame() {
  draw_frame(svg_, kArea);
  const auto label = [&](std::size_t column, std::size_t letters) {
    return key_label(table_.columns[column].key)
        .within(letters)
        .text(Markup::Svg, true);
  };
  draw_x_axis(svg_, kArea, geometry_.x,
              label(map_.x_column, letters_of_x_label(kArea)));
  draw_y_axis(svg_, kArea, geometry_.y,
              label(map_.y_column, letters_of_y_label(kArea)));
  top_ = draw_heading(svg_, kArea, table_, map_.fixed, map_.scenes);
}

void Drawing::legend_of_states() {
  if (digest_.failed > 0) {
    legend_.swatch(fmt::format("fill=\"url(#{})\" stroke=\"#222222\" "
                               "stroke-width=\"0.6\"",
                               hatch_),
                   fmt::format("no verified result ({})", digest_.failed));
  }
  if (digest_.missing > 0) {
    legend_.swatch("fill=\"#ffffff\" stroke=\"#c4c4c4\"",
                   fmt::format("not run yet ({})", digest_.missing));
  }
}

std::string Drawing::document(std::string_view what) const {
  return svg_.document(kWidth, legend_.bottom() + 2.0,
                       document_title(what, table_, map_.fixed, map_.scenes),
                       top_);
}

}  // namespace

std::string heat_map_svg(const SweepTable& table, const SweepMap& map,
                         ValueRange range) {
  Drawing drawing(table, map);
  const SweepDigest& found = drawing.found();
  const bool any = found.verified > 0;
  const std::vector<double> levels =
      any ? round_values(range.low, range.high, kLevels)
          : std::vector<double>{};
  drawing.cells([&](const SweepOutcome& outcome) {
    return hex(colour_at(range.share(outcome.tau)));
  });
  drawing.edge_of_infeasible();
  drawing.contours(range, levels);
  drawing.minima();
  drawing.frame();
  if (any) drawing.colour_bar(range, levels);
  if (found.infeasible > 0) {
    drawing.legend().edge(
        fmt::format("edge of infeasible scenes ({})", found.infeasible));
  }
  drawing.legend_of_states();
  return drawing.document("Map of τ");
}

std::string feasibility_map_svg(const SweepTable& table, const SweepMap& map) {
  Drawing drawing(table, map);
  drawing.cells([](const SweepOutcome& outcome) {
    return std::string(outcome.feasible ? kFeasible : kInfeasible);
  });
  drawing.edge_of_infeasible();
  drawing.frame();
  const SweepDigest& found = drawing.found();
  const auto entry = [&](std::string_view fill, std::string_view what,
                         std::size_t count) {
    drawing.legend().swatch(fmt::format("fill=\"{}\" stroke=\"#333333\"", fill),
                            fmt::format("{} ({})", what, count));
  };
  entry(kFeasible, "feasible", found.verified - found.infeasible);
  entry(kInfeasible, "infeasible: the body could not follow the track",
        found.infeasible);
  drawing.legend_of_states();
  return drawing.document("Map of feasibility");
}

}  // namespace brachisto::report
