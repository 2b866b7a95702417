// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "io/item_reader.hpp"
#include "io/visible_text.hpp"

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
  known.insert(known.end(), {"zip", "random", "warm_start", "keep"});
  return fmt::format(
      "unknown key; allowed in sweep: keys of the problem in full, such as "
      "scene.body.eta_m, and zip, random, warm_start, keep{}",
      suggestion(key, known));
}

constexpr const char* kRanges = "sweep.random.ranges";
constexpr const char* kZip = "sweep.zip";
constexpr const char* kExpectedZip =
    "a list of keys that run together, or a list of such lists";

bool is_random(const SweepEntry& entry) {
  const auto* range = std::get_if<NumberRange>(&entry.rule);
  return range != nullptr && range->random;
}

/// Finds out which entries share an axis.
class AxisBuilder {
 public:
  AxisBuilder(SweepSection& section, Findings& findings)
      : section_(section),
        findings_(findings),
        leaders_(section.entries.size()) {
    std::iota(leaders_.begin(), leaders_.end(), std::size_t{0});
  }

  void share_random() {
    const auto& entries = section_.entries;
    const auto first = std::ranges::find_if(entries, is_random);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (!is_random(entries[i])) continue;
      leaders_[i] = static_cast<std::size_t>(first - entries.begin());
    }
  }

  void read_zip(const YamlValue& zip) {
    const auto is_list = [](const YamlValue& item) {
      return item.kind == YamlValue::Kind::List;
    };
    if (zip.kind != YamlValue::Kind::List) {
      refuse_kind(zip, kZip, kExpectedZip, findings_);
    } else if (std::ranges::all_of(zip.items, is_list)) {
      for (const YamlValue& list : zip.items) read_list(list);
    } else {
      read_list(zip);
    }
  }

  void build() {
    for (std::size_t i = 0; i < leaders_.size(); ++i) {
      const SweepEntry& entry = section_.entries[i];
      if (!entry.runs || leaders_[i] != i) continue;
      SweepFileAxis axis{{}, entry.count, !is_random(entry)};
      for (std::size_t j = i; j < leaders_.size(); ++j) {
        if (leaders_[j] == i) axis.keys.push_back(j);
      }
      section_.axes.push_back(std::move(axis));
    }
  }

 private:
  void refuse(Position position, std::string message) {
    findings_.add(position, kZip, std::move(message));
  }

  void read_list(const YamlValue& list) {
    std::vector<std::size_t> members;
    bool good = true;
    for (const YamlValue& item : list.items) {
      const std::size_t member = read_member(item);
      good = good && member < leaders_.size();
      if (good) members.push_back(member);
    }
    if (!good) return;
    if (members.size() < 2) {
      refuse(list.position, "two keys at least have to run together");
      return;
    }
    check_counts(members, list.position);
    const std::size_t leader = *std::ranges::min_element(members);
    for (const std::size_t member : members) leaders_[member] = leader;
  }

  /// The entry that is named; their number if there is a mistake.
  [[nodiscard]] std::size_t read_member(const YamlValue& item) {
    const auto& entries = section_.entries;
    const auto found = std::ranges::find_if(entries, [&](const auto& entry) {
      return entry.spec->path == item.text;
    });
    if (item.kind != YamlValue::Kind::Scalar) {
      refuse_kind(item, kZip, kExpectedZip, findings_);
    } else if (found == entries.end()) {
      std::vector<std::string_view> keys;
      keys.reserve(entries.size());
      for (const SweepEntry& entry : entries) keys.push_back(entry.spec->path);
      refuse(item.position,
             fmt::format("{} does not vary in this sweep; these do: {}{}",
                         in_quotes(item.text), fmt::join(keys, ", "),
                         suggestion(item.text, keys)));
    } else if (is_random(*found)) {
      refuse(item.position,
             item.text + " is random, and all random keys run together anyway");
    } else if (!found->runs) {
      refuse(item.position,
             item.text + " has no list and no range to run along");
    } else if (!zipped_.insert(item.text).second) {
      refuse(item.position, item.text + " is named twice");
    } else {
      return static_cast<std::size_t>(found - entries.begin());
    }
    return entries.size();
  }

  void check_counts(const std::vector<std::size_t>& members,
                    Position position) {
    std::vector<std::string> counts;
    std::set<std::size_t> different;
    for (const std::size_t member : members) {
      const SweepEntry& entry = section_.entries[member];
      if (!entry.readable) return;
      different.insert(entry.count);
      counts.push_back(fmt::format("{} has {}", entry.spec->path, entry.count));
    }
    if (different.size() == 1) return;
    refuse(position,
           fmt::format("keys that run together need equally many values: {}",
                       fmt::join(counts, ", ")));
  }

  SweepSection& section_;
  Findings& findings_;
  std::vector<std::size_t> leaders_;  ///< first entry on the axis of each
  std::set<std::string> zipped_;
};

