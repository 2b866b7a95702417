// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// One key of the section `sweep`.

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "io/item_reader.hpp"
#include "io/sweep_section.hpp"

namespace brachisto::io {

KeySpec as_swept(const KeySpec& spec) {
  KeySpec swept = spec;
  swept.value.names = Names::Quantities;
  return swept;
}

namespace {

KeySpec count_item() {
  return number_item("count", KeyType::Integer,
                     {.presence = Presence::Required,
                      .bounds = "from 1 to 10 million",
                      .interval = {1, static_cast<double>(kMaxScenes)}});
}

}  // namespace

KeySpec range_of(const KeySpec& spec, bool counted) {
  KeySpec from = as_swept(spec);
  from.path = "from";
  from.presence = Presence::Required;
  KeySpec to = from;
  to.path = "to";
  if (counted) to.presence = Presence::Optional;
  std::vector<KeySpec> keys{std::move(from), std::move(to)};
  if (counted) keys.push_back(count_item());
  keys.push_back(word_item("spacing", {"linear", "log"}));
  return map_item("", std::move(keys),
                  {.bounds = "a map with from, to and, if need be, spacing"});
}

const std::vector<KeySpec>& keys_beside_swept() {
  static const std::vector<KeySpec> keys = [] {
    const auto said = [](KeySpec spec, std::string_view meaning) {
      spec.description = meaning;
      return spec;
    };
    const KeySpec seed = number_item(
        "seed", KeyType::Integer,
        {.interval = {.lower = 0, .upper = std::numeric_limits<int>::max()}});
    const KeySpec ranges = map_item("ranges", {},
                                    {.presence = Presence::Required,
                                     .bounds = std::string(kExpectedRanges)});
    return std::vector{
        said(map_item("random", {seed, count_item(), ranges},
                      {.bounds = "a map with seed, count and ranges"}),
             "keys that are drawn between two ends"),
        said(word_item("warm_start", {"false", "true"}),
             "start each scene from its neighbour's solution"),
        said(word_item("keep", {"nothing", "tracks"}),
             "what is kept of each scene besides its numbers")};
  }();
  return keys;
}

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
    const bool words = spec_.type() == KeyType::Choice;
    const std::string expected =
        words ? "a list of words: " + io::expected(spec_)
              : "a list, a map with from, to and count, or one number";
    swept_.runs = value.kind != YamlValue::Kind::Scalar;
    if (value.kind == YamlValue::Kind::Scalar) {
      read_values({value});
    } else if (value.kind == YamlValue::Kind::List && !value.items.empty()) {
      read_values(value.items);
    } else if (value.kind == YamlValue::Kind::List) {
      refuse(value.position, "an empty list was read; expected " + expected);
    } else if (value.kind == YamlValue::Kind::Map && !words) {
      read_range();
    } else {
      refuse_kind(value, swept_.key, expected, findings_);
    }
    return std::move(swept_);
  }

  [[nodiscard]] SweepEntry read_sample(std::uint64_t seed) {
    swept_.runs = true;
    if (!is_real(spec_)) {
      refuse(entry_.position,
             "only real numbers can be random, and this key has " +
                 expected(spec_));
    } else if (const auto read = range(false)) {
      swept_.rule = between_ends(*read);
      std::get<NumberRange>(swept_.rule).random =
          RandomStream(seed, spec_.path);
      swept_.readable = true;
    }
    return std::move(swept_);
  }

 private:
  void refuse(Position position, std::string message) {
    findings_.add(position, swept_.key, std::move(message));
  }

  void read_values(const std::vector<YamlValue>& items) {
    const KeySpec spec = as_swept(spec_);
    std::vector<std::string> texts;
    for (const YamlValue& item : items) {
      swept_.positions.push_back(item.position);
      const auto text = read_item(spec, item, item.position, swept_.key,
                                  expected(spec_), findings_);
      if (text) texts.push_back(text->get<std::string>());
    }
    swept_.count = items.size();
    swept_.readable = texts.size() == items.size();
    if (spec_.type() == KeyType::Choice) {
      swept_.rule = std::move(texts);
      return;
    }
    std::vector<Expression> numbers;
    for (const std::string& text : texts) {
      numbers.emplace_back(text, unit_of(spec_));
    }
    swept_.rule = std::move(numbers);
  }

  [[nodiscard]] std::optional<Json> range(bool counted) {
    const KeySpec spec = range_of(spec_, counted);
    return read_item(spec, entry_.value, entry_.position, swept_.key,
                     expected(spec), findings_);
  }

  [[nodiscard]] NumberRange between_ends(const Json& range) const {
    const auto end = [&](const char* name) {
      return Expression(range.at(name).get<std::string>(), unit_of(spec_));
    };
    return {end("from"), end(range.contains("to") ? "to" : "from"),
            range.value("spacing", "linear") == "log" ? Spacing::Log
                                                      : Spacing::Linear};
  }

  void read_range() {
    const std::optional<Json> read = range(true);
    const YamlValue& map = entry_.value;
    const Entry* count = map.find("count");
    const bool single = read ? read->at("count") == 1
                             : count != nullptr && count->value.text == "1";
    swept_.readable = read.has_value();
    const auto refuse_key = [&](std::string_view name, Position position,
                                std::string message) {
      swept_.readable = false;
      findings_.add(position, fmt::format("{}.{}", swept_.key, name),
                    std::move(message));
    };
    if (!single && map.find("to") == nullptr) {
      refuse_key("to", entry_.position,
                 fmt::format("missing; expected {}", expected(spec_)));
    }
    for (const std::string_view unused : {"to", "spacing"}) {
      const Entry* entry = map.find(unused);
      if (!single || entry == nullptr) continue;
      refuse_key(unused, entry->value.position,
                 fmt::format("not used: with count 1 there is only the value "
                             "from; leave {} out",
                             unused));
    }
    if (!read) return;
    swept_.rule = between_ends(*read);
    swept_.count = read->at("count").get<std::size_t>();
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
