// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/problem_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "brachisto/io/problem_file.hpp"
#include "io/body_parts.hpp"
#include "io/consistency.hpp"
#include "io/expression.hpp"
#include "io/findings.hpp"
#include "io/input_tree.hpp"
#include "io/item_reader.hpp"
#include "io/path_points.hpp"
#include "io/visible_text.hpp"
#include "math/angle.hpp"

namespace brachisto::io {

namespace {

std::string dotted(std::string_view map, std::string_view key) {
  return map.empty() ? std::string(key) : fmt::format("{}.{}", map, key);
}

/// Maps in which a key of this name is at home.
std::vector<std::string_view> homes_of(std::string_view name) {
  std::vector<std::string_view> homes;
  for (const KeySpec& spec : key_table()) {
    if (spec.name() == name && spec.type() != KeyType::Reserved) {
      homes.push_back(spec.parent().empty() ? "the top level" : spec.parent());
    }
  }
  return homes;
}

std::string allowed_in(std::string_view map) {
  return fmt::format(
      "allowed {}: {}",
      map.empty() ? "at the top level" : fmt::format("in {}", map),
      fmt::join(keys_of(map), ", "));
}

}  // namespace

Draft ProblemReader::read(const YamlValue& root) {
  if (root.kind == YamlValue::Kind::Map || root.kind == YamlValue::Kind::Null) {
    read_map(root, "", root.position);
  } else {
    refuse_kind(root, "", expected({"", {.type = KeyType::Map}, ""}),
                findings_);
  }
  return problem_;
}

void ProblemReader::read_map(const YamlValue& map, std::string_view path,
                             Position position) {
  for (const Entry& entry : map.entries) read_entry(entry, path);
  for (const KeySpec& spec : key_table()) {
    const bool missing = spec.parent() == path &&
                         spec.presence == Presence::Required &&
                         map.find(spec.name()) == nullptr;
    if (!missing) continue;
    findings_.add(position, std::string(spec.path),
                  fmt::format("missing; expected {} ({})", expected(spec),
                              spec.description));
  }
}

void ProblemReader::read_entry(const Entry& entry, std::string_view map) {
  // A dot within a key must not make it look like a path of the table.
  const bool word = entry.key.find('.') == std::string::npos;
  const KeySpec* spec = word ? find_key(dotted(map, entry.key)) : nullptr;
  if (spec == nullptr) {
    refuse_unknown(entry, map);
  } else if (spec->type() == KeyType::Reserved) {
    findings_.add(entry.position, std::string(spec->path),
                  fmt::format("reserved for a later version of brachisto; {}",
                              allowed_in(map)));
  } else if (spec->type() == KeyType::Sweep) {
    findings_.add(entry.position, std::string(spec->path),
                  "this section makes the file a sweep of many scenes, not one "
                  "problem; `brachisto sweep FILE` solves them all");
  } else {
    read_value(*spec, entry);
  }
}

void ProblemReader::refuse_unknown(const Entry& entry, std::string_view map) {
  const auto homes = homes_of(entry.key);
  std::string message;
  if (!homes.empty()) {
    message = fmt::format("misplaced key; it belongs in {}; {}",
                          fmt::join(homes, " or "), allowed_in(map));
  } else if (find_key(entry.key) != nullptr) {
    message = fmt::format(
        "a key with dots; in a file it is written as nested maps; {}",
        allowed_in(map));
  } else {
    message = fmt::format("unknown key; {}{}", allowed_in(map),
                          suggestion(entry.key, keys_of(map)));
  }
  findings_.add(entry.position, dotted(map, printable(entry.key)),
                std::move(message));
}

void ProblemReader::read_value(const KeySpec& spec, const Entry& entry) {
  const YamlValue& node = entry.value;
  if (node.kind == YamlValue::Kind::Refused) return;
  const bool is_map =
      spec.type() == KeyType::Map ||
      (node.kind == YamlValue::Kind::Map && is_choice_or_map(spec));
  if (is_map && (node.kind == YamlValue::Kind::Map ||
                 node.kind == YamlValue::Kind::Null)) {
    read_map(node, spec.path, entry.position);
  } else if (is_map) {
    refuse_kind(node, std::string(spec.path), expected(spec), findings_);
  } else if (is_real(spec) || spec.type() == KeyType::Integer) {
    read_number(spec, node);
  } else {
    read_others(spec, entry);
  }
}

/// A word, a text or a list.
void ProblemReader::read_others(const KeySpec& spec, const Entry& entry) {
  const YamlValue& node = entry.value;
  const std::string key(spec.path);
  const std::string expected = io::expected(spec);
  const auto read =
      read_item(spec, node, entry.position, key, expected, findings_);
  if (!read) return;
  if (spec.type() != KeyType::List) {
    return spec.value.set(problem_, read->get<std::string>());
  }
  const auto [what, item] =
      spec.value.put_list(problem_, *read, spec.value.row);
  if (what.empty()) return;
  findings_.add(
      item < node.items.size() ? node.items[item].position : node.position, key,
      fmt::format("{}; expected {}", what, expected));
}

void ProblemReader::read_number(const KeySpec& spec, const YamlValue& node) {
  const auto value = io::read_number(
      node, std::string(spec.path), spec.type(), spec.interval, expected(spec),
      findings_, [&](const std::string& text) {
        return spec.type() == KeyType::Angle ? read_angle(spec, node)
                                             : evaluate(text);
      });
  if (value) spec.value.set(problem_, *value);
}

double ProblemReader::read_angle(const KeySpec& spec, const YamlValue& node) {
  const Expression written(node.text, Unit::Angle, Names::None);
  const double value = written.value({});
  // Radians that are too large stay what they are, for the scene to refuse.
  const bool reducible =
      written.in_degrees() || std::abs(value) <= kLargestAngle;
  if (std::abs(value) <= math::kTurn || !reducible) return value;
  const double direction = written.direction();
  findings_.warn(
      node.position, std::string(spec.path),
      fmt::format("{} is more than a turn; whole turns mean nothing here, and "
                  "{:.10g} rad is taken, which is {:.10g}°",
                  in_quotes(node.text), direction,
                  math::in_degrees(direction)));
  return direction;
}

ProblemFile read_problem_file(const std::filesystem::path& path,
                              const std::vector<std::string>& overrides) {
  return read_problem_text(read_problem_bytes(path), path.string(), overrides);
}

ProblemFile read_problem_text(std::string_view text, const std::string& name,
                              const std::vector<std::string>& overrides) {
  Findings findings;
  const InputTree input = read_input_tree(text, name, overrides, findings);
  Draft draft = ProblemReader(findings).read(input.root);
  read_path_points(input, nullptr, draft, findings);
  read_body_parts(input.root, draft, findings);
  check_all(input.root, draft, findings);
  findings.throw_if_any(input.sources);
  draft.warnings = findings.warnings(input.sources);
  return draft.problem();
}

}  // namespace brachisto::io
