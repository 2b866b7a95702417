// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/chart_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr std::array<double, 2> kDashed{5.0, 3.0};
constexpr std::array<double, 2> kDotted{1.2, 2.2};
constexpr std::array<double, 4> kDashDotted{6.5, 2.5, 1.2, 2.5};

}  // namespace

std::span<const double> dashes(Stroke stroke) {
  switch (stroke) {
    case Stroke::Solid:
      break;
    case Stroke::Dashed:
      return kDashed;
    case Stroke::Dotted:
      return kDotted;
    case Stroke::DashDotted:
      return kDashDotted;
  }
  return {};
}

std::string line_style(const Curve& curve) {
  std::string style = fmt::format(
      "fill=\"none\" stroke=\"{}\" stroke-width=\"{:.3g}\" "
      "stroke-linejoin=\"round\"",
      xml_escaped(curve.colour), curve.width);
  const std::span<const double> pattern = dashes(curve.stroke);
  if (pattern.empty()) return style + " stroke-linecap=\"round\"";
  std::string lengths;
  for (const double part : pattern) {
    lengths +=
        fmt::format("{}{:.3g}", lengths.empty() ? "" : " ", part * curve.width);
  }
  return style + fmt::format(" stroke-dasharray=\"{}\"", lengths);
}

void draw_mark(Svg& svg, Pixel at, Mark mark, std::string_view colour) {
  const std::string ink = xml_escaped(colour);
  const std::string filled = fmt::format("class=\"mark\" fill=\"{}\"", ink);
  const std::string open = fmt::format(
      "class=\"mark\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.4\"",
      ink);
  const auto moved = [&](double x, double y) {
    return Pixel{at.x + x, at.y + y};
  };
  switch (mark) {
    case Mark::None:
      return;
    case Mark::Disc:
      return svg.circle(at, 3.8, filled);
    case Mark::Circle:
      return svg.circle(at, 3.6, open);
    case Mark::Square:
      return svg.polygon({moved(-3.5, -3.5), moved(3.5, -3.5), moved(3.5, 3.5),
                          moved(-3.5, 3.5)},
                         filled);
    case Mark::Triangle:
      return svg.polygon({moved(0.0, -5.0), moved(4.5, 3.0), moved(-4.5, 3.0)},
                         filled);
    case Mark::Diamond:
      return svg.polygon({moved(0.0, -4.9), moved(4.9, 0.0), moved(0.0, 4.9),
                          moved(-4.9, 0.0)},
                         open);
    case Mark::Cross:
      svg.put(
          "<path class=\"mark\" d=\"M{:.2f},{:.2f}l7,7m0,-7l-7,7\" "
          "stroke=\"{}\" stroke-width=\"1.6\" fill=\"none\"/>\n",
          at.x - 3.5, at.y - 3.5, ink);
      return;
  }
}

double mass_radius(const Sketch& sketch) {
  return std::max(2.4, 0.15 * sketch.radius);
}

WordsPlace beside(const Sketch& sketch, Pixel at, double right) {
  constexpr double kGap = 7.0, kSize = 13.0, kHalfHeight = 4.5;
  const double distance = sketch.radius + kGap;
  const double width = width_of(letters(plain_words(sketch.name)), kSize);
  const bool ends = at.x + distance + width > right;
  return {{ends ? at.x - distance : at.x + distance, at.y + kHalfHeight}, ends};
}

std::vector<std::string> family_colours(std::size_t n) {
  constexpr double kLightest = 0.75;  // lighter ones would be lost on white
  constexpr double kAlone = 0.4;
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < n; ++i) {
    const double share =
        n == 1 ? kAlone : static_cast<double>(i) / static_cast<double>(n - 1);
    colours.push_back(hex(colour_at(kLightest * share)));
  }
  return colours;
}

}  // namespace brachisto::report
