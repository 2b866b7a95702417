// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/key_spec.hpp"
#include "io/key_table.hpp"

namespace brachisto::io {

namespace {

std::string_view type_name(KeyType type) {
  switch (type) {
    case KeyType::Map:
    case KeyType::Sweep:
      return "map";
    case KeyType::Number:
      return "number";
    case KeyType::Angle:
      return "angle";
    case KeyType::Integer:
      return "integer";
    case KeyType::Choice:
      return "word";
    case KeyType::Text:
      return "text";
    case KeyType::List:
      return "list";
    case KeyType::Reserved:
      break;
  }
  return "reserved";
}

std::string default_text(const KeySpec& spec) {
  switch (spec.presence) {
    case Presence::Required:
      return "required";
    case Presence::RequiredOfCylinder:
      return "required (cylinder)";
    case Presence::OptionalOfCylinder:
      return fmt::format("{} (cylinder)", spec.fallback);
    case Presence::Optional:
      break;
  }
  return spec.fallback.empty() ? "—" : std::string(spec.fallback);
}

std::string allowed_text(const KeySpec& spec) {
  if (spec.type() == KeyType::Choice) {
    return fmt::format("`{}`", fmt::join(spec.value.words, "`, `"));
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

}  // namespace brachisto::io
