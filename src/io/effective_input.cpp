// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/effective_input.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/sweep_section.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

namespace {

/// Calls take(path, value) for each key of a section.
template <class Take>
void each_key(const Draft& problem, std::string_view section, Take&& take) {
  std::string_view absent = "\n";  // what is below, the problem does not have
  for (const KeySpec& spec : key_table()) {
    const bool inside = spec.path == section || below(spec.path, section);
    const bool of_another_body =
        spec.of_cylinder() && !problem.scene.body.rolls();
    if (!inside || !spec.value.is_echoed() || of_another_body ||
        below(spec.path, absent)) {
      continue;
    }
    Json value = spec.used(problem) ? spec.value.get(problem) : Json();
    if (value.is_object()) continue;  // its keys follow
    absent = spec.path;
    if (spec.value.silent && value.is_null()) continue;
    take(spec.path, std::move(value));
  }
}

template <class Take>
void each_key(const Scene& scene, const SolveOptions& options, Take&& take) {
  ProblemFile problem;
  problem.scene = scene;
  problem.options = options;
  const Draft draft(problem);
  for (const char* section : {"scene", "discretisation", "solver"}) {
    each_key(draft, section, take);
  }
}

void add(Json& document, std::string_view path, Json value) {
  Json* place = &document;
  for (const std::string& part : parts_of(path)) place = &(*place)[part];
  *place = std::move(value);
}

bool is_key(const std::string& path, const std::string& name) {
  if (path == "sweep." || path == "sweep.random.ranges.") {
    return is_key_of_sweep(name);
  }
  if (path.starts_with("sweep.")) return is_key_of_range(name);
  return find_key(path + name) != nullptr;
}

void drop_nulls(YamlValue& map, const std::string& path) {
  std::erase_if(map.entries, [&](Entry& entry) {
    if (!is_key(path, entry.key)) return false;
    drop_nulls(entry.value, path + entry.key + '.');
    return entry.value.kind == YamlValue::Kind::Null &&
           !entry.value.text.empty();
  });
}

}  // namespace

Json effective_input(const Scene& scene, const SolveOptions& options) {
  Json document;
  each_key(scene, options, [&](std::string_view path, Json value) {
    add(document, path, std::move(value));
  });
  return document;
}

std::string effective_lines(const Scene& scene, const SolveOptions& options) {
  std::string lines;
  each_key(scene, options, [&](std::string_view path, const Json& value) {
    lines.append(path).append(" ").append(value.dump()).append("\n");
  });
  return lines;
}

Json effective_section(const ProblemFile& problem, std::string_view section) {
  Json document;
  each_key(Draft(problem), section, [&](std::string_view path, Json value) {
    add(document, path, std::move(value));
  });
  return document.at(section);
}

Json stated_input(const YamlValue& tree) {
  switch (tree.kind) {
    case YamlValue::Kind::Map: {
      Json map = Json::object();
      for (const Entry& entry : tree.entries) {
        map[entry.key] = stated_input(entry.value);
      }
      return map;
    }
    case YamlValue::Kind::List: {
      Json list = Json::array();
      for (const YamlValue& item : tree.items) {
        list.push_back(stated_input(item));
      }
      return list;
    }
    case YamlValue::Kind::Scalar: {
      Json literal = Json::parse(tree.text, nullptr, false);
      return literal.is_number() || literal.is_boolean() ? literal
                                                         : Json(tree.text);
    }
    case YamlValue::Kind::Null:
    case YamlValue::Kind::Refused:
      break;
  }
  return {};
}

void take_input(YamlValue& root) {
  if (root.find("schema_version") == nullptr) return;
  if (Entry* input = root.find("input")) {
    YamlValue problem = std::move(input->value);
    root = std::move(problem);
    return;
  }
  std::erase_if(root.entries, [](const Entry& entry) {
    return entry.key == "schema_version" || entry.key == "valid" ||
           entry.key == "forecast";
  });
}

void drop_nulls(YamlValue& root) {
  drop_nulls(root, "");
}

}  // namespace brachisto::io
