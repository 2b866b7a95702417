// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/key_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/findings.hpp"
#include "io/suggestion.hpp"

namespace brachisto::io {

std::string_view KeySpec::name() const {
  return path.substr(path.rfind('.') + 1);  // npos + 1 = 0
}

std::string_view KeySpec::parent() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? "" : path.substr(0, dot);
}

const KeySpec* find_key(std::string_view path) {
  const std::span<const KeySpec> table = key_table();
  const auto found = std::ranges::find(table, path, &KeySpec::path);
  return found == table.end() ? nullptr : &*found;
}

bool is_value_key(std::string_view path) {
  const KeySpec* spec = find_key(path);
  if (spec == nullptr || path == "version" ||
      spec->parent() == "work_precision") {
    return false;
  }
  return spec->type() == KeyType::Number || spec->type() == KeyType::Angle ||
         spec->type() == KeyType::Integer || spec->type() == KeyType::Choice;
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

Unit unit_of(const KeySpec& spec) {
  return spec.type() == KeyType::Angle ? Unit::Angle : Unit::None;
}

std::optional<KeyWord> word_that_uses(const KeySpec& spec, const Draft& draft) {
  for (const char* path : {"solver.method", "discretisation.formulation",
                           "solver.fsolve.variant"}) {
    const KeySpec* key = find_key(path);
    for (const std::string_view word : key->value.words) {
      Draft other = draft;
      key->value.set(other, word);
      if (spec.used(other)) return KeyWord{key, word};
    }
  }
  return std::nullopt;
}

std::string objection(const KeySpec& spec, std::string_view word) {
  if (std::ranges::count(spec.value.words, word) > 0) return "";
  return fmt::format("{} was read; expected {}{}", in_quotes(word),
                     expected(spec), suggestion(word, spec.value.words));
}

std::string expected(const KeySpec& spec) {
  std::string text;
  switch (spec.type()) {
    case KeyType::Map:
      return fmt::format("a map with the keys {}",
                         fmt::join(keys_of(spec.path), ", "));
    case KeyType::Choice:
      return fmt::format("{}", fmt::join(spec.value.words, " or "));
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
