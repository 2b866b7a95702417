// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/list_reader.hpp"
#include "io/lists.hpp"

namespace brachisto::io {

namespace {

/// Place, then size or direction.
using Numbers = std::array<double, 3>;

/// One kind of item: the name of its only key, and the fields below that.
struct Obstacle {
  std::string_view name;
  std::array<KeySpec, 3> fields;
  std::vector<std::string_view> names;
  std::function<void(PathLimits&, const Numbers&)> store;
  std::function<std::vector<Numbers>(const PathLimits&)> stored;
};

/// A field, with its bounds in words.
KeySpec field(std::string_view name, KeyType type, KeyRules rules) {
  KeySpec spec(name, {.type = type}, "", std::move(rules));
  spec.complete({});
  return spec;
}

template <class Kind>
Obstacle obstacle(std::string_view name, const KeySpec& last,
                  std::vector<Kind> PathLimits::*all) {
  return {name,
          {field("x", KeyType::Number, {.unit = "m"}),
           field("z", KeyType::Number, {.unit = "m"}), last},
          {"x", "z", last.path},
          [=](PathLimits& limits, const Numbers& n) {
            (limits.*all).push_back({{n[0], n[1]}, n[2]});
          },
          [=](const PathLimits& limits) {
            std::vector<Numbers> numbers;
            for (const auto& [place, size] : limits.*all) {
              numbers.push_back({place.x, place.z, size});
            }
            return numbers;
          }};
}

const std::array<Obstacle, 2>& obstacles() {
  static const std::array<Obstacle, 2> kAll{
      obstacle("disc",
               field("radius", KeyType::Number,
                     {.unit = "m",
                      .interval = {.lower = 0.0, .lower_allowed = false}}),
               &PathLimits::discs),
      obstacle("half_plane", field("normal", KeyType::Angle, {.unit = "rad"}),
               &PathLimits::half_planes)};
  return kAll;
}

void read_item(PathLimits& limits, const ListReader& reader,
               const YamlValue& item) {
  if (item.kind != YamlValue::Kind::Map) return reader.refuse_kind(item);
  if (item.entries.size() != 1) {
    return reader.refuse(item.position, fmt::format("a map of {} keys was read",
                                                    item.entries.size()));
  }
  const auto& [name, position, value] = item.entries.front();
  const auto kind = reader.word(
      name, position, std::array{obstacles()[0].name, obstacles()[1].name});
  if (!kind) return;
  const Obstacle& obstacle = obstacles()[*kind];
  const std::string below = fmt::format("{}.{}", reader.key, name);
  if (value.kind != YamlValue::Kind::Map) {
    return refuse_kind(
        value, below,
        fmt::format("a map with the keys {}", fmt::join(obstacle.names, ", ")),
        reader.findings);
  }
  const FieldReader fields(value, below, position, reader.findings);
  std::vector<double> read;
  for (const KeySpec& field : obstacle.fields) {
    if (const auto number = fields.constant(field)) read.push_back(*number);
  }
  fields.allow_only(obstacle.names);
  if (read.size() == 3) obstacle.store(limits, {read[0], read[1], read[2]});
}

void read_clear_of(Draft& problem, const KeySpec& spec, const YamlValue& list,
                   Findings& findings) {
  PathLimits& limits = problem.scene.limits;
  limits.discs.clear();
  limits.half_planes.clear();
  const ListReader reader(spec, findings);
  reader.each(list,
              [&](const YamlValue& item) { read_item(limits, reader, item); });
}

Json clear_of_json(const Draft& problem, Binding::Row) {
  Json list;
  for (const Obstacle& obstacle : obstacles()) {
    for (const Numbers& numbers : obstacle.stored(problem.scene.limits)) {
      Json& item = list.emplace_back();
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        item[obstacle.name][obstacle.names[i]] = numbers[i];
      }
    }
  }
  return list;
}

Json clear_of_schema() {
  Json kinds = Json::array();
  for (const Obstacle& obstacle : obstacles()) {
    Json fields;
    for (const KeySpec& field : obstacle.fields) {
      fields[field.path] = number_schema(field);
    }
    kinds.push_back(
        map_schema({{obstacle.name, map_schema(fields, obstacle.names)}},
                   std::array{obstacle.name}));
  }
  return {{"oneOf", std::move(kinds)}};
}

}  // namespace

Binding clear_of_list() {
  return {.type = KeyType::List,
          .echo = clear_of_json,
          .silent = true,
          .read_list = read_clear_of,
          .items = clear_of_schema};
}

}  // namespace brachisto::io
