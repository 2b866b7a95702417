// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/key_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace brachisto::io {

namespace {

/// A number as one would write it: 1e-6, not 1e-06.
std::string short_number(double value) {
  std::string text = fmt::format("{}", value);
  if (const std::size_t at = text.find("e-0"); at != std::string::npos) {
    text.erase(at + 2, 1);
  }
  return text;
}

std::string words_of(const Interval& interval) {
  if (std::isinf(interval.lower)) return "";
  if (!interval.tells_upper()) {
    return fmt::format("{} {}", interval.lower_allowed ? "≥" : ">",
                       short_number(interval.lower));
  }
  return fmt::format("from {} to {}", short_number(interval.lower),
                     short_number(interval.upper));
}

/// A value as it stands in a file.
std::string written(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number()) return short_number(value.get<double>());
  std::string text;
  for (const char c : value.dump()) {
    if (c == '"') continue;
    text += c;
    if (c == ',' || c == ':') text += ' ';
  }
  return text;
}

}  // namespace

Json as_json(std::string_view word) {
  if (word == "true" || word == "false") return word == "true";
  return word;
}

Json Binding::get(const Draft& problem) const {
  if (echo != nullptr) return echo(problem, row);
  const std::optional<double> found = number(problem, row);
  if (!found) return {};
  if (type == KeyType::Integer) return static_cast<std::int64_t>(*found);
  if (type == KeyType::Number || type == KeyType::Angle) return *found;
  const auto value = std::ranges::find(values, *found);
  if (value == values.end()) return Json::object();
  return as_json(words[static_cast<std::size_t>(value - values.begin())]);
}

void Binding::set(Draft& problem, const std::string& text) const {
  if (put_text != nullptr) return put_text(problem, text);
  const auto word = std::ranges::find(words, text);
  if (word == words.end()) return;
  put(problem, values[static_cast<std::size_t>(word - words.begin())], row);
}

std::string_view KeySpec::name() const {
  return path.substr(path.rfind('.') + 1);  // npos + 1 = 0
}

std::string_view KeySpec::parent() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? "" : path.substr(0, dot);
}

void KeySpec::complete(const Draft& fresh) {
  if (bounds.empty()) bounds = words_of(interval);
  if (bounds.empty()) bounds = words_of(physical);
  const bool has_default =
      type() != KeyType::Map && value.is_echoed() && !is_required();
  if (fallback.empty() && has_default) fallback = written(value.get(fresh));
}

const KeySpec* find_key(std::string_view path) {
  const std::span<const KeySpec> table = key_table();
  const auto found = std::ranges::find(table, path, &KeySpec::path);
  return found == table.end() ? nullptr : &*found;
}

bool follows_from_parts(const KeySpec& spec) {
  return spec.path == "scene.body.eta_m" || spec.path == "scene.body.theta_m" ||
         spec.path == kInertiaKey || follows_from_inertia(spec);
}

bool follows_from_inertia(const KeySpec& spec) {
  return spec.path == "scene.body.k";
}

bool is_value_key(std::string_view path) {
  const KeySpec* spec = find_key(path);
  if (spec == nullptr || path == "version" ||
      spec->parent() == "work_precision" ||
      (spec->parent() == "design" && spec->name() != "start")) {
    return false;
  }
  return is_real(*spec) || spec->type() == KeyType::Integer ||
         spec->type() == KeyType::Choice;
}

std::vector<std::string_view> keys_of(std::string_view map) {
  std::vector<std::string_view> names;
  for (const KeySpec& spec : key_table()) {
    if (spec.parent() == map && spec.type() != KeyType::Reserved) {
      names.push_back(spec.name());
    }
  }
  return names;
}

std::vector<std::string_view> keys_of(const KeySpec& map) {
  if (map.value.items.empty()) return keys_of(map.path);
  std::vector<std::string_view> names;
  for (const KeySpec& key : map.value.items) names.push_back(key.path);
  return names;
}

bool is_choice_or_map(const KeySpec& spec) {
  return spec.type() == KeyType::Choice && !keys_of(spec.path).empty();
}

Unit unit_of(const KeySpec& spec) {
  return spec.type() == KeyType::Angle ? Unit::Angle : Unit::None;
}

std::optional<KeyWord> word_that_uses(const KeySpec& spec, const Draft& draft) {
  for (const char* path : {"solver.method", "discretisation.formulation",
                           "solver.fsolve.variant"}) {
    const KeySpec* key = find_key(path);
    for (const std::string_view word : key->value.words) {
      Draft other = draft;
      key->value.set(other, std::string(word));
      if (spec.used(other)) return KeyWord{key, word};
    }
  }
  return std::nullopt;
}

std::string expected(const KeySpec& spec) {
  std::string text;
  switch (spec.type()) {
    case KeyType::Map:
      if (!spec.bounds.empty()) return spec.bounds;
      return fmt::format("a map with the keys {}",
                         fmt::join(keys_of(spec), ", "));
    case KeyType::Choice:
      return fmt::format(
          "{}{}{}", fmt::join(spec.value.words, " or "),
          is_choice_or_map(spec) ? " or a map with the key " : "",
          fmt::join(keys_of(spec.path), ", "));
    case KeyType::Text:
    case KeyType::List:
      return spec.bounds;
    case KeyType::Sweep:
      return "a map of the keys that vary, as in {scene.body.eta_m: [0, 1/3]}";
    case KeyType::Reserved:
      return "nothing";
    case KeyType::Angle:
      return "an angle in rad or, as in 30 deg, in degrees";
    case KeyType::Integer:
      text = "an integer";
      break;
    case KeyType::Number:
      text = "a number";
      break;
  }
  if (!spec.unit.empty()) text += fmt::format(" in {}", spec.unit);
  if (!spec.bounds.empty()) text += ", " + spec.bounds;
  return text;
}

}  // namespace brachisto::io
