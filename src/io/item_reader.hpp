// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers, and values that are no keys of a problem by themselves: items of
/// lists, fields of maps. One KeySpec describes each, by which it is read here
/// and its schema is made.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

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

/// What a value is: a number, or its text if it may name quantities; a word or
/// a text; a list; an object. Nothing if there is a mistake, all of which are
/// reported.
///
/// \param where     there a missing key of a map is reported
/// \param key       dotted
/// \param expected  in words
[[nodiscard]] std::optional<Json> read_item(
    const KeySpec& spec, const YamlValue& value, Position where,
    const std::string& key, const std::string& expected, Findings& findings);

/// A number, a word, a list and a map that are no keys of a problem.
[[nodiscard]] KeySpec number_item(std::string_view name, KeyType type,
                                  KeyRules rules = {});
[[nodiscard]] KeySpec word_item(std::string_view name,
                                std::vector<std::string_view> words,
                                KeyRules rules = {});
[[nodiscard]] KeySpec list_item(std::string_view name, KeySpec item,
                                KeyRules rules);
[[nodiscard]] KeySpec map_item(std::string_view name, std::vector<KeySpec> keys,
                               KeyRules rules = {});

}  // namespace brachisto::io
