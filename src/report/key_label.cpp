// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/key_label.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

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

std::string KeyLabel::text(Markup markup, bool with_unit) const {
  const std::string rest =
      with_unit && !unit.empty() ? fmt::format("\u00A0[{}]", unit) : "";
  switch (markup) {
    case Markup::Plain:
      return symbol + (subscript.empty() ? "" : "_" + subscript) + rest;
    case Markup::Html:
      return letter
                 ? fmt::format(
                       "<i>{}</i>{}{}", symbol,
                       subscript.empty() ? "" : "<sub>" + subscript + "</sub>",
                       rest)
                 : fmt::format("<code>{}</code>", xml_escaped(symbol));
    case Markup::Svg:
      break;
  }
  if (!letter) return xml_escaped(symbol);
  std::string out =
      fmt::format("<tspan font-style=\"italic\">{}</tspan>", symbol);
  if (subscript.empty()) return out + rest;
  // What follows comes back to the line; that needs a text, be it of no width.
  return out + fmt::format(
                   "<tspan dy=\"4\" font-size=\"75%\">{}</tspan>"
                   "<tspan dy=\"-4\">{}</tspan>",
                   subscript, rest.empty() ? "\u200B" : rest);
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
  std::string out;
  for (const std::size_t c : columns) {
    const SweepColumn& column = table.columns[c];
    const std::string value = shown_value(column, scene);
    out += fmt::format("{}{} = {}", out.empty() ? "" : ", ",
                       key_label(column.key).text(markup, false),
                       markup == Markup::Plain ? value : xml_escaped(value));
  }
  return out;
}

}  // namespace brachisto::report
