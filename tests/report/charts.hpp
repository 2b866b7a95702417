// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Charts to draw, and what is found in the drawings.

#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/svg.hpp"

namespace brachisto::testing {

/// y = y(x) at `n` places evenly from `from` to `to`.
template <class Function>
report::Curve sampled(const std::string& name, double from, double to, int n,
                      Function y) {
  report::Curve curve;
  curve.name = name;
  for (int i = 0; i < n; ++i) {
    const double x = std::lerp(from, to, i / (n - 1.0));
    curve.points.push_back({x, y(x)});
  }
  return curve;
}

/// One of everything, with names that have to be escaped.
inline report::Chart chart_of_everything() {
  using namespace report;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Chart chart;
  chart.name = "all";
  chart.title = "Everything < all & \"more\"";
  chart.x.label = "η_m <1>";
  chart.y.label = "k & 'more'";
  chart.equal_scale = chart.y_down = true;
  chart.areas = {{"area, of \"k\" > 0", {{0, 0}, {1, 0}, {1, 1}}, "#e8e8e8"}};
  chart.curves = {{"a, \"b\" & 'c' {d} @e ~f \\g", {{0, 0}, {1, 1}, {2, 0}}},
                  {"η_m", {{0, 0.1}, {kNone, 1}, {1, 0.5}, {2, 0.7}}},
                  {"η_m", {{0, 0.2}, {2, 0.2}}},
                  {"", {{0, 0.3}, {2, 0.3}}}};
  chart.curves[1].stroke = Stroke::DashDotted;
  chart.curves[1].mark = Mark::Diamond;
  chart.curves[2].width = 0.0;
  chart.curves[2].mark = Mark::Cross;
  chart.rounds = {{{1.0, 0.5}, 0.3, Datum{1.1, 0.4}}};
  chart.sketches = {{{0.5, 0.5}, 20.0, {{0.5, 0.5}}, {1.0}, "a <ring>"}};
  chart.notes = {{{1.5, 0.5}, "note & 'τ'", Mark::Disc, -8.0, -8.0}};
  return chart;
}

/// Numbers after each `name="` in elements that contain `part`.
inline std::vector<double> numbers_of(const std::string& svg,
                                      const std::string& part,
                                      const std::string& name) {
  std::vector<double> numbers;
  for (std::size_t at = svg.find(part); at != std::string::npos;
       at = svg.find(part, at + 1)) {
    const std::size_t begin = svg.rfind('<', at);
    const std::string element = svg.substr(begin, svg.find('>', at) - begin);
    const std::size_t value = element.find(" " + name + "=\"");
    if (value == std::string::npos) continue;
    numbers.push_back(std::stod(element.substr(value + name.size() + 3)));
  }
  return numbers;
}

/// Points of the polylines of class "curve", one list per line.
inline std::vector<std::vector<report::Pixel>> drawn_lines(
    const std::string& svg) {
  std::vector<std::vector<report::Pixel>> lines;
  const std::string begin = "<polyline class=\"curve\"";
  for (std::size_t at = svg.find(begin); at != std::string::npos;
       at = svg.find(begin, at + 1)) {
    const std::string name = "points=\"";
    const std::size_t first = svg.find(name, at) + name.size();
    std::istringstream in(svg.substr(first, svg.find('"', first) - first));
    std::vector<report::Pixel> line;
    report::Pixel p{};
    char comma = ' ';
    while (in >> p.x >> comma >> p.y) line.push_back(p);
    lines.push_back(line);
  }
  return lines;
}

/// The frame, which is the rectangle without filling.
struct DrawnFrame {
  double left, right, top, bottom;
};
inline DrawnFrame drawn_frame(const std::string& svg) {
  const std::string part = "fill=\"none\" stroke=\"#333333\"";
  const double x = numbers_of(svg, part, "x").at(0);
  const double y = numbers_of(svg, part, "y").at(0);
  return {x, x + numbers_of(svg, part, "width").at(0), y,
          y + numbers_of(svg, part, "height").at(0)};
}

}  // namespace brachisto::testing
