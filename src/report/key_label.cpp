// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/key_label.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "math/angle.hpp"
#include "report/letters.hpp"
#include "report/rich_text.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

namespace {

struct Known {
  std::string_view key, words, symbol, subscript, unit;
};
// By rank: the orientation to the right of all else, k above η_m.
constexpr std::array<Known, 14> kKnown{{
    {"scene.body.theta_m", "angle of the mass", "θ", "m", "°"},
    {"scene.body.eta_m", "offset of the mass", "η", "m", ""},
    {"scene.body.k", "inertia", "k", "", ""},
    {"scene.body.radius", "radius", "r", "", "m"},
    {"scene.finish.L", "distance across", "L", "", "m"},
    {"scene.finish.H", "drop", "H", "", "m"},
    {"scene.body.mass", "mass", "m", "", "kg"},
    {"scene.gravity", "gravity", "g", "", "m/s²"},
    {"scene.limits.friction", "coefficient of friction", "μ", "", ""},
    {"scene.limits.curvature.valley", "sharpest valley", "κ", "valley", "1/m"},
    {"scene.limits.curvature.hump", "sharpest hump", "κ", "hump", "1/m"},
    {"scene.limits.normal_force.min", "least load", "R", "min", "m g"},
    {"scene.limits.normal_force.max", "greatest load", "R", "max", "m g"},
    {"scene.contact", "", "contact", "", ""},
}};

}  // namespace

KeyLabel key_label(std::string_view key) {
  KeyLabel label;
  for (const Known& known : kKnown) {
    if (known.key == key) {
      return {std::string(known.words),
              std::string(known.symbol),
              std::string(known.subscript),
              std::string(known.unit),
              true,
              known.unit == "°",
              label.rank};
    }
    ++label.rank;
  }
  label.symbol = key;
  return label;
}

double KeyLabel::shown(double value) const {
  return degrees ? math::in_degrees(value) : value;
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
  const std::string name = subscript.empty() ? "" : "_{" + subscript + "}";
  const std::string rest =
      name +
      (with_unit && !unit.empty() ? fmt::format("\u00A0[{}]", unit) : "");
  if (markup == Markup::Rich) return as_rich_text(symbol) + rest;
  return letter ? fmt::format("<i>{}</i>{}", symbol, html_words(rest))
                : fmt::format("<code>{}</code>", xml_escaped(symbol));
}

std::string KeyLabel::in_full(Markup markup, bool with_unit) const {
  return (words.empty() ? "" : words + " ") + text(markup, with_unit);
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

std::string place(const SweepTable& table,
                  const std::vector<std::size_t>& columns, std::size_t scene,
                  Markup markup) {
  std::string out;
  for (const std::size_t c : columns) {
    const SweepColumn& column = table.columns[c];
    const KeyLabel label = key_label(column.key);
    const std::string value =
        column.numeric()
            ? printed(label.shown(column.numbers[scene])) + label.after_number()
            : column.words[scene];
    out += fmt::format(
        "{}{} = {}", out.empty() ? "" : ", ", label.text(markup, false),
        markup == Markup::Html ? xml_escaped(value) : as_rich_text(value));
  }
  return out;
}

std::string what_is_fixed(const SweepTable& table,
                          const std::vector<std::size_t>& scenes) {
  if (scenes.empty()) return {};
  std::string out = place(table, columns_that_vary(table, scenes, false),
                          scenes.front(), Markup::Rich);
  for (const SweepConstant& constant : table.constants) {
    const KeyLabel label = key_label(constant.key);
    out += fmt::format(
        "{}{} = {}{}", out.empty() ? "" : ", ", label.text(Markup::Rich, false),
        printed(label.shown(constant.value)), label.after_number());
  }
  return out;
}

}  // namespace brachisto::report
