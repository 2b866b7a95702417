// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/field_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/visible_text.hpp"

namespace brachisto::io {

std::string not_a_number(std::string_view text, const ExpressionError& error,
                         std::string_view expected) {
  return fmt::format("{} is not a number: {}; expected {}", in_quotes(text),
                     error.what(), expected);
}

std::optional<double> read_number(
    const YamlValue& value, const std::string& key, KeyType type,
    const Interval& interval, std::string_view expected, Findings& findings,
    const std::function<double(const std::string&)>& evaluated) {
  const auto refuse = [&](std::string message) {
    findings.add(value.position, key, std::move(message));
    return std::nullopt;
  };
  if (value.kind != YamlValue::Kind::Scalar) {
    refuse_kind(value, key, expected, findings);
    return std::nullopt;
  }
  try {
    const double number =
        evaluated ? evaluated(value.text)
                  : evaluate(value.text,
                             type == KeyType::Angle ? Unit::Angle : Unit::None);
    const bool integral =
        type != KeyType::Integer || number == std::trunc(number);
    if (integral && interval.contains(number)) return number;
    return refuse(fmt::format("{} is not {}; expected {}",
                              in_quotes(value.text),
                              integral ? "allowed" : "an integer", expected));
  } catch (const ExpressionError& error) {
    return refuse(not_a_number(value.text, error, expected));
  }
}

void FieldReader::allow_only(const std::vector<std::string_view>& names) const {
  for (const Entry& entry : map_.entries) {
    if (std::ranges::count(names, entry.key) > 0) continue;
    findings_.add(
        entry.position, fmt::format("{}.{}", key_, printable(entry.key)),
        fmt::format("unknown key; allowed in {}: {}{}", key_,
                    fmt::join(names, ", "), suggestion(entry.key, names)));
  }
}

bool FieldReader::has(std::string_view name) const {
  return map_.find(name) != nullptr;
}

void FieldReader::refuse(std::string_view name, std::string message) const {
  const Entry* entry = map_.find(name);
  findings_.add(entry != nullptr ? entry->value.position : where_,
                fmt::format("{}.{}", key_, name), std::move(message));
}

const YamlValue* FieldReader::field(std::string_view name,
                                    std::string_view expected,
                                    bool optional) const {
  if (const Entry* entry = map_.find(name)) return &entry->value;
  if (!optional) refuse(name, fmt::format("missing; expected {}", expected));
  return nullptr;
}

const YamlValue* FieldReader::scalar(std::string_view name,
                                     std::string_view expected,
                                     bool optional) const {
  const YamlValue* value = field(name, expected, optional);
  if (value == nullptr || value->kind == YamlValue::Kind::Scalar) return value;
  refuse_kind(*value, fmt::format("{}.{}", key_, name), expected, findings_);
  return nullptr;
}

std::optional<Expression> FieldReader::number(std::string_view name,
                                              const KeySpec& spec) const {
  const std::string expected = io::expected(spec);
  const YamlValue* value = scalar(name, expected);
  if (value == nullptr) return std::nullopt;
  try {
    return Expression(value->text, unit_of(spec));
  } catch (const ExpressionError& error) {
    refuse(name, not_a_number(value->text, error, expected));
    return std::nullopt;
  }
}

std::optional<double> FieldReader::constant(const KeySpec& spec) const {
  const std::string expected = io::expected(spec);
  const YamlValue* value = field(spec.name(), expected);
  if (value == nullptr) return std::nullopt;
  return read_number(*value, fmt::format("{}.{}", key_, spec.name()),
                     spec.type(), spec.interval, expected, findings_);
}

std::optional<double> FieldReader::integer(std::string_view name,
                                           Interval interval,
                                           std::string_view expected,
                                           bool optional) const {
  const YamlValue* value = field(name, expected, optional);
  if (value == nullptr) return std::nullopt;
  return read_number(*value, fmt::format("{}.{}", key_, name), KeyType::Integer,
                     interval, expected, findings_);
}

std::string_view FieldReader::word(
    std::string_view name, const std::vector<std::string_view>& words) const {
  const std::string expected = fmt::format("{}", fmt::join(words, " or "));
  const YamlValue* value = scalar(name, expected, true);
  if (value == nullptr) return words.front();
  const auto found = std::ranges::find(words, value->text);
  if (found != words.end()) return *found;
  refuse(name, unknown_word(value->text, expected, words));
  return words.front();
}

}  // namespace brachisto::io
