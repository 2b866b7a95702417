// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// One key of the section `sweep`.

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "io/field_reader.hpp"
#include "io/sweep_section.hpp"

namespace brachisto::io {

namespace {

/// Reads an entry by itself. Words are checked here; of numbers it is seen
/// scene by scene whether they are within their bounds.
class EntryReader {
 public:
  EntryReader(const KeySpec& spec, const Entry& entry, std::string key,
              Findings& findings)
      : spec_(spec), entry_(entry), findings_(findings) {
    swept_.spec = &spec;
    swept_.key = std::move(key);
    swept_.key_position = entry.position;
    swept_.position = entry.value.position;
  }

  [[nodiscard]] SweepEntry read() {
    const YamlValue& value = entry_.value;
    switch (value.kind) {
      case YamlValue::Kind::List:
        swept_.runs = true;
        read_list(value.items);
        break;
      case YamlValue::Kind::Scalar:
        read_list({value});
        break;
      case YamlValue::Kind::Map:
        swept_.runs = true;
        read_range(value);
        break;
      case YamlValue::Kind::Null:
      case YamlValue::Kind::Refused:
        refuse_kind(value, swept_.key, expected_rule(), findings_);
        break;
    }
    return std::move(swept_);
  }

  [[nodiscard]] SweepEntry read_sample(std::uint64_t seed) {
    swept_.runs = true;
    const YamlValue& value = entry_.value;
    const bool real =
        spec_.type() == KeyType::Number || spec_.type() == KeyType::Angle;
    if (!real) {
      refuse(entry_.position,
             "only real numbers can be random, and this key has " +
                 expected(spec_));
    } else if (value.kind == YamlValue::Kind::Map) {
      const FieldReader fields(value, swept_.key, entry_.position, findings_);
      fields.allow_only({"from", "to", "spacing"});
      auto from = fields.number("from", spec_);
      auto to = fields.number("to", spec_);
      const Spacing spacing = spacing_of(fields);
      if (from && to) {
        swept_.rule = NumberRange{*std::move(from), *std::move(to), spacing,
                                  RandomStream(seed, spec_.path)};
        swept_.readable = true;
      }
    } else {
      refuse_kind(value, swept_.key,
                  "a map with from, to and, if need be, spacing", findings_);
    }
    return std::move(swept_);
  }

 private:
  void refuse(Position position, std::string message) {
    findings_.add(position, swept_.key, std::move(message));
  }

  [[nodiscard]] std::string expected_rule() const {
    return spec_.type() == KeyType::Choice
               ? "a list of words: " + expected(spec_)
               : "a list, a map with from, to and count, or one number";
  }

  void read_list(const std::vector<YamlValue>& items) {
    if (items.empty()) {
      refuse(swept_.position,
             "an empty list was read; expected " + expected_rule());
      return;
    }
    const std::size_t before = findings_.all().size();
    std::vector<std::string> words;
    std::vector<Expression> numbers;
    for (const YamlValue& item : items) {
      swept_.positions.push_back(item.position);
      if (item.kind == YamlValue::Kind::Refused) return;
      if (item.kind != YamlValue::Kind::Scalar) {
        refuse_kind(item, swept_.key, expected(spec_), findings_);
      } else if (spec_.type() == KeyType::Choice) {
        words.push_back(read_word(item));
      } else {
        read_number(item, numbers);
      }
    }
    swept_.count = items.size();
    swept_.readable = findings_.all().size() == before;
    if (spec_.type() == KeyType::Choice) {
      swept_.rule = std::move(words);
    } else {
      swept_.rule = std::move(numbers);
    }
  }

  [[nodiscard]] std::string read_word(const YamlValue& item) {
    std::string message = objection(spec_, item.text);
    if (!message.empty()) refuse(item.position, std::move(message));
    return item.text;
  }

  void read_number(const YamlValue& item, std::vector<Expression>& numbers) {
    try {
      numbers.emplace_back(item.text, unit_of(spec_));
    } catch (const ExpressionError& error) {
      refuse(item.position, not_a_number(item.text, error, expected(spec_)));
    }
  }

  void read_range(const YamlValue& map) {
    if (spec_.type() == KeyType::Choice) {
      return refuse_kind(map, swept_.key, expected_rule(), findings_);
    }
    const std::size_t before = findings_.all().size();
    const FieldReader fields(map, swept_.key, entry_.position, findings_);
    fields.allow_only({"from", "to", "count", "spacing"});
    auto from = fields.number("from", spec_);
    const auto count = fields.integer("count", kCounts, kExpectedCount);
    auto to = from;
    if (count != 1.0) {
      to = fields.number("to", spec_);
    } else {
      for (const std::string_view unused : {"to", "spacing"}) {
        if (!fields.has(unused)) continue;
        fields.refuse(unused,
                      fmt::format("not used: with count 1 there is only the "
                                  "value from; leave {} out",
                                  unused));
      }
    }
    const Spacing spacing = spacing_of(fields);
    if (from && to && count) {
      swept_.rule = NumberRange{*std::move(from), *std::move(to), spacing};
      swept_.count = static_cast<std::size_t>(*count);
    }
    swept_.readable = findings_.all().size() == before;
  }

  static Spacing spacing_of(const FieldReader& fields) {
    return fields.word("spacing", {"linear", "log"}) == "log" ? Spacing::Log
                                                              : Spacing::Linear;
  }

  const KeySpec& spec_;
  const Entry& entry_;
  Findings& findings_;
  SweepEntry swept_;
};

}  // namespace

SweepEntry read_sweep_entry(const KeySpec& spec, const Entry& entry,
                            std::string key, Findings& findings) {
  return EntryReader(spec, entry, std::move(key), findings).read();
}

SweepEntry read_sample_entry(const KeySpec& spec, const Entry& entry,
                             std::string key, std::uint64_t seed,
                             Findings& findings) {
  return EntryReader(spec, entry, std::move(key), findings).read_sample(seed);
}

}  // namespace brachisto::io
