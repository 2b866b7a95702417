// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/plot_frame.hpp"

#include <algorithm>
#include <cmath>

#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr double kTick = 5.0;
constexpr double kShortTick = 3.0;
constexpr double kLabelSize = 14.0;   // that of the document
constexpr std::size_t kLetters = 14;  // of a category
constexpr std::string_view kThin = "stroke=\"#333333\" stroke-width=\"1\"";
constexpr std::string_view kBelow =
    "text-anchor=\"middle\" font-size=\"13\" fill=\"#222222\"";
constexpr std::string_view kBeside =
    "text-anchor=\"end\" font-size=\"13\" fill=\"#222222\"";

std::vector<Tick> numbered(const Axis& axis) {
  std::vector<Tick> ticks;
  for (const double value : axis.ticks(7)) {
    ticks.push_back({value, printed(value)});
  }
  return ticks;
}

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
                 const std::vector<Tick>& ticks, std::string_view label) {
  for (const Tick& tick : ticks) {
    const double x = axis(tick.value);
    const double length = tick.words.empty() ? kShortTick : kTick;
    svg.line({x, area.bottom}, {x, area.bottom + length}, kThin);
    if (tick.words.empty()) continue;
    svg.text({x, area.bottom + 19.0}, kBelow, svg_words(tick.words));
  }
  svg.text({0.5 * (area.left + area.right), area.bottom + kAxisDepth},
           "text-anchor=\"middle\"", label);
}

void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 const std::vector<Tick>& ticks, std::string_view label,
                 double label_x) {
  for (const Tick& tick : ticks) {
    const double y = axis(tick.value);
    const double length = tick.words.empty() ? kShortTick : kTick;
    svg.line({area.left - length, y}, {area.left, y}, kThin);
    if (tick.words.empty()) continue;
    svg.text({area.left - kTick - 4.0, y + 4.5}, kBeside,
             svg_words(tick.words));
  }
  const double middle = 0.5 * (area.top + area.bottom);
  svg.text({label_x, middle},
           fmt::format("text-anchor=\"middle\" "
                       "transform=\"rotate(-90 {:.0f} {:.1f})\"",
                       label_x, middle),
           label);
}

void draw_x_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 std::string_view label) {
  draw_x_axis(svg, area, axis, numbered(axis), label);
}

void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 std::string_view label) {
  constexpr double kLabelX = 18.0;
  draw_y_axis(svg, area, axis, numbered(axis), label, kLabelX);
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
