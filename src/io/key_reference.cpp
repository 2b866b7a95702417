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
#include "io/key_spec.hpp"
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
  return (spec.is_required()      ? "required"
          : spec.fallback.empty() ? "—"
                                  : std::string(spec.fallback)) +
         (spec.of_cylinder() ? " (what rolls)" : "");
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

/// An object with room for so many keys: one that grows copies all that is in
/// it.
Json with_room(std::size_t keys = 8) {
  Json out = Json::object();
  out.get_ref<Json::object_t&>().reserve(keys);
  return out;
}
constexpr std::size_t kFewKeys = 32, kManyKeys = 128;

/// Texts that consist of what expressions consist of. Whether they are one,
/// only the program says.
std::string pattern(const KeySpec& spec) {
  // One character or word at a time, for a search without backtracking.
  return fmt::format(R"(^([0-9.]|[eE][-+]?[0-9]|{}|[-+*/^(),\s])+{}$)",
                     fmt::join(expression_names(spec.value.names), "|"),
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

Json value_schema(const KeySpec& spec);

// Bounds are for literals alone, a pattern for texts alone.
Json number_schema(const KeySpec& spec) {
  Json schema = with_room();
  schema["type"] = {spec.type() == KeyType::Integer ? "integer" : "number",
                    "string"};
  schema["pattern"] = pattern(spec);
  schema["patternErrorMessage"] = "expected " + expected(spec);
  add_bounds(schema, spec.interval);
  add_bounds(schema, spec.physical);
  return schema;
}

Json array_schema(Json items) {
  Json schema = with_room();
  schema["type"] = "array";
  schema["items"] = std::move(items);
  schema["minItems"] = 1;
  return schema;
}

/// Of a list whose items are described.
Json list_schema(const KeySpec& spec) {
  Json items = Json::array();
  for (const KeySpec& item : spec.value.items) {
    items.push_back(value_schema(item));
  }
  Json schema =
      array_schema(items.size() == 1 ? std::move(items.front())
                                     : Json{{"anyOf", std::move(items)}});
  if (spec.value.count != 0) {
    schema["minItems"] = schema["maxItems"] = spec.value.count;
  }
  return schema;
}

/// Of a map that has no other keys.
/// \param schema  what stands before that
Json closed_map(Json properties, Json schema = with_room()) {
  schema["type"] = "object";
  schema["properties"] = std::move(properties);
  schema["additionalProperties"] = false;
  return schema;
}

/// Of a map whose keys are described; of a key of the table they follow.
Json map_schema(const KeySpec& spec) {
  Json properties = with_room(kFewKeys), required, one_of;
  for (const KeySpec& key : spec.value.items) {
    properties[key.path] = value_schema(key);
    if (key.is_required()) required.push_back(key.path);
    one_of.push_back({{"required", {key.path}}});
  }
  Json schema = closed_map(std::move(properties));
  if (!required.is_null()) schema["required"] = required;
  if (spec.value.one_of) schema["oneOf"] = one_of;
  return schema;
}

Json choice_schema(const KeySpec& spec) {
  const std::vector<std::string_view>& words = spec.value.words;
  if (words.size() == 2 && as_json(words.front()).is_boolean()) {
    return {{"type", "boolean"}};
  }
  Json values = Json::array();
  for (const std::string_view word : words) values.push_back(as_json(word));
  return {{"enum", std::move(values)}};
}

/// What a key may be in the section `sweep`: one value, a list or a range.
Json swept_schema(const KeySpec& spec) {
  Json value = value_schema(as_swept(spec));
  Json kinds = Json::array();
  kinds.push_back(value);
  kinds.push_back(array_schema(std::move(value)));
  if (spec.type() != KeyType::Choice) {
    kinds.push_back(map_schema(range_of(spec, true)));
  }
  Json schema = with_room();
  schema["anyOf"] = std::move(kinds);
  return schema;
}

Json sweep_schema() {
  Json swept = with_room(kManyKeys), sampled = with_room(kManyKeys);
  Json paths = Json::array();
  for (const KeySpec& spec : key_table()) {
    if (!is_value_key(spec.path)) continue;
    paths.push_back(spec.path);
    Json& schema = swept[spec.path] = swept_schema(spec);
    schema["description"] = spec.description;
    if (is_real(spec)) {
      sampled[spec.path] = map_schema(range_of(spec, false));
    }
  }
  Json together = array_schema({{"enum", paths}});
  together["minItems"] = 2;
  swept["zip"] = {{"description", "keys that run together"},
                  {"anyOf", {together, array_schema(together)}}};
  for (const KeySpec& spec : keys_beside_swept()) {
    Json& schema = swept[spec.path] = value_schema(spec);
    schema["description"] = spec.description;
  }
  swept["random"]["properties"]["ranges"] = closed_map(std::move(sampled));
  return closed_map(std::move(swept));
}

/// Keywords about properties mean nothing to a word.
Json choice_or_map_schema(const KeySpec& spec) {
  Json schema = closed_map(Json::object());
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
      return list_schema(spec);
    case KeyType::Map:
      return map_schema(spec);
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
  Json schema = with_room();
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = "Problem file of brachisto";
  schema = closed_map(with_room(kFewKeys), std::move(schema));
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
