// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/result_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/scale.hpp"
#include "report/text_table.hpp"
#include "trajectory/grip.hpp"

namespace brachisto::plot {

using report::Json;

const Json& at(const Json& json, std::string_view key) {
  static const Json kNull;
  if (!json.is_object()) return kNull;
  const auto found = json.find(key);
  return found == json.end() ? kNull : *found;
}

double number(const Json& json, std::string_view key) {
  const Json& value = at(json, key);
  return value.is_number() ? value.get<double>() : std::nan("");
}

bool is_true(const Json& json, std::string_view key) {
  return at(json, key) == true;
}

std::string text_of(const Json& json, std::string_view key) {
  const Json& value = at(json, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::vector<std::string> words(const Json& json, std::string_view key) {
  std::vector<std::string> out;
  for (const Json& one : at(json, key)) {
    if (one.is_string()) out.push_back(one.get<std::string>());
  }
  return out;
}

std::string time_text(const Json& result, std::string_view key) {
  const double value = number(result, key);
  return report::with_error(value, number(result, "estimated_error") * value);
}

std::string force_text(const Json& result) {
  const Json& force = at(result, "normal_force");
  if (!force.is_object()) return {};
  return fmt::format("{} to {} m g",
                     report::printed(told_force(number(force, "min")), 4),
                     report::printed(number(force, "max"), 4));
}

std::string version_in(const Json& result) {
  return text_of(at(result, "provenance"), "brachisto");
}

}  // namespace brachisto::plot
