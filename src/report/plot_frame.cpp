// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/plot_frame.hpp"

#include <algorithm>
#include <cmath>

#include "report/letters.hpp"

namespace brachisto::report {

namespace {

constexpr double kTick = 5.0;
constexpr double kLabelSize = 14.0;   // that of the document
constexpr std::size_t kLetters = 14;  // of a category
constexpr std::string_view kThin = "stroke=\"#333333\" stroke-width=\"1\"";
constexpr std::string_view kBelow =
    "text-anchor=\"middle\" font-size=\"13\" fill=\"#222222\"";
constexpr std::string_view kBeside =
    "text-anchor=\"end\" font-size=\"13\" fill=\"#222222\"";

/// Longest word as it is written.
std::size_t longest(const std::vector<std::string>& words) {
  std::size_t found = 0;
  for (const std::string& word : words) {
    found = std::max(found, std::min(kLetters, letters(word)));
  }
  return found;
}

/// Width that each word has [px].
double room(const PlotArea& area, const std::vector<std::string>& words) {
  return (area.right - area.left) / static_cast<double>(words.size());
}

bool slanted(const PlotArea& area, const std::vector<std::string>& words) {
  constexpr double kLetterWidth = 8.0;
  return kLetterWidth * static_cast<double>(longest(words)) > room(area, words);
}

}  // namespace

void draw_frame(Svg& svg, const PlotArea& area) {
  svg.rectangle({area.left, area.top}, area.right - area.left,
                area.bottom - area.top,
                "fill=\"none\" stroke=\"#333333\" stroke-width=\"1\"");
}

void begin_clip(Svg& svg, const PlotArea& area, std::string_view id) {
  svg.put("<defs><clipPath id=\"{}\">", id);
  svg.rectangle({area.left, area.top}, area.right - area.left,
                area.bottom - area.top, "");
  svg.put("</clipPath></defs>\n<g clip-path=\"url(#{})\">\n", id);
}

void end_clip(Svg& svg) {
  svg.put("</g>\n");
}

std::size_t letters_of_x_label(const PlotArea& area) {
  return letters_within(area.right - area.left, kLabelSize);
}

std::size_t letters_of_y_label(const PlotArea& area) {
  return letters_within(area.bottom - area.top, kLabelSize);
}

void draw_x_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 std::string_view label) {
  for (const double value : axis.ticks(7)) {
    const double x = axis(value);
    svg.line({x, area.bottom}, {x, area.bottom + kTick}, kThin);
    svg.text({x, area.bottom + 19.0}, kBelow, printed(value));
  }
  svg.text({0.5 * (area.left + area.right), area.bottom + kAxisDepth},
           "text-anchor=\"middle\"", label);
}

void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 std::string_view label) {
  for (const double value : axis.ticks(7)) {
    const double y = axis(value);
    svg.line({area.left - kTick, y}, {area.left, y}, kThin);
    svg.text({area.left - kTick - 4.0, y + 4.5}, kBeside, printed(value));
  }
  const double middle = 0.5 * (area.top + area.bottom);
  svg.text(
      {18.0, middle},
      fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {:.1f})\"",
                  middle),
      label);
}

void draw_categories(Svg& svg, const PlotArea& area, const Axis& axis,
                     const std::vector<std::string>& words,
                     std::string_view label) {
  // Slanted words still need a line of their own each.
  const auto every = static_cast<std::size_t>(
      std::max(1.0, std::ceil(16.0 / room(area, words))));
  for (std::size_t i = 0; i < words.size(); i += every) {
    const double x = axis(static_cast<double>(i));
    const std::string word = xml_escaped(shortened(words[i], kLetters));
    svg.line({x, area.bottom}, {x, area.bottom + kTick}, kThin);
    if (slanted(area, words)) {
      const Pixel at{x + 4.0, area.bottom + 14.0};
      svg.text(at,
               fmt::format("text-anchor=\"end\" font-size=\"12\" "
                           "fill=\"#222222\" "
                           "transform=\"rotate(-40 {:.1f} {:.1f})\"",
                           at.x, at.y),
               word);
    } else {
      svg.text({x, area.bottom + 19.0}, kBelow, word);
    }
  }
  svg.text({0.5 * (area.left + area.right),
            area.bottom + categories_depth(area, words)},
           "text-anchor=\"middle\"", label);
}

double categories_depth(const PlotArea& area,
                        const std::vector<std::string>& words) {
  return slanted(area, words) ? 34.0 + 4.8 * static_cast<double>(longest(words))
                              : kAxisDepth;
}

}  // namespace brachisto::report
