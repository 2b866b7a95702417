// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// problem_schema(): what editors check a problem file by. Draft 7 of JSON
/// Schema, which all of them know.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "io/binding.hpp"
#include "io/expression.hpp"
#include "io/field_reader.hpp"
#include "io/key_spec.hpp"
#include "io/list_reader.hpp"
#include "io/sweep_section.hpp"
#include "math/enum_table.hpp"

namespace brachisto::io {

std::string_view type_name(KeyType type) {
  constexpr auto kNames =
      table_by<KeyType>("map", "number", "angle", "integer", "word", "text",
                        "list", "map", "reserved");
  return kNames[type];
}

std::string described(const KeySpec& spec) {
  // "[Limits](#limits)" is a link within the page, "`gravity`" code.
  static const std::regex link(R"(\[([^\]]*)\]\(#[^)]*\))"), code("`");
  std::string text(spec.description);
  text = std::regex_replace(text, link, "$1 in docs/problem-files.md");
  text = std::regex_replace(text, code, "");
  if (!spec.unit.empty()) text += fmt::format(" [{}]", spec.unit);
  if (spec.type() == KeyType::Choice || !spec.bounds.empty()) {
    text += fmt::format(
        "; {}", spec.type() == KeyType::Choice ? expected(spec) : spec.bounds);
  }
  if (spec.is_required()) {
    text += spec.of_cylinder() ? "; required of what rolls" : "; required";
  }
  if (!spec.fallback.empty())
    text += fmt::format("; default: {}", spec.fallback);
  return text;
}

namespace {

std::string default_text(const KeySpec& spec) {
  switch (spec.presence) {
    case Presence::Required:
      return "required";
    case Presence::RequiredOfCylinder:
      return "required (what rolls)";
    case Presence::OptionalOfCylinder:
      return fmt::format("{} (what rolls)", spec.fallback);
    case Presence::Optional:
      break;
  }
  return spec.fallback.empty() ? "—" : std::string(spec.fallback);
}

std::string allowed_text(const KeySpec& spec) {
  if (spec.type() == KeyType::Choice) {
    return fmt::format("`{}`{}", fmt::join(spec.value.words, "`, `"),
                       is_choice_or_map(spec) ? ", or a map" : "");
  }
  return std::string(spec.bounds);
}

std::string row(const KeySpec& spec) {
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", spec.path,
                     type_name(spec.type()), spec.unit, default_text(spec),
                     allowed_text(spec), spec.description);
}

/// Keys that this version refuses as known.
std::string reserved() {
  std::vector<std::string> names;
  for (const KeySpec& spec : key_table()) {
    if (spec.type() == KeyType::Reserved) {
      names.push_back(fmt::format("`{}`", spec.path));
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string key_reference_markdown() {
  std::string text =
      "| key | type | unit | default | allowed | meaning |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const KeySpec& spec : key_table()) {
    if (spec.type() != KeyType::Reserved) text += row(spec);
  }
  return text + "\nReserved for later versions: " + reserved() + ".\n";
}

namespace {

/// Texts that consist of what expressions consist of. Whether they are one,
/// only the program says.
std::string pattern(const KeySpec& spec, Names names) {
  // One character or word at a time, for a search without backtracking.
  return fmt::format(R"(^([0-9.]|[eE][-+]?[0-9]|{}|[-+*/^(),\s])+{}$)",
                     fmt::join(expression_names(names), "|"),
                     unit_of(spec) == Unit::Angle ? R"((deg|rad)?\s*)" : "");
}

void add_bounds(Json& schema, const Interval& interval) {
  if (!std::isinf(interval.lower)) {
    schema[interval.lower_allowed ? "minimum" : "exclusiveMinimum"] =
        interval.lower;
  }
  if (!std::isinf(interval.upper)) {
    schema[interval.upper_allowed ? "maximum" : "exclusiveMaximum"] =
        interval.upper;
  }
}

}  // namespace

// Bounds are for literals alone, a pattern for texts alone.
Json number_schema(const KeySpec& spec, Names names) {
  Json schema = {
      {"type",
       {spec.type() == KeyType::Integer ? "integer" : "number", "string"}},
      {"pattern", pattern(spec, names)},
      {"patternErrorMessage", "expected " + expected(spec)}};
  add_bounds(schema, spec.interval);
  add_bounds(schema, spec.physical);
  return schema;
}

Json list_schema(Json items) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", 1}};
}

Json number_or_text_schema() {
  return {{"type", {"number", "string"}}};
}

Json pair_schema() {
  return {{"type", "array"},
          {"items", number_or_text_schema()},
          {"minItems", 2},
          {"maxItems", 2}};
}

Json map_schema(Json properties, std::span<const std::string_view> required) {
  Json schema = {{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = required;
  schema["additionalProperties"] = false;
  return schema;
}

namespace {

Json choice_schema(const KeySpec& spec) {
  const std::vector<std::string_view>& words = spec.value.words;
  if (words.size() == 2 && as_json(words.front()).is_boolean()) {
    return {{"type", "boolean"}};
  }
  Json values = Json::array();
  for (const std::string_view word : words) values.push_back(as_json(word));
  return {{"enum", std::move(values)}};
}

/// Numbers between two ends, with or without their count.
Json range_schema(const Json& value, bool counted) {
  Json properties = {{"from", value}, {"to", value}};
  if (counted) {
    properties["count"] = {{"type", {"integer", "string"}},
                           {"minimum", kCounts.lower},
                           {"maximum", kCounts.upper}};
  }
  properties["spacing"] = {{"enum", {"linear", "log"}}};
  Json range = map_schema(std::move(properties));
  range["required"] = {"from", counted ? "count" : "to"};
  return range;
}

/// What a key may be in the section `sweep`: one value, a list or a range.
Json swept_schema(const KeySpec& spec) {
  if (spec.type() == KeyType::Choice) {
    const Json word = choice_schema(spec);
    return {{"anyOf", {word, list_schema(word)}}};
  }
  const Json value = number_schema(spec, Names::Quantities);
  return {{"anyOf", {value, list_schema(value), range_schema(value, true)}}};
}

Json sweep_schema() {
  Json swept, sampled, paths = Json::array();
  for (const KeySpec& spec : key_table()) {
    if (!is_value_key(spec.path)) continue;
    paths.push_back(spec.path);
    swept[spec.path] = swept_schema(spec);
    swept[spec.path]["description"] = spec.description;
    const bool real =
        spec.type() == KeyType::Number || spec.type() == KeyType::Angle;
    if (!real) continue;
    sampled[spec.path] =
        range_schema(number_schema(spec, Names::Quantities), false);
  }
  const Json together = {
      {"type", "array"}, {"items", {{"enum", paths}}}, {"minItems", 2}};
  swept["zip"] = {{"description", "keys that run together"},
                  {"anyOf", {together, list_schema(together)}}};
  Json random = map_schema({{"seed", {{"type", "integer"}, {"minimum", 0}}},
                            {"count", {{"type", "integer"}, {"minimum", 1}}},
                            {"ranges", map_schema(sampled)}});
  random["required"] = {"count", "ranges"};
  random["description"] = "keys that are drawn between two ends";
  swept["random"] = std::move(random);
  swept["warm_start"] = {
      {"type", "boolean"},
      {"description", "start each scene from its neighbour's solution"}};
  swept["keep"] = {{"enum", {"nothing", "tracks"}},
                   {"description",
                    "what is kept of each scene besides its "
                    "numbers"}};
  return map_schema(std::move(swept));
}

/// Keywords about properties mean nothing to a word.
Json choice_or_map_schema(const KeySpec& spec) {
  Json schema = map_schema(Json::object());
  schema.erase("type");
  schema["oneOf"] = {choice_schema(spec), {{"type", "object"}}};
  return schema;
}

Json value_schema(const KeySpec& spec) {
  switch (spec.type()) {
    case KeyType::Number:
    case KeyType::Angle:
    case KeyType::Integer:
      return number_schema(spec);
    case KeyType::Choice:
      if (is_choice_or_map(spec)) return choice_or_map_schema(spec);
      return choice_schema(spec);
    case KeyType::Text:
      return {{"type", "string"}};
    case KeyType::List:
      return list_schema(spec.value.items());
    case KeyType::Map:
      return map_schema(Json::object());
    case KeyType::Sweep:
      return sweep_schema();
    case KeyType::Reserved:
      break;
  }
  return false;
}

/// Null is as good as absent.
void allow_null(Json& schema) {
  if (schema.contains("enum")) {
    schema["enum"].push_back(nullptr);
  } else if (schema.contains("oneOf")) {
    allow_null(schema["oneOf"].front());
  } else if (Json& type = schema["type"]; type.is_array()) {
    type.push_back("null");
  } else {
    type = {type, "null"};
  }
}

Json& properties_of(Json& schema, std::string_view map) {
  Json* place = &schema["properties"];
  if (map.empty()) return *place;
  for (const std::string& part : parts_of(map)) {
    place = &(*place)[part]["properties"];
  }
  return *place;
}

/// What must be there, unless a sweep may supply it.
Json required_of_problems() {
  Json needed;
  const auto need = [&](const KeySpec& spec) {
    Json* map = &needed;
    if (!spec.parent().empty()) {
      for (const std::string& part : parts_of(spec.parent())) {
        map = &(*map)["properties"][part];
      }
    }
    (*map)["required"].push_back(spec.name());
  };
  Json of_cylinder, unless_parts;
  for (const KeySpec& spec : key_table()) {
    if (spec.presence == Presence::Required) need(spec);
    if (spec.presence == Presence::RequiredOfCylinder) {
      (follows_from_parts(spec) ? unless_parts : of_cylinder)
          .push_back(spec.name());
    }
  }
  Json& body = needed["properties"]["scene"]["properties"]["body"];
  body["if"] = {{"properties", {{"shape", {{"enum", {"cylinder", "ball"}}}}}}};
  body["then"] = {{"required", of_cylinder},
                  {"anyOf",
                   {{{"required", unless_parts}},
                    {{"required", {"inertia"}}},
                    {{"required", {"parts"}}}}}};
  return needed;
}

}  // namespace

std::string problem_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Problem file of brachisto"}};
  schema.update(map_schema(Json::object()));
  Json of_cylinder;
  for (const KeySpec& spec : key_table()) {
    if (spec.type() == KeyType::Reserved) continue;
    Json value = value_schema(spec);
    if (!spec.is_required()) allow_null(value);
    value["description"] = described(spec);
    if (spec.of_cylinder()) of_cylinder[spec.name()] = {{"type", "null"}};
    properties_of(schema, spec.parent())[spec.name()] = std::move(value);
  }
  Json& body = properties_of(schema, "scene")["body"];
  body["if"] = {{"properties", {{"shape", {{"const", "bead"}}}}},
                {"required", {"shape"}}};
  body["then"] = {{"properties", of_cylinder}};
  schema["if"] = {{"not", {{"required", {"sweep"}}}}};
  schema["then"] = required_of_problems();
  return schema.dump(2) + "\n";
}

}  // namespace brachisto::io