void check_size(const SweepSection& section, Position position,
                Findings& findings) {
  std::size_t scenes = 1;
  std::vector<std::size_t> counts;
  bool too_many = false;
  for (const SweepFileAxis& axis : section.axes) {
    counts.push_back(axis.count);
    too_many = too_many || axis.count > kMaxScenes / scenes;
    if (!too_many) scenes *= axis.count;
  }
  if (!too_many) return;
  findings.add(position, "sweep",
               fmt::format("{} scenes are too many; allowed are 10 million",
                           fmt::join(counts, " × ")));
}

/// Fills in the axes of a section whose entries are known.
///
/// An entry makes an axis of its own, but for those that `zip` makes run
/// together and for random ones, all of which share one; an axis stands where
/// the first of its entries does.
///
/// \param sweep  the whole section
/// Mistakes in `zip`, and too many scenes, go to the findings.
void build_axes(const Entry& sweep, SweepSection& section, Findings& findings) {
  AxisBuilder builder(section, findings);
  builder.share_random();
  if (const Entry* zip = sweep.value.find("zip")) builder.read_zip(zip->value);
  builder.build();
  check_size(section, sweep.position, findings);
}

class SectionReader {
 public:
  explicit SectionReader(Findings& findings) : findings_(findings) {}

  [[nodiscard]] SweepSection read(const Entry& sweep) {
    for (const Entry& entry : sweep.value.entries) {
      const auto& others = keys_beside_swept();
      const auto other = std::ranges::find(others, entry.key, &KeySpec::path);
      if (other != others.end()) {
        read_other(*other, entry);
      } else if (entry.key != "zip") {
        read_key(entry, "sweep", [&](const KeySpec& spec, std::string key) {
          return read_sweep_entry(spec, entry, std::move(key), findings_);
        });
      }
    }
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
    } else if (const SweepEntry* other = one_above_or_below(spec->path)) {
      findings_.add(entry.position, std::move(key),
                    fmt::format("not allowed beside {}: a scene has one of "
                                "them",
                                other->key));
    } else {
      section_.entries.push_back(read(*spec, std::move(key)));
    }
  }

  /// The word that a map of keys would replace, or a key of that map.
  [[nodiscard]] const SweepEntry* one_above_or_below(std::string_view path) {
    const auto above = [](std::string_view map, std::string_view key) {
      return key.starts_with(fmt::format("{}.", map));
    };
    const auto found =
        std::ranges::find_if(section_.entries, [&](const SweepEntry& entry) {
          return above(entry.spec->path, path) || above(path, entry.spec->path);
        });
    return found == section_.entries.end() ? nullptr : &*found;
  }

  void read_other(const KeySpec& spec, const Entry& entry) {
    const auto read = read_item(spec, entry.value, entry.position,
                                fmt::format("sweep.{}", spec.path),
                                expected(spec), findings_);
    if (entry.value.find("ranges") != nullptr) {
      const Json found = read.value_or(Json::object());
      read_ranges(*entry.value.find("ranges"),
                  found.value("seed", std::uint64_t{1}),
                  found.value("count", std::size_t{1}));
    } else if (read && spec.path == "warm_start") {
      section_.warm_start = *read == "true";
    } else if (read && spec.path == "keep") {
      section_.keeps_tracks = *read == "tracks";
    }
  }

  void read_ranges(const Entry& ranges, std::uint64_t seed, std::size_t count) {
    const YamlValue& map = ranges.value;
    if (map.kind != YamlValue::Kind::Map) return;
    if (map.entries.empty()) {
      findings_.add(
          map.position, kRanges,
          "an empty map was read; expected " + std::string(kExpectedRanges));
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

bool is_key_of_sweep(std::string_view key) {
  return find_swept_key(key) != nullptr || key == "zip" ||
         std::ranges::count(keys_beside_swept(), key, &KeySpec::path) > 0;
}

bool is_key_of_range(std::string_view key) {
  const auto knows = [&](const KeySpec& map) {
    return std::ranges::count(map.value.items, key, &KeySpec::path) > 0;
  };
  return knows(range_of(number_item("", KeyType::Integer), true)) ||
         std::ranges::any_of(keys_beside_swept(), knows);
}

const SweepEntry* SweepSection::find(std::string_view path) const {
  const auto found = std::ranges::find_if(
      entries,
      [&](const SweepEntry& entry) { return entry.spec->path == path; });
  return found == entries.end() ? nullptr : &*found;
}

SweepSection read_sweep_section(const Entry& sweep, Findings& findings) {
  const YamlValue& value = sweep.value;
  const std::string expected = io::expected(*find_key("sweep"));
  if (value.kind != YamlValue::Kind::Map) {
    refuse_kind(value, "sweep", expected, findings);
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
