// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/bounded_json.hpp"

#include <nlohmann/json.hpp>

namespace brachisto::sweep {

std::optional<nlohmann::ordered_json> parse_bounded_json(
    std::string_view text) {
  using Json = nlohmann::ordered_json;
  struct TooMuch {};
  std::size_t events = 0;  // at most two of a value and one of a key
  const auto check = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepestJson || ++events > 3 * kMostJsonValues) throw TooMuch{};
    return true;
  };
  try {
    Json json = Json::parse(text, check, false);
    if (json.is_discarded()) return std::nullopt;
    return json;
  } catch (const TooMuch&) {
    return std::nullopt;
  }
}

}  // namespace brachisto::sweep
