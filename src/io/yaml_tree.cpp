// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/yaml_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "math/enum_table.hpp"

namespace brachisto::io {

YamlValue YamlValue::of(Kind kind, Position position, std::string text) {
  YamlValue value;
  value.kind = kind;
  value.position = position;
  value.text = std::move(text);
  return value;
}

Entry* YamlValue::find(std::string_view key) {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &*found;
}

const Entry* YamlValue::find(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &*found;
}

std::string_view kind_name(YamlValue::Kind kind) {
  constexpr auto kNames = table_by<YamlValue::Kind>(
      "no value", "a single value", "a list", "a map", "a refused value");
  return kNames[kind];
}

void refuse_kind(const YamlValue& value, std::string key,
                 std::string_view expected, Findings& findings) {
  if (value.kind == YamlValue::Kind::Refused) return;
  findings.add(
      value.position, std::move(key),
      fmt::format("{} was read; expected {}", kind_name(value.kind), expected));
}

const Entry* find_entry(const YamlValue& root, std::string_view path) {
  const YamlValue* node = &root;
  while (true) {
    const std::size_t dot = path.find('.');
    const Entry* entry = node->find(path.substr(0, dot));
    if (entry == nullptr || dot == std::string_view::npos) return entry;
    node = &entry->value;
    path.remove_prefix(dot + 1);
  }
}

Entry* make_entry(YamlValue& root, const std::vector<std::string>& parts,
                  Position position) {
  YamlValue* node = &root;
  Entry* entry = nullptr;
  for (const std::string& part : parts) {
    if (node->kind == YamlValue::Kind::Null) node->kind = YamlValue::Kind::Map;
    if (node->kind != YamlValue::Kind::Map) return nullptr;
    entry = node->find(part);
    if (entry == nullptr) {
      node->entries.push_back(
          {part, position, YamlValue::of(YamlValue::Kind::Null, position)});
      entry = &node->entries.back();
    }
    node = &entry->value;
  }
  return entry;
}

std::vector<std::string> parts_of(std::string_view key) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t dot = key.find('.');
    parts.emplace_back(key.substr(0, dot));
    if (dot == std::string_view::npos) return parts;
    key.remove_prefix(dot + 1);
  }
}

Position position_of(const YamlValue& root, std::string_view key) {
  const YamlValue* node = &root;
  Position above = root.position;
  for (const std::string& part : parts_of(key)) {
    const Entry* entry = node->find(part);
    if (entry == nullptr) return above;
    above = entry->position;
    node = &entry->value;
  }
  return node->position;
}

}  // namespace brachisto::io
