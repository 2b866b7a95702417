// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/body_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "io/expression.hpp"
#include "io/lists.hpp"
#include "io/text_lines.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

constexpr std::array<std::string_view, 4> kKinds{"point", "ring", "disc",
                                                 "rod"};
constexpr std::array<std::string_view, 4> kOfPoint{"m", "at", "x", "z"};
constexpr std::array<std::string_view, 5> kOfRing{"m", "radius", "at", "x",
                                                  "z"};
constexpr std::array<std::string_view, 6> kOfDisc{"m",  "radius", "hole",
                                                  "at", "x",      "z"};
constexpr std::array<std::string_view, 3> kOfRod{"m", "from", "to"};

std::span<const std::string_view> names_of(std::string_view kind) {
  if (kind == "point") return kOfPoint;
  if (kind == "ring") return kOfRing;
  return kind == "disc" ? std::span<const std::string_view>(kOfDisc) : kOfRod;
}

/// What is between commas that no parenthesis encloses.
std::vector<std::string_view> fields(std::string_view text) {
  std::vector<std::string_view> found;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (text[i] != ',' || depth > 0) continue;
    found.push_back(trimmed(text.substr(begin, i - begin)));
    begin = i + 1;
  }
  found.push_back(trimmed(text.substr(begin)));
  return found;
}

template <class... Args>
[[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) {
  throw std::invalid_argument(fmt::format(format, std::forward<Args>(args)...));
}

/// Names and values of one part.
class Values {
 public:
  Values(std::string_view kind, std::string_view text) {
    const std::span<const std::string_view> allowed = names_of(kind);
    for (const std::string_view field : fields(text)) {
      const std::size_t equals = field.find('=');
      const std::string_view name = trimmed(field.substr(0, equals));
      if (std::ranges::count(allowed, name) == 0) {
        refuse("\"{}\" is not allowed in a {}, which has {}{}", name, kind,
               fmt::join(allowed, ", "), suggestion(name, allowed));
      }
      if (equals == std::string_view::npos) {
        refuse("{} has no value; expected {}=…", name, name);
      }
      if (text_of(name)) refuse("{} is given twice", name);
      values_.push_back({name, field.substr(equals + 1)});
    }
  }
  Values() = default;

  [[nodiscard]] bool has(std::string_view name) const {
    return text_of(name).has_value();
  }
  [[nodiscard]] double number(std::string_view name, double otherwise) const {
    const auto text = text_of(name);
    return text ? value(name, *text, Unit::None) : otherwise;
  }
  /// The place called `name`, DISTANCE@ANGLE.
  [[nodiscard]] Point place(std::string_view name) const {
    const std::string_view text = text_of(name).value_or("0");
    const std::size_t sign = text.find('@');
    const double distance = value(name, text.substr(0, sign), Unit::None);
    if (sign == std::string_view::npos) {
      if (distance != 0.0) {
        refuse(
            "{}={} has no direction; expected {}=DISTANCE@ANGLE such as "
            "{}={}@-30deg",
            name, text, name, name, text);
      }
      return {};
    }
    const double angle = value(name, text.substr(sign + 1), Unit::Angle);
    return {distance * std::cos(angle), distance * std::sin(angle)};
  }
  /// The same by `at`, or by x and z.
  [[nodiscard]] Point place() const {
    if (!has("x") && !has("z")) return place("at");
    if (has("at")) refuse("a place is given by at or by x and z, not by both");
    return {number("x", 0.0), number("z", 0.0)};
  }

 private:
  struct Value {
    std::string_view name, text;
  };
  [[nodiscard]] std::optional<std::string_view> text_of(
      std::string_view name) const {
    const auto found = std::ranges::find(values_, name, &Value::name);
    if (found == values_.end()) return std::nullopt;
    return found->text;
  }
  static double value(std::string_view name, std::string_view text, Unit unit) {
    try {
      const Expression written(text, unit, Names::None);
      return unit == Unit::Angle ? written.direction() : written.value({});
    } catch (const ExpressionError& error) {
      refuse("{}: \"{}\" is not {}: {}", name, trimmed(text),
             unit == Unit::Angle ? "an angle in rad or, as in 30deg, in degrees"
                                 : "a number",
             error.what());
    }
  }

  std::vector<Value> values_;
};

}  // namespace

