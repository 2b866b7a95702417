// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/key_label.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "report/letters.hpp"
#include "report/rich_text.hpp"
#include "report/svg.hpp"

namespace brachisto::report {

namespace {

struct Known {
  std::string_view key, symbol, subscript, unit;
};
constexpr std::array<Known, 8> kKnown{{
    {"scene.body.radius", "r", "", "m"},
    {"scene.body.eta_m", "η", "m", ""},
    {"scene.body.theta_m", "θ", "m", "°"},
    {"scene.body.k", "k", "", ""},
    {"scene.body.mass", "m", "", "kg"},
    {"scene.finish.L", "L", "", "m"},
    {"scene.finish.H", "H", "", "m"},
    {"scene.gravity", "g", "", "m/s²"},
}};

constexpr std::size_t kBetween = 5;  // letters: " = " and ", "

}  // namespace

KeyLabel key_label(std::string_view key) {
  for (const Known& known : kKnown) {
    if (known.key != key) continue;
    return {std::string(known.symbol), std::string(known.subscript),
            std::string(known.unit), true, known.unit == "°"};
  }
  KeyLabel label;
  label.symbol = key;
  return label;
}

double KeyLabel::shown(double value) const {
  return degrees ? value * 180.0 / std::numbers::pi : value;
}

std::string KeyLabel::after_number() const {
  return unit.empty() || degrees ? unit : " " + unit;
}

KeyLabel KeyLabel::within(std::size_t letters) const {
  KeyLabel label = *this;
  if (!letter) label.symbol = shortened_key(symbol, letters);
  return label;
}

std::string KeyLabel::text(Markup markup, bool with_unit) const {
  const std::string rest =
      with_unit && !unit.empty() ? fmt::format("\u00A0[{}]", unit) : "";
  const std::string lowered = subscript.empty() ? "" : "_{" + subscript + "}";
  switch (markup) {
    case Markup::Plain:
      return symbol + (subscript.empty() ? "" : "_" + subscript) + rest;
    case Markup::Html:
      return letter ? fmt::format("<i>{}</i>{}", symbol,
                                  html_words(lowered + rest))
                    : fmt::format("<code>{}</code>", xml_escaped(symbol));
    case Markup::Svg:
      break;
  }
  if (!letter) return xml_escaped(symbol);
  return fmt::format("<tspan font-style=\"italic\">{}</tspan>{}", symbol,
                     svg_words(lowered + rest));
}

std::string tau_label_svg() {
  return "<tspan font-style=\"italic\">τ</tspan> = "
         "<tspan font-style=\"italic\">T</tspan> / √(<tspan "
         "font-style=\"italic\">H</tspan> / 2<tspan "
         "font-style=\"italic\">g</tspan>)";
}

double shown_number(const SweepColumn& column, std::size_t scene) {
  return key_label(column.key).shown(column.numbers[scene]);
}

Scale scale_of(const SweepColumn& column,
               const std::vector<std::size_t>& scenes) {
  if (key_label(column.key).degrees) return Scale::Degrees;
  std::vector<double> numbers;
  for (const std::size_t scene : scenes) {
    if (std::isfinite(column.numbers[scene])) {
      numbers.push_back(column.numbers[scene]);
    }
  }
  return suitable_scale(std::move(numbers));
}

std::string shown_value(const SweepColumn& column, std::size_t scene) {
  if (!column.numeric()) return column.words[scene];
  const KeyLabel label = key_label(column.key);
  return printed(label.shown(column.numbers[scene])) + label.after_number();
}

std::string place(const SweepTable& table,
                  const std::vector<std::size_t>& columns, std::size_t scene,
                  Markup markup) {
  constexpr std::size_t kEndless = std::numeric_limits<std::size_t>::max() / 2;
  const std::vector<std::string> lines =
      place_lines(table, columns, scene, markup, kEndless);
  return lines.front();
}

std::vector<std::string> place_lines(const SweepTable& table,
                                     const std::vector<std::size_t>& columns,
                                     std::size_t scene, Markup markup,
                                     std::size_t letters_of_line,
                                     std::size_t taken) {
  const std::size_t half = letters_of_line / 2;
  std::vector<std::string> lines(1);
  std::size_t used = taken;
  for (const std::size_t c : columns) {
    const SweepColumn& column = table.columns[c];
    const KeyLabel label = key_label(column.key).within(half);
    const std::string value =
        shortened(shown_value(column, scene), half - kBetween);
    const std::size_t length =
        letters(label.text(Markup::Plain, false) + value) + kBetween;
    const bool first = c == columns.front();
    if (!first) lines.back() += ",";
    if (used + length > letters_of_line && used > 0) {
      lines.emplace_back();
      used = 0;
    }
    lines.back() += fmt::format(
        "{}{} = {}", lines.back().empty() ? "" : " ", label.text(markup, false),
        markup == Markup::Plain ? value : xml_escaped(value));
    used += length;
  }
  return lines;
}

}  // namespace brachisto::report
