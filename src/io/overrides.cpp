// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/overrides.hpp"

#include <optional>
#include <vector>

#include "io/source_text.hpp"

namespace brachisto::io {

namespace {

/// Parts of a dotted key, nothing if one of them is empty.
std::optional<std::vector<std::string>> parts_of(const std::string& key) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t dot = key.find('.', begin);
    parts.push_back(key.substr(begin, dot - begin));
    if (parts.back().empty()) return std::nullopt;
    if (dot == std::string::npos) return parts;
    begin = dot + 1;
  }
}

/// Reads the value; one that is not YAML becomes a refused node.
YamlValue read_value(const std::string& text, const std::string& key,
                     int source, Findings& findings) {
  try {
    return parse_yaml(prepared_text(text, source), source, findings, key);
  } catch (const SyntaxError& error) {
    findings.add(error.position, printable(key), error.what());
    return YamlValue::of(YamlValue::Kind::Refused, error.position);
  }
}

}  // namespace

void apply_override(YamlValue& root, const std::string& text, int source,
                    Findings& findings) {
  const Position position{source, 1, 1};
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const auto parts = parts_of(key);
  if (equals == std::string::npos || !parts) {
    findings.add(position, "",
                 "not an override; expected KEY=VALUE, as in "
                 "scene.body.k=1/2");
    return;
  }

  YamlValue* node = &root;
  for (const std::string& part : *parts) {
    if (node->kind == YamlValue::Kind::Null) node->kind = YamlValue::Kind::Map;
    if (node->kind != YamlValue::Kind::Map) return;
    Entry* entry = node->find(part);
    if (entry == nullptr) {
      node->entries.push_back(
          {part, position, YamlValue::of(YamlValue::Kind::Null, position)});
      entry = &node->entries.back();
    }
    node = &entry->value;
  }
  *node = read_value(text.substr(equals + 1), key, source, findings);
  if (node->kind == YamlValue::Kind::Null) node->position = position;
}

}  // namespace brachisto::io