MassPart read_mass_part(std::string_view text, double radius) {
  const std::size_t colon = text.find(':');
  const std::string_view kind = trimmed(text.substr(0, colon));
  if (std::ranges::count(kKinds, kind) == 0) {
    refuse("\"{}\" is not a kind of part; allowed are {}{}", kind,
           fmt::join(kKinds, ", "), suggestion(kind, kKinds));
  }
  const bool bare = colon == std::string_view::npos;
  const Values values = bare ? Values() : Values(kind, text.substr(colon + 1));
  const double mass = values.number("m", 1.0);
  const auto make = [&] {
    if (kind == "point") return MassPart::point(mass, values.place());
    if (kind == "rod") {
      if (!values.has("from") || !values.has("to")) {
        refuse("a rod needs both from and to, such as from=1@0,to=1@180deg");
      }
      return MassPart::rod(mass, values.place("from"), values.place("to"));
    }
    const double size = values.number("radius", radius);
    if (kind == "ring") return MassPart::ring(mass, values.place(), size);
    return MassPart::disc(mass, values.place(), size,
                          values.number("hole", 0.0));
  };
  MassPart part = make();
  part.name = text;
  return part;
}

std::string mass_part_grammar() {
  return "  point[:m=MASS,at=PLACE]                        a point mass\n"
         "  ring[:m=MASS,radius=LENGTH,at=PLACE]           a thin ring\n"
         "  disc[:m=MASS,radius=LENGTH,hole=LENGTH,at=PLACE]\n"
         "                                                 a uniform disc, "
         "with "
         "a round hole in its middle if wanted\n"
         "  rod:m=MASS,from=PLACE,to=PLACE                 a thin rod\n"
         "PLACE is DISTANCE@ANGLE as seen from the axis of the cylinder, the "
         "angle from +x towards +z (down), in degrees (0.9@-30deg) or radians "
         "(0.9@pi/6); or x=LENGTH,z=LENGTH instead of at. What is left out: "
         "m=1, on the axis, as large as the cylinder.\n";
}

namespace {

/// Texts, which stand for parts until the radius is known.
Objection put_parts(Draft& problem, const Json& list, Binding::Row) {
  problem.design.parts.clear();
  for (const Json& text : list) {
    problem.design.parts.emplace_back().name = text.get<std::string>();
  }
  return {};
}

}  // namespace

Binding parts_list() {
  // Not echoed: eta_m, theta_m and k say what matters of them.
  return {.type = KeyType::List,
          .put_list = put_parts,
          .items = {{"", {.type = KeyType::Text}, ""}}};
}

void read_body_parts(const YamlValue& root, Draft& problem,
                     Findings& findings) {
  const Entry* entry = find_entry(root, kPartsKey);
  if (entry == nullptr || findings.concern(kPartsKey)) return;
  const auto refuse_key = [&](std::string_view key,
                              const std::string& message) {
    findings.add(position_of(root, key), std::string(key), message);
  };
  for (const KeySpec& spec : key_table()) {
    if (!follows_from_parts(spec) || find_entry(root, spec.path) == nullptr) {
      continue;
    }
    refuse_key(spec.path, "not allowed beside parts, from which it follows");
  }
  constexpr const char* kMassKey = "scene.body.mass";
  if (find_entry(root, kMassKey) != nullptr) {
    refuse_key(kMassKey,
               "not allowed beside parts, which have masses of their own");
  }
  constexpr const char* kRadiusKey = "scene.body.radius";
  const Entry* radius = find_entry(root, kRadiusKey);
  if (radius == nullptr || findings.concern(kRadiusKey)) return;
  if (radius->value.kind == YamlValue::Kind::Refused) {
    return refuse_key(kPartsKey,
                      "a body of parts has one radius, which cannot "
                      "vary");
  }
  Body& body = problem.scene.body;
  std::vector<MassPart>& parts = problem.design.parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string text = parts[i].name;
    try {
      parts[i] = read_mass_part(text, body.radius);
    } catch (const std::invalid_argument& error) {
      findings.add(entry->value.items[i].position, kPartsKey,
                   fmt::format("{}: {}", text, error.what()));
    }
  }
  if (findings.concern(kPartsKey)) return;
  try {
    const MassProperties found = mass_properties(parts, body.radius);
    body.eta_m = found.eta_m;
    body.theta_m = found.theta_m;
    body.k = found.k;
  } catch (const std::invalid_argument& error) {
    refuse_key(kPartsKey, error.what());
  }
}

}  // namespace brachisto::io
