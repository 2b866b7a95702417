// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/clear_of_list.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/field_reader.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

/// Place, then size or direction.
using Numbers = std::array<double, 3>;

/// One kind of item: the name of its only key, and the fields below that.
struct Obstacle {
  std::string_view name;
  std::array<KeySpec, 3> fields;
  void (*store)(PathLimits&, const Numbers&);
  std::vector<Numbers> (*stored)(const PathLimits&);
};

/// A field, with its bounds in words.
KeySpec field(std::string_view name, KeyType type, KeyRules rules) {
  KeySpec spec(name, {.type = type}, "", std::move(rules));
  spec.complete({});
  return spec;
}

const std::array<Obstacle, 2>& obstacles() {
  const KeySpec x = field("x", KeyType::Number, {.unit = "m"});
  const KeySpec z = field("z", KeyType::Number, {.unit = "m"});
  static const std::array<Obstacle, 2> kAll{
      {{"disc",
        {x, z,
         field("radius", KeyType::Number,
               {.unit = "m",
                .interval = {.lower = 0.0, .lower_allowed = false}})},
        [](PathLimits& limits, const Numbers& n) {
          limits.discs.push_back({{n[0], n[1]}, n[2]});
        },
        [](const PathLimits& limits) {
          std::vector<Numbers> all;
          for (const Disc& disc : limits.discs) {
            all.push_back({disc.centre.x, disc.centre.z, disc.radius});
          }
          return all;
        }},
       {"half_plane",
        {x, z, field("normal", KeyType::Angle, {.unit = "rad"})},
        [](PathLimits& limits, const Numbers& n) {
          limits.half_planes.push_back({{n[0], n[1]}, n[2]});
        },
        [](const PathLimits& limits) {
          std::vector<Numbers> all;
          for (const HalfPlane& plane : limits.half_planes) {
            all.push_back({plane.point.x, plane.point.z, plane.normal});
          }
          return all;
        }}}};
  return kAll;
}

void read_item(PathLimits& limits, const KeySpec& spec, const YamlValue& item,
               Findings& findings) {
  const std::string key(spec.path);
  if (item.kind != YamlValue::Kind::Map) {
    return refuse_kind(item, key, expected(spec), findings);
  }
  if (item.entries.size() != 1) {
    return findings.add(item.position, key,
                        fmt::format("a map of {} keys was read; expected {}",
                                    item.entries.size(), expected(spec)));
  }
  const Entry& entry = item.entries.front();
  std::vector<std::string_view> names;
  for (const Obstacle& obstacle : obstacles()) {
    names.push_back(obstacle.name);
    if (obstacle.name != entry.key) continue;
    const std::string below = fmt::format("{}.{}", key, entry.key);
    if (entry.value.kind != YamlValue::Kind::Map) {
      return refuse_kind(
          entry.value, below,
          fmt::format("a map with the keys {}, {}, {}",
                      obstacle.fields[0].name(), obstacle.fields[1].name(),
                      obstacle.fields[2].name()),
          findings);
    }
    const FieldReader reader(entry.value, below, entry.position, findings);
    std::vector<std::string_view> allowed;
    std::vector<double> read;
    for (const KeySpec& field : obstacle.fields) {
      allowed.push_back(field.path);
      if (const auto value = reader.constant(field)) read.push_back(*value);
    }
    reader.allow_only(allowed);
    if (read.size() == allowed.size()) {
      obstacle.store(limits, {read[0], read[1], read[2]});
    }
    return;
  }
  findings.add(entry.position, key,
               unknown_word(entry.key, expected(spec), names));
}

void read_clear_of(Draft& problem, const KeySpec& spec, const YamlValue& list,
                   Findings& findings) {
  PathLimits& limits = problem.scene.limits;
  limits.discs.clear();
  limits.half_planes.clear();
  for_each_item(
      list, std::string(spec.path), expected(spec), findings,
      [&](const YamlValue& item) { read_item(limits, spec, item, findings); });
}

Json clear_of_json(const Draft& problem) {
  Json list;
  for (const Obstacle& obstacle : obstacles()) {
    for (const Numbers& numbers : obstacle.stored(problem.scene.limits)) {
      Json& item = list.emplace_back();
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        item[obstacle.name][obstacle.fields[i].path] = numbers[i];
      }
    }
  }
  return list;
}

Json clear_of_schema() {
  Json kinds = Json::array();
  const auto map_of = [](Json properties) {
    Json required = Json::array();
    for (const auto& [name, schema] : properties.items()) {
      required.push_back(name);
    }
    return Json{{"type", "object"},
                {"properties", std::move(properties)},
                {"required", std::move(required)},
                {"additionalProperties", false}};
  };
  for (const Obstacle& obstacle : obstacles()) {
    Json fields;
    for (const KeySpec& field : obstacle.fields) {
      fields[field.path] = number_schema(field);
    }
    kinds.push_back(map_of({{obstacle.name, map_of(std::move(fields))}}));
  }
  return {{"oneOf", std::move(kinds)}};
}

}  // namespace

Binding clear_of_list() {
  return {.type = KeyType::List,
          .get = clear_of_json,
          .silent = true,
          .read_list = read_clear_of,
          .items = clear_of_schema};
}

}  // namespace brachisto::io
