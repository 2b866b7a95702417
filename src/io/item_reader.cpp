// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/item_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

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
    // No −0, which would be shown so.
    if (integral && interval.contains(number)) return number + 0.0;
    const bool beyond = number > interval.upper && !interval.tells_upper();
    return refuse(fmt::format(
        "{} is not {}; expected {}{}", in_quotes(value.text),
        integral ? "allowed" : "an integer", expected,
        beyond ? fmt::format(", at most {:.0f}", interval.upper) : ""));
  } catch (const ExpressionError& error) {
    return refuse(not_a_number(value.text, error, expected));
  }
}

namespace {

using Item = std::optional<Json>;
using Kind = YamlValue::Kind;

/// One value.
class ItemReader {
 public:
  ItemReader(const KeySpec& spec, const YamlValue& value, Position where,
             const std::string& key, const std::string& expected,
             Findings& findings)
      : spec_(spec),
        value_(value),
        where_(where),
        key_(key),
        expected_(expected),
        findings_(findings) {}

  [[nodiscard]] Item read() const {
    if (spec_.type() == KeyType::Map && value_.kind == Kind::Map) {
      return map();
    }
    if (spec_.type() == KeyType::List && value_.kind == Kind::List) {
      return list();
    }
    if (spec_.type() == KeyType::Map || spec_.type() == KeyType::List ||
        value_.kind != Kind::Scalar) {
      refuse_kind(value_, key_, expected_, findings_);
      return std::nullopt;
    }
    if (spec_.type() == KeyType::Text) return value_.text;
    return spec_.type() == KeyType::Choice ? word() : number();
  }

 private:
  Item refuse(Position position, std::string_view what,
              std::string_view more = "") const {
    findings_.add(position, key_,
                  fmt::format("{}; expected {}{}", what, expected_, more));
    return std::nullopt;
  }

  [[nodiscard]] Item number() const {
    if (spec_.value.names != Names::None) {
      const auto text = [&](const std::string& written) {
        (void)Expression(written, unit_of(spec_), spec_.value.names);
        return 0.0;
      };
      return read_number(value_, key_, KeyType::Number, {}, expected_,
                         findings_, text)
                 ? Item(value_.text)
                 : std::nullopt;
    }
    const auto number = read_number(value_, key_, spec_.type(), spec_.interval,
                                    expected_, findings_);
    if (!number) return std::nullopt;
    if (spec_.type() != KeyType::Integer) return *number;
    return static_cast<std::int64_t>(*number);
  }

  [[nodiscard]] Item word() const {
    if (std::ranges::count(spec_.value.words, value_.text) > 0) {
      return value_.text;
    }
    findings_.add(value_.position, key_,
                  unknown_word(value_.text, expected_, spec_.value.words));
    return std::nullopt;
  }

  [[nodiscard]] Item list() const {
    const std::size_t size = value_.items.size();
    if (size == 0) return refuse(value_.position, "an empty list was read");
    if (spec_.value.count != 0 && size != spec_.value.count) {
      return refuse(value_.position,
                    fmt::format("a list of {} was read", size));
    }
    Json all = Json::array();
    bool good = true;
    for (const YamlValue& value : value_.items) {
      Item item = this->item(value);
      good = good && item;
      if (!item) continue;
      if (spec_.value.once && std::ranges::count(all, *item) > 0) {
        refuse(
            value.position,
            fmt::format("{} is repeated",
                        value.text.empty() ? "an item" : in_quotes(value.text)),
            ", each once");
        good = false;
      }
      all.push_back(*std::move(item));
    }
    return good ? Item(std::move(all)) : std::nullopt;
  }

  /// An item of the list.
  [[nodiscard]] Item item(const YamlValue& value) const {
    const auto kind = [](const KeySpec& spec) {
      return spec.type() == KeyType::Map    ? Kind::Map
             : spec.type() == KeyType::List ? Kind::List
                                            : Kind::Scalar;
    };
    const auto& kinds = spec_.value.items;
    const auto found = std::ranges::find(kinds, value.kind, kind);
    const KeySpec& spec = found == kinds.end() ? kinds.front() : *found;
    return read_item(
        spec, value, value.position, key_,
        spec.type() == KeyType::List ? io::expected(spec) : expected_,
        findings_);
  }

  [[nodiscard]] Item map() const {
    const auto& keys = spec_.value.items;
    const bool one_of = spec_.value.one_of;
    if (one_of && value_.entries.size() != 1) {
      return refuse(value_.position, fmt::format("a map of {} keys was read",
                                                 value_.entries.size()));
    }
    Json all = Json::object();
    if (keys.empty()) return all;  // who asks sees to them
    bool good = true;
    for (const Entry& entry : value_.entries) {
      const auto found = std::ranges::find(keys, entry.key, &KeySpec::path);
      Item item =
          found == keys.end()
              ? unknown(entry)
              : read_item(*found, entry.value, entry.position, below(entry.key),
                          io::expected(*found), findings_);
      good = good && item;
      if (item) all[entry.key] = *std::move(item);
    }
    for (const KeySpec& key : keys) {
      if (one_of || !key.is_required() || value_.find(key.path) != nullptr) {
        continue;
      }
      good = false;
      findings_.add(where_, below(key.path),
                    fmt::format("missing; expected {}", io::expected(key)));
    }
    return good ? Item(std::move(all)) : std::nullopt;
  }

  [[nodiscard]] Item unknown(const Entry& entry) const {
    const auto names = keys_of(spec_);
    if (spec_.value.one_of) {
      findings_.add(entry.position, key_,
                    unknown_word(entry.key, expected_, names));
    } else {
      findings_.add(
          entry.position, below(printable(entry.key)),
          fmt::format("unknown key; allowed in {}: {}{}", key_,
                      fmt::join(names, ", "), suggestion(entry.key, names)));
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string below(std::string_view name) const {
    return fmt::format("{}.{}", key_, name);
  }

  const KeySpec& spec_;
  const YamlValue& value_;
  Position where_;
  const std::string& key_;
  const std::string& expected_;
  Findings& findings_;
};

}  // namespace

std::optional<Json> read_item(const KeySpec& spec, const YamlValue& value,
                              Position where, const std::string& key,
                              const std::string& expected, Findings& findings) {
  return ItemReader(spec, value, where, key, expected, findings).read();
}

KeySpec number_item(std::string_view name, KeyType type, KeyRules rules) {
  KeySpec spec(name, {.type = type}, "", std::move(rules));
  spec.complete({});
  return spec;
}

KeySpec word_item(std::string_view name, std::vector<std::string_view> words,
                  KeyRules rules) {
  return {name,
          {.type = KeyType::Choice, .words = std::move(words)},
          "",
          std::move(rules)};
}

KeySpec list_item(std::string_view name, KeySpec item, KeyRules rules) {
  return {name,
          {.type = KeyType::List, .items = {std::move(item)}},
          "",
          std::move(rules)};
}

KeySpec map_item(std::string_view name, std::vector<KeySpec> keys,
                 KeyRules rules) {
  return {name,
          {.type = KeyType::Map, .items = std::move(keys)},
          "",
          std::move(rules)};
}

}  // namespace brachisto::io
