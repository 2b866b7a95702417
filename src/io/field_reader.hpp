// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers, and small maps with a few keys of fixed names.

#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/expression.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Why a text is refused where a number is expected.
[[nodiscard]] std::string not_a_number(std::string_view text,
                                       const ExpressionError& error,
                                       std::string_view expected);

/// The number that a value is, integral and within an interval as asked for;
/// otherwise nothing, and a mistake.
/// \param evaluated  makes a number of a text, throws ExpressionError; if it is
///                   left out, as the type asks for
[[nodiscard]] std::optional<double> read_number(
    const YamlValue& value, const std::string& key, KeyType type,
    const Interval& interval, std::string_view expected, Findings& findings,
    const std::function<double(const std::string&)>& evaluated = {});

/// Reads the fields of a map and reports those that it must not have, those
/// that are missing, and those that are not what they have to be.
class FieldReader {
 public:
  /// \param key    dotted, of the map
  /// \param where  its key stands; there a missing field is reported
  FieldReader(const YamlValue& map, std::string key, Position where,
              Findings& findings)
      : map_(map), key_(std::move(key)), where_(where), findings_(findings) {}

  /// Reports all other fields.
  void allow_only(const std::vector<std::string_view>& names) const;

  [[nodiscard]] bool has(std::string_view name) const;

  /// A number that may name quantities; nothing if there is none, which is a
  /// mistake.
  [[nodiscard]] std::optional<Expression> number(std::string_view name,
                                                 const KeySpec& spec) const;

  /// A number as the key that is named like the field has it; nothing if there
  /// is none, which is a mistake.
  [[nodiscard]] std::optional<double> constant(const KeySpec& spec) const;

  /// An integer within an interval. If it is absent: nothing, and a mistake
  /// unless it is optional.
  [[nodiscard]] std::optional<double> integer(std::string_view name,
                                              Interval interval,
                                              std::string_view expected,
                                              bool optional = false) const;

  /// One of some words, the first of them if it is absent.
  [[nodiscard]] std::string_view word(
      std::string_view name, const std::vector<std::string_view>& words) const;

  /// Reports a mistake in a field.
  void refuse(std::string_view name, std::string message) const;

 private:
  /// The field; if it is absent nothing, and a mistake unless it is optional.
  [[nodiscard]] const YamlValue* field(std::string_view name,
                                       std::string_view expected,
                                       bool optional = false) const;
  /// The same, if it is a single value; otherwise reported.
  [[nodiscard]] const YamlValue* scalar(std::string_view name,
                                        std::string_view expected,
                                        bool optional = false) const;

  const YamlValue& map_;
  std::string key_;
  Position where_;
  Findings& findings_;
};

}  // namespace brachisto::io
