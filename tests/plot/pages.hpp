// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What pages show, and what all of them have to be.

#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "brachisto/report/result.hpp"

namespace brachisto::testing {

inline constexpr std::size_t kMostBytes = 600'000;

[[nodiscard]] inline bool has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

/// The result that a page is made of.
[[nodiscard]] inline nlohmann::ordered_json document(const Solution& solution) {
  return nlohmann::ordered_json::parse(report::result_json(solution));
}

/// The data within a page.
[[nodiscard]] inline nlohmann::ordered_json data_of(const std::string& page) {
  const std::string head = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(head) + head.size();
  return nlohmann::ordered_json::parse(
      page.substr(begin, page.find("</script>", begin) - begin));
}

/// Nothing of a page is elsewhere.
inline void expect_alone(const std::string& page) {
  for (const char* reference : {" src=", "href=\"http", "href=\"/", "@import",
                                "url(h", "url(/", "url(\"", "url('", "<link"}) {
    EXPECT_FALSE(has(page, reference)) << reference;
  }
}

}  // namespace brachisto::testing
