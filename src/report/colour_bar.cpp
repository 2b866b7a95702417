// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/colour_bar.hpp"

namespace brachisto::report {

std::string_view ink_on(const Colour& ground) {
  constexpr double kMiddle = 58.0;  // L* of a grey in between
  return lightness(ground) < kMiddle ? "#ffffff" : "#000000";
}

void draw_colour_bar(Svg& svg, const PlotArea& area, ValueRange range,
                     const std::vector<double>& levels, std::string_view id,
                     std::string_view label) {
  constexpr int kStops = 16;  // a multiple of the straight parts of the colours
  svg.put(
      "<defs><linearGradient id=\"{}\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">",
      id);
  for (int i = 0; i <= kStops; ++i) {
    const double share = static_cast<double>(i) / kStops;
    svg.put("<stop offset=\"{:.4g}\" stop-color=\"{}\"/>", share,
            hex(colour_at(share)));
  }
  svg.put("</linearGradient></defs>\n");
  svg.rectangle({area.left, area.top}, area.right - area.left,
                area.bottom - area.top, fmt::format("fill=\"url(#{})\"", id));
  const Axis axis(Scale::Linear, range.low, range.high, area.bottom, area.top);
  for (const double level : levels) {
    const double y = axis(level);
    svg.line({area.left, y}, {area.right, y},
             fmt::format("stroke=\"{}\" stroke-width=\"0.9\"",
                         ink_on(colour_at(range.share(level)))));
    svg.line({area.right, y}, {area.right + 5.0, y},
             "stroke=\"#333333\" stroke-width=\"1\"");
    svg.text({area.right + 9.0, y + 4.5}, "font-size=\"13\" fill=\"#222222\"",
             printed(level));
  }
  draw_frame(svg, area);
  const double x = area.right + 68.0;
  const double middle = 0.5 * (area.top + area.bottom);
  svg.text({x, middle},
           fmt::format(
               "text-anchor=\"middle\" transform=\"rotate(-90 {:.1f} {:.1f})\"",
               x, middle),
           label);
}

}  // namespace brachisto::report
