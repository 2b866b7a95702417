// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/key_spec.hpp"
#include "io/source_text.hpp"

namespace brachisto::io {

namespace {

/// Joins the parts that together are a key of the problem: in the section
/// sweep, and only there, such a key is one word with dots.
void join_swept_keys(std::vector<std::string>& parts) {
  for (std::size_t i = 1; i < parts.size(); ++i) {
    std::string key = parts[i];
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      key += '.' + parts[j];
      if (!is_value_key(key)) continue;
      const auto first = parts.begin() + static_cast<std::ptrdiff_t>(i);
      *first = key;
      parts.erase(first + 1,
                  parts.begin() + static_cast<std::ptrdiff_t>(j + 1));
      break;
    }
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
  std::vector<std::string> parts = parts_of(key);
  if (equals == std::string::npos || std::ranges::count(parts, "") > 0) {
    findings.add(position, "",
                 "not an override; expected KEY=VALUE, as in "
                 "scene.body.k=1/2");
    return;
  }
  if (parts.size() > kMaxNesting) {
    findings.add(position, printable(key),
                 fmt::format("nests more than {} levels", kMaxNesting));
    return;
  }
  if (parts.front() == "sweep") join_swept_keys(parts);

  Entry* entry = make_entry(root, parts, position);
  if (entry == nullptr) return;
  YamlValue& value = entry->value;
  value = read_value(text.substr(equals + 1), key, source, findings);
  if (value.kind == YamlValue::Kind::Null) value.position = position;
}

}  // namespace brachisto::io
