// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "io/list_reader.hpp"
#include "io/lists.hpp"

namespace brachisto::io {

namespace {

std::vector<std::string_view> free_names() {
  std::vector<std::string_view> names;
  for (const BodyKey key : kBodyKeys) names.push_back(name(key));
  return names;
}

constexpr std::string_view kExpectedPart =
    "the number of a part in scene.body.parts, from 1 on";
constexpr std::string_view kExpectedMasses =
    "bounds of the mass, two numbers > 0, the greater one last";
constexpr double kMostParts = 1000;

DesignBounds read_masses(const Entry* entry, const YamlValue& item,
                         const std::string& key, Findings& findings) {
  constexpr Interval kPositive{.lower = 0.0, .lower_allowed = false};
  std::vector<double> ends;
  if (entry != nullptr && entry->value.kind == YamlValue::Kind::List) {
    for (const YamlValue& end : entry->value.items) {
      if (end.kind != YamlValue::Kind::Scalar) continue;
      const auto value = read_number(end, key, KeyType::Number, kPositive,
                                     kExpectedMasses, findings);
      if (value) ends.push_back(*value);
    }
  }
  if (ends.size() == 2 && ends[0] < ends[1]) return {ends[0], ends[1]};
  findings.add(entry == nullptr ? item.position : entry->value.position, key,
               fmt::format("expected {}", kExpectedMasses));
  return {};
}

/// An item {part: 2, key: at}.
void read_free_part(std::vector<FreePart>& all, const ListReader& reader,
                    const YamlValue& item) {
  const FieldReader fields(item, reader.key, item.position, reader.findings);
  fields.allow_only({"part", "key", "bounds"});
  const auto part = fields.integer("part", {1, kMostParts}, kExpectedPart);
  const std::string_view word = fields.word("key", {"at", "mass"});
  if (!part) return;
  FreePart free{static_cast<std::size_t>(*part) - 1, FreePart::Key::At, {}};
  if (word == "mass") free.key = FreePart::Key::Mass;
  const bool known = std::ranges::any_of(all, [&](const FreePart& other) {
    return other.part == free.part && other.key == free.key;
  });
  if (known) fields.refuse("part", "this key of the part is free already");
  const Entry* bounds = item.find("bounds");
  if (free.key == FreePart::Key::Mass) {
    free.bounds =
        read_masses(bounds, item, reader.key + ".bounds", reader.findings);
  } else if (bounds != nullptr) {
    fields.refuse("bounds",
                  "the place of a part has no bounds but the cylinder");
  }
  all.push_back(free);
}

void read_free(Draft& problem, const KeySpec& spec, const YamlValue& list,
               Findings& findings) {
  DesignPlan& plan = problem.design;
  plan.free.clear();
  plan.free_parts.clear();
  const ListReader reader(spec, findings);
  reader.each(list, [&](const YamlValue& item) {
    if (item.kind == YamlValue::Kind::Map) {
      read_free_part(plan.free_parts, reader, item);
    } else if (const auto named = reader.word(item, free_names())) {
      reader.add_once(plan.free, {kBodyKeys[*named]}, item,
                      in_quotes(item.text), "");
    }
  });
}

Json free_json(const Draft& problem, Binding::Row) {
  if (problem.design.empty()) return {};
  Json list = Json::array();
  for (const BodyKey key : problem.design.free) list.push_back(name(key));
  for (const auto& [part, key, bounds] : problem.design.free_parts) {
    Json item = {{"part", part + 1},
                 {"key", key == FreePart::Key::At ? "at" : "mass"}};
    if (key == FreePart::Key::Mass) {
      item["bounds"] = {bounds.lower, bounds.upper};
    }
    list.push_back(std::move(item));
  }
  return list;
}

Json free_schema() {
  return {{"anyOf",
           {{{"enum", free_names()}},
            map_schema({{"part", {{"type", "integer"}, {"minimum", 1}}},
                        {"key", {{"enum", {"at", "mass"}}}},
                        {"bounds", pair_schema()}},
                       std::array{std::string_view("part")})}}};
}

/// What a body may have, for the bounds of a design.
Interval allowed(BodyKey key) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (key) {
    case BodyKey::EtaM:
      return {.lower = 0.0, .upper = 1.0, .upper_allowed = false};
    case BodyKey::ThetaM:
      return {-2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
    case BodyKey::K:
      return {0.0, 1.0};
    case BodyKey::Radius:
      return {.lower = 0.0, .upper = kInfinity, .lower_allowed = false};
  }
  return {};
}

void read_bounds(Draft& problem, const KeySpec& spec, const YamlValue& list,
                 Findings& findings) {
  const auto key = static_cast<BodyKey>(spec.value.row);
  const ListReader reader(spec, findings);
  std::vector<double> ends;
  reader.each(list, [&](const YamlValue& item) {
    const auto value = reader.number(
        item, key == BodyKey::ThetaM ? KeyType::Angle : KeyType::Number,
        allowed(key));
    if (value) ends.push_back(*value);
  });
  if (list.kind != YamlValue::Kind::List || findings.concern(reader.key)) {
    return;
  }
  if (list.items.size() != 2) {
    reader.refuse(list.position,
                  fmt::format("{} values were read", list.items.size()));
  } else if (!(ends[0] < ends[1])) {
    reader.refuse(
        list.position,
        fmt::format("from {:g} to {:g} is no room", ends[0], ends[1]),
        ", the greater one last. What has one value belongs in scene.body and "
        "is not free");
  } else {
    problem.design.bounds[spec.value.row] = {ends[0], ends[1]};
  }
}

}  // namespace

Binding free_list() {
  return {.type = KeyType::List,
          .echo = free_json,
          .read_list = read_free,
          .items = free_schema};
}

Binding bounds_list(BodyKey key) {
  return {.type = KeyType::List,
          .echo =
              [](const Draft& p, Binding::Row row) {
                const auto& bounds = p.design.bounds[row];
                return bounds ? Json::array({bounds->lower, bounds->upper})
                              : Json();
              },
          .read_list = read_bounds,
          .items = number_or_text_schema,
          .row = static_cast<Binding::Row>(key)};
}

}  // namespace brachisto::io
