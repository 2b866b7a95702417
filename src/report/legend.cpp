// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/legend.hpp"

#include <algorithm>
#include <cmath>

#include "report/key_label.hpp"
#include "report/letters.hpp"

namespace brachisto::report {

namespace {

constexpr double kIndent = 32.0;    // of what a sign means
constexpr double kFontSize = 13.0;  // of the legend

}  // namespace

double draw_heading(Svg& svg, const PlotArea& area, const SweepTable& table,
                    const std::vector<std::size_t>& fixed,
                    const Scenes& scenes) {
  constexpr double kHeadingSize = 14.0;  // that of the document
  constexpr double kLine = 19.0;
  if (fixed.empty() || scenes.empty()) return 0.0;
  const std::vector<std::string> lines =
      place_lines(table, fixed, scenes.front(), Markup::Svg,
                  letters_within(area.right - area.left, kHeadingSize));
  double y = area.top - 13.0 - kLine * static_cast<double>(lines.size() - 1);
  const double top = std::min(0.0, y - kLine);
  for (const std::string& line : lines) {
    svg.text({area.left, y}, "fill=\"#222222\"", line);
    y += kLine;
  }
  return top;
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

void draw_ring(Svg& svg, Pixel at, bool filled, std::string_view attributes) {
  constexpr double kRadius = 6.0;
  svg.circle(at, kRadius,
             fmt::format("{} fill=\"{}\" stroke=\"#000000\" "
                         "stroke-width=\"4.5\"",
                         attributes, filled ? "#000000" : "none"));
  svg.circle(at, kRadius,
             "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"2\"");
}

void draw_minima(Svg& svg, const SweepDigest& found,
                 const std::function<Pixel(std::size_t)>& place) {
  const auto draw = [&](std::optional<std::size_t> scene, bool feasible) {
    if (!scene) return;
    const Pixel at = place(*scene);
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;
    draw_ring(svg, at, feasible,
              feasible ? "class=\"minimum\"" : "class=\"infeasible-minimum\"");
  };
  draw(found.faster_infeasible, false);
  draw(found.fastest_feasible, true);
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
  svg_.text({at_.x + kIndent, at_.y},
            fmt::format("font-size=\"{}\" fill=\"#222222\"", kFontSize),
            markup);
  at_.y += 21.0;
}

void Legend::swatch(std::string_view attributes, std::string_view markup) {
  svg_.rectangle({at_.x + 1.0, at_.y - 11.0}, 20.0, 12.0, attributes);
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
                     const std::vector<std::size_t>& columns, std::size_t scene,
                     const std::string& what) {
  const std::string tau = printed(table.outcomes[scene].tau, 8);
  std::string line =
      fmt::format("{}: <tspan font-style=\"italic\">τ</tspan> = {}", what, tau);
  if (columns.empty()) return entry(line);
  const std::size_t taken = letters(what + ": τ = " + tau + " at ");
  line += " at ";
  for (const std::string& part : place_lines(
           table, columns, scene, Markup::Svg,
           letters_within(right_ - at_.x - kIndent, kFontSize), taken)) {
    entry(line + part);
    line.clear();
  }
}

void Legend::minima(const SweepTable& table, const Scenes& scenes) {
  const SweepDigest found = digest(table, scenes);
  const std::vector<std::size_t> columns = columns_that_vary(table, scenes);
  if (found.fastest_feasible) {
    draw_ring(svg_, sign(), true);
    minimum(table, columns, *found.fastest_feasible,
            found.infeasible > 0 ? "minimum, feasible" : "minimum");
  }
  if (found.faster_infeasible) {
    draw_ring(svg_, sign(), false);
    minimum(table, columns, *found.faster_infeasible,
            found.fastest_feasible ? "faster, but infeasible"
                                   : "minimum, infeasible");
  }
}

}  // namespace brachisto::report
