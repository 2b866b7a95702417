// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/legend.hpp"

#include "report/key_label.hpp"

namespace brachisto::report {

void draw_heading(Svg& svg, const PlotArea& area, const SweepTable& table,
                  const std::vector<std::size_t>& fixed, const Scenes& scenes) {
  if (fixed.empty() || scenes.empty()) return;
  svg.text({area.left, area.top - 13.0}, "fill=\"#222222\"",
           place(table, fixed, scenes.front(), Markup::Svg));
}

std::string document_title(std::string_view what, const SweepTable& table,
                           const std::vector<std::size_t>& fixed,
                           const Scenes& scenes) {
  if (fixed.empty() || scenes.empty()) return std::string(what);
  return fmt::format("{}: {}", what,
                     place(table, fixed, scenes.front(), Markup::Plain));
}

void define_hatch(Svg& svg, std::string_view id) {
  svg.put(
      "<defs><pattern id=\"{}\" width=\"4.5\" height=\"4.5\" "
      "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
      "<rect width=\"4.5\" height=\"4.5\" fill=\"#ffffff\"/>"
      "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"4.5\" stroke=\"#222222\" "
      "stroke-width=\"2\"/></pattern></defs>\n",
      id);
}

void draw_cross(Svg& svg, Pixel at, std::string_view attributes) {
  constexpr double kArm = 4.0;
  svg.put(
      "<path d=\"M{:.1f},{:.1f}l8,8m0,-8l-8,8\" fill=\"none\" "
      "stroke-width=\"1.6\" {}/>\n",
      at.x - kArm, at.y - kArm, attributes);
}

void draw_ring(Svg& svg, Pixel at, std::string_view attributes) {
  constexpr double kRadius = 6.0;
  svg.circle(at, kRadius,
             fmt::format("{} fill=\"none\" stroke=\"#000000\" "
                         "stroke-width=\"4.5\"",
                         attributes));
  svg.circle(at, kRadius,
             "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"2\"");
}

void draw_edge(Svg& svg, std::string_view path) {
  for (const auto& [colour, width] :
       {std::pair{"#ffffff", 4.0}, std::pair{"#000000", 1.8}}) {
    svg.put(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linecap=\"square\"/>\n",
        path, colour, width);
  }
}

void Legend::entry(std::string_view markup) {
  svg_.text({at_.x + 32.0, at_.y}, "font-size=\"13\" fill=\"#222222\"", markup);
  at_.y += 21.0;
}

void Legend::swatch(std::string_view attributes, std::string_view markup) {
  svg_.rectangle({at_.x + 1.0, at_.y - 11.0}, 20.0, 12.0, attributes);
  entry(markup);
}

void Legend::ring(std::string_view markup) {
  draw_ring(svg_, sign(), "");
  entry(markup);
}

void Legend::cross(std::string_view markup) {
  draw_cross(svg_, sign(), "stroke=\"#111111\"");
  entry(markup);
}

void Legend::dot(std::string_view attributes, std::string_view markup) {
  svg_.circle(sign(), 3.4, attributes);
  entry(markup);
}

void Legend::edge(std::string_view markup) {
  draw_edge(svg_, fmt::format("M{:.1f},{:.1f}h22", at_.x, sign().y));
  entry(markup);
}

void Legend::minimum(const SweepTable& table,
                     const std::vector<std::size_t>& columns,
                     std::size_t scene) {
  const SweepOutcome& outcome = table.outcomes[scene];
  ring(fmt::format(
      "minimum: <tspan font-style=\"italic\">τ</tspan> = {} at "
      "{}{}",
      printed(outcome.tau, 8), place(table, columns, scene, Markup::Svg),
      outcome.feasible ? "" : ", infeasible"));
}

}  // namespace brachisto::report
