// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Lists, whose items are numbers, words or what their key makes of them.

#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/field_reader.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/visible_text.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// The key of a list, what is expected in it, and where mistakes go.
struct ListReader {
  std::string key, wanted;
  Findings& findings;

  ListReader(std::string dotted, std::string expectation, Findings& mistakes)
      : key(std::move(dotted)),
        wanted(std::move(expectation)),
        findings(mistakes) {}
  ListReader(const KeySpec& spec, Findings& mistakes)
      : ListReader(std::string(spec.path), expected(spec), mistakes) {}

  /// Reports what was read, or what is wrong with it, and what is expected.
  void refuse(Position position, std::string_view what,
              std::string_view more = "") const {
    findings.add(position, key,
                 fmt::format("{}; expected {}{}", what, wanted, more));
  }
  void refuse_kind(const YamlValue& value) const {
    io::refuse_kind(value, key, wanted, findings);
  }

  /// Calls `read` for each item of a list, which has to have one.
  template <class Read>
  void each(const YamlValue& list, Read read) const {
    if (list.kind != YamlValue::Kind::List) {
      refuse_kind(list);
    } else if (list.items.empty()) {
      refuse(list.position, "an empty list was read");
    }
    for (const YamlValue& item : list.items) read(item);
  }

  /// An item that is a number within an interval; otherwise nothing, and
  /// reported.
  [[nodiscard]] std::optional<double> number(const YamlValue& item,
                                             KeyType type,
                                             const Interval& interval) const {
    return read_number(item, key, type, interval, wanted, findings);
  }

  /// Which of some words a text is; otherwise nothing, and reported.
  [[nodiscard]] std::optional<std::size_t> word(
      std::string_view text, Position position,
      std::span<const std::string_view> words) const {
    const auto found = std::ranges::find(words, text);
    if (found != words.end()) {
      return static_cast<std::size_t>(found - words.begin());
    }
    findings.add(position, key, unknown_word(text, wanted, words));
    return std::nullopt;
  }
  /// The same of an item.
  [[nodiscard]] std::optional<std::size_t> word(
      const YamlValue& item, std::span<const std::string_view> words) const {
    if (item.kind == YamlValue::Kind::Scalar) {
      return word(item.text, item.position, words);
    }
    refuse_kind(item);
    return std::nullopt;
  }

  /// Adds values that an item stands for, none of which may be there.
  /// \param shown  the item, for a message
  template <class Value>
  void add_once(std::vector<Value>& values, const std::vector<Value>& found,
                const YamlValue& item, std::string_view shown,
                std::string_view more = ", each once") const {
    const bool repeated = std::ranges::any_of(found, [&](const Value& value) {
      return std::ranges::count(values, value) > 0;
    });
    if (repeated) {
      return refuse(item.position, fmt::format("{} is repeated", shown), more);
    }
    values.insert(values.end(), found.begin(), found.end());
  }
};

/// JSON Schemas of a number that may be an expression, and that readers of YAML
/// 1.1 may take for a text, as 1e-4; and of two of them.
[[nodiscard]] Json number_or_text_schema();
[[nodiscard]] Json pair_schema();

}  // namespace brachisto::io
