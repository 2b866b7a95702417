// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What keys demand of each other, and how it is told that they do not fit.

#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "io/draft.hpp"
#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// A problem whose keys were read one by one.
struct Check {
  const YamlValue& root;  ///< as it is written
  const Draft& problem;   ///< as it was read
  Findings& findings;

  [[nodiscard]] const Entry* entry(std::string_view key) const {
    return find_entry(root, key);
  }
  /// The entry of a key, unless there is none or a mistake in it.
  [[nodiscard]] const Entry* sound_entry(std::string_view key) const {
    return findings.concern(key) ? nullptr : entry(key);
  }

  /// A mistake in a value, or in the lack of one.
  template <class... Values>
  void refuse(std::string_view key, fmt::format_string<Values...> why,
              Values&&... values) const {
    findings.add(position_of(root, key), std::string(key),
                 fmt::format(why, std::forward<Values>(values)...));
  }
  /// The same in that a key is there.
  template <class... Values>
  void refuse_key(std::string_view key, fmt::format_string<Values...> why,
                  Values&&... values) const {
    findings.add(entry(key)->position, std::string(key),
                 fmt::format(why, std::forward<Values>(values)...));
  }
};

/// Refuses designs without a body or without a best one, and ways of solving
/// that a design does not go.
void check_design(const Check& check);

}  // namespace brachisto::io
