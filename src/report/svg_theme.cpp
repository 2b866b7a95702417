// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/svg_theme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>

#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr double kOfChannel = 255.0;
constexpr double kFlare = 0.05;  // of the screen, in WCAG's contrast
constexpr Colour kWhite{kOfChannel, kOfChannel, kOfChannel};

/// A channel of sRGB as light, and back (IEC 61966-2-1).
double light(double channel) {
  const double c = channel / kOfChannel;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double channel(double light) {
  return kOfChannel * (light <= 0.0031308
                           ? 12.92 * light
                           : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
}

/// "#rrggbb", "black", "rgb(  1,  2,  3)".
std::optional<Colour> colour_of(const std::string& text) {
  if (text == "black") return Colour{0.0, 0.0, 0.0};
  std::array<unsigned, 3> c{};
  const bool known =
      std::sscanf(text.c_str(), "#%2x%2x%2x", &c[0], &c[1], &c[2]) == 3 ||
      std::sscanf(text.c_str(), "rgb(%u,%u,%u)", &c[0], &c[1], &c[2]) == 3;
  if (!known) return std::nullopt;
  return Colour{1.0 * c[0], 1.0 * c[1], 1.0 * c[2]};
}

/// Attributes as they stand, `color="black"`, of lines or of words.
std::set<std::string> coloured(std::string_view svg, bool lines) {
  std::set<std::string> found;
  // What is filled has a space before its sign of equality.
  const std::string_view names[] = {"fill=", "stroke=", "color="};
  for (const std::string_view name : names) {
    if (!lines && name == "stroke=") continue;
    for (std::size_t at = svg.find(name); at != std::string_view::npos;
         at = svg.find(name, at + 1)) {
      if (svg[at - 1] != ' ') continue;
      const char quote = svg[at + name.size()];
      const std::size_t end = svg.find(quote, at + name.size() + 1);
      const std::string text(svg.substr(at, end + 1 - at));
      // Of words, frames and marks.
      const bool of_line =
          (name == "fill=" && quote != '"') || text.ends_with("FFFFFF\"");
      if (!lines && of_line) continue;
      found.insert(text);
    }
  }
  return found;
}

}  // namespace

double relative_luminance(const Colour& colour) {
  return 0.2126 * light(colour[0]) + 0.7152 * light(colour[1]) +
         0.0722 * light(colour[2]);
}

double contrast(const Colour& one, const Colour& other) {
  const auto [low, high] =
      std::minmax({relative_luminance(one), relative_luminance(other)});
  return (high + kFlare) / (low + kFlare);
}

Colour on_dark_ground(const Colour& colour) {
  if (colour == kWhite) return kDarkGround;
  const double before = relative_luminance(colour);
  constexpr double kLeast = 3.0;  // WCAG's of what has to be seen
  const bool grey = colour[0] == colour[1] && colour[1] == colour[2];
  const double wanted = std::max(contrast(colour, kWhite), grey ? 1.0 : kLeast);
  const double after = std::min(
      1.0, wanted * (relative_luminance(kDarkGround) + kFlare) - kFlare);
  Colour out{};
  // Light is mixed with white, or dimmed: luminance is linear in it.
  const double white = after < before ? 0.0 : (after - before) / (1.0 - before);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double own = light(colour[i]);
    out[i] = std::round(channel(after < before ? own * after / before
                                               : own + white * (1.0 - own)));
  }
  return out;
}

std::string with_theme(std::string svg) {
  constexpr std::string_view kCanvas = "<g id=\"gnuplot_canvas\">";
  const std::size_t at = svg.find(kCanvas);
  if (at == std::string::npos) return svg;
  const std::string_view drawing = std::string_view(svg).substr(at);
  // A map of colours is made of very many areas of colours of their own.
  constexpr std::size_t kAreasOfMap = 300;
  std::size_t areas = 0;
  for (std::size_t area = drawing.find("fill = "); area < drawing.size();
       area = drawing.find("fill = ", area + 1)) {
    ++areas;
  }
  std::string rules;
  for (const std::string& attribute : coloured(drawing, areas < kAreasOfMap)) {
    const std::size_t sign = attribute.find('=');
    const std::string name = attribute.substr(0, sign);
    const auto colour =
        colour_of(attribute.substr(sign + 2, attribute.size() - sign - 3));
    if (!colour) continue;
    const bool ground = *colour == kWhite;
    const std::string dark = hex(on_dark_ground(*colour));
    fmt::format_to(std::back_inserter(rules),
                   "#gnuplot_canvas [{}] {{ {}: {}; }}\n", attribute, name,
                   ground ? fmt::format("var(--paper, {})", dark) : dark);
  }
  svg.insert(at,
             fmt::format("<style>\n@media screen and (prefers-color-scheme: "
                         "dark) {{\n#gnuplot_canvas feFlood {{ flood-color: "
                         "var(--paper, {}); }}\n{}}}\n</style>\n",
                         hex(kDarkGround), rules));
  // Spaces of words are kept.
  return replaced(svg, "<text>", "<text xml:space=\"preserve\">");
}

}  // namespace brachisto::report
