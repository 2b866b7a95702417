// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "io/field_reader.hpp"
#include "io/suggestion.hpp"

namespace brachisto::io {

namespace {

using Paths = std::vector<std::string_view>;

/// Keys that may vary and fulfil a condition.
template <class Condition>
Paths swept_keys(Condition condition) {
  Paths paths;
  for (const KeySpec& spec : key_table()) {
    if (is_value_key(spec.path) && condition(spec.path)) {
      paths.push_back(spec.path);
    }
  }
  return paths;
}

/// The key of the problem that a key of the section stands for, or nullptr if
/// it is none that may vary.
const KeySpec* find_swept_key(std::string_view key) {
  return is_value_key(key) ? find_key(key) : nullptr;
}

/// Why there is none.
std::string objection_to_swept_key(std::string_view key) {
  const KeySpec* spec = find_key(key);
  if (key == "version") return "the version of the file format cannot vary";
  if (spec != nullptr && spec->type() == KeyType::Reserved) {
    return "reserved for a later version of brachisto";
  }
  const Paths below = swept_keys([&](std::string_view path) {
    return path.starts_with(fmt::format("{}.", key));
  });
  if (!below.empty()) {
    return fmt::format(
        "a map; its keys vary one by one, each written with dots: {}",
        fmt::join(below, ", "));
  }
  const Paths ends = swept_keys([&](std::string_view path) {
    return path.ends_with(fmt::format(".{}", key));
  });
  if (!ends.empty()) {
    return fmt::format("a key that varies is written in full: {}",
                       fmt::join(ends, " or "));
  }
  Paths known = swept_keys([](std::string_view) { return true; });
  known.insert(known.end(), {"zip", "random", "warm_start"});
  return fmt::format(
      "unknown key; allowed in sweep: keys of the problem in full, such as "
      "scene.body.eta_m, and zip, random, warm_start{}",
      suggestion(key, known));
}

constexpr const char* kRandom = "sweep.random";
constexpr const char* kRanges = "sweep.random.ranges";
constexpr const char* kExpectedRanges =
    "a map of the keys that are random, each with from and to";
constexpr Interval kSeeds{0, std::numeric_limits<int>::max()};
constexpr double kDefaultSeed = 1;

class SectionReader {
 public:
  explicit SectionReader(Findings& findings) : findings_(findings) {}

  [[nodiscard]] SweepSection read(const Entry& sweep) {
    for (const Entry& entry : sweep.value.entries) {
      if (entry.key == "random") {
        read_random(entry);
      } else if (entry.key != "zip" && entry.key != "warm_start") {
        read_key(entry, "sweep", [&](const KeySpec& spec, std::string key) {
          return read_sweep_entry(spec, entry, std::move(key), findings_);
        });
      }
    }
    const FieldReader fields(sweep.value, "sweep", sweep.position, findings_);
    section_.warm_start =
        fields.word("warm_start", {"false", "true"}) == "true";
    build_axes(sweep, section_, findings_);
    return std::move(section_);
  }

 private:
  /// Adds the entry that `read` makes of a key, if the key may vary.
  template <class Read>
  void read_key(const Entry& entry, std::string_view map, Read read) {
    std::string key = fmt::format("{}.{}", map, printable(entry.key));
    const KeySpec* spec = find_swept_key(entry.key);
    if (spec == nullptr) {
      findings_.add(entry.position, std::move(key),
                    objection_to_swept_key(entry.key));
    } else if (const SweepEntry* first = section_.find(spec->path)) {
      findings_.add(
          entry.position, std::move(key),
          fmt::format("repeated key; {} varies it already", first->key));
    } else {
      section_.entries.push_back(read(*spec, std::move(key)));
    }
  }

  void read_random(const Entry& random) {
    const YamlValue& map = random.value;
    if (map.kind == YamlValue::Kind::Refused) return;
    if (map.kind != YamlValue::Kind::Map) {
      findings_.add(map.position, kRandom,
                    fmt::format("{} was read; expected a map with seed, count "
                                "and ranges",
                                kind_name(map.kind)));
      return;
    }
    const FieldReader fields(map, kRandom, random.position, findings_);
    fields.allow_only({"seed", "count", "ranges"});
    const auto seed = fields.integer("seed", kSeeds, "an integer, ≥ 0", true);
    const auto count = fields.integer("count", kCounts, kExpectedCount);
    const Entry* ranges = map.find("ranges");
    if (ranges == nullptr) {
      fields.refuse("ranges",
                    fmt::format("missing; expected {}", kExpectedRanges));
      return;
    }
    read_ranges(*ranges,
                static_cast<std::uint64_t>(seed.value_or(kDefaultSeed)),
                static_cast<std::size_t>(count.value_or(1)));
  }

  void read_ranges(const Entry& ranges, std::uint64_t seed, std::size_t count) {
    const YamlValue& map = ranges.value;
    if (map.kind == YamlValue::Kind::Refused) return;
    if (map.kind != YamlValue::Kind::Map || map.entries.empty()) {
      findings_.add(
          map.position, kRanges,
          fmt::format("{} was read; expected {}",
                      map.kind == YamlValue::Kind::Map ? "an empty map"
                                                       : kind_name(map.kind),
                      kExpectedRanges));
    }
    for (const Entry& entry : map.entries) {
      read_key(entry, kRanges, [&](const KeySpec& spec, std::string key) {
        SweepEntry sample =
            read_sample_entry(spec, entry, std::move(key), seed, findings_);
        sample.count = count;
        return sample;
      });
    }
  }

  Findings& findings_;
  SweepSection section_;
};

}  // namespace

const SweepEntry* SweepSection::find(std::string_view path) const {
  const auto found = std::ranges::find_if(
      entries,
      [&](const SweepEntry& entry) { return entry.spec->path == path; });
  return found == entries.end() ? nullptr : &*found;
}

SweepSection read_sweep_section(const Entry& sweep, Findings& findings) {
  const YamlValue& value = sweep.value;
  if (value.kind == YamlValue::Kind::Refused) return {};
  const std::string expected = io::expected(*find_key("sweep"));
  if (value.kind != YamlValue::Kind::Map) {
    findings.add(value.position, "sweep",
                 fmt::format("{} was read; expected {}", kind_name(value.kind),
                             expected));
    return {};
  }
  const std::size_t before = findings.all().size();
  SweepSection section = SectionReader(findings).read(sweep);
  if (section.entries.empty() && findings.all().size() == before) {
    findings.add(sweep.position, "sweep",
                 "no key varies; expected " + expected);
  }
  return section;
}

}  // namespace brachisto::io
