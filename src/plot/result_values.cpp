// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/result_values.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/text_table.hpp"

namespace brachisto::plot {

using report::Json;

double number(const Json& json, std::string_view key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>()
                                                   : std::nan("");
}

bool is_true(const Json& json, std::string_view key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_boolean() && found->get<bool>();
}

std::string text_of(const Json& json, std::string_view key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>()
                                                   : std::string();
}

std::vector<std::string> words(const Json& json, std::string_view key) {
  std::vector<std::string> out;
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array()) return out;
  for (const Json& one : *found) {
    if (one.is_string()) out.push_back(one.get<std::string>());
  }
  return out;
}

std::string time_text(const Json& result, std::string_view key) {
  const double value = number(result, key);
  return report::with_error(value, number(result, "estimated_error") * value);
}

}  // namespace brachisto::plot
