// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "io/suggestion.hpp"

namespace brachisto::io {

namespace {

constexpr const char* kZip = "sweep.zip";
constexpr const char* kExpectedZip =
    "expected a list of keys that run together, or a list of such lists";

bool is_random(const SweepEntry& entry) {
  return std::holds_alternative<NumberSample>(entry.rule);
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
    if (zip.kind == YamlValue::Kind::Refused) return;
    const auto is_list = [](const YamlValue& item) {
      return item.kind == YamlValue::Kind::List;
    };
    if (zip.kind != YamlValue::Kind::List) {
      refuse(zip.position,
             fmt::format("{} was read; {}", kind_name(zip.kind), kExpectedZip));
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
    if (item.kind == YamlValue::Kind::Refused) return entries.size();
    const auto found = std::ranges::find_if(entries, [&](const auto& entry) {
      return entry.spec->path == item.text;
    });
    if (item.kind != YamlValue::Kind::Scalar) {
      refuse(item.position, fmt::format("{} was read; {}", kind_name(item.kind),
                                        kExpectedZip));
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

}  // namespace

void build_axes(const Entry& sweep, SweepSection& section, Findings& findings) {
  AxisBuilder builder(section, findings);
  builder.share_random();
  if (const Entry* zip = sweep.value.find("zip")) builder.read_zip(zip->value);
  builder.build();
  check_size(section, sweep.position, findings);
}

}  // namespace brachisto::io
