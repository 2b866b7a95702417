// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/damage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

namespace brachisto::sweep {

Damage::operator bool() const {
  return !scenes.empty() || strays > 0 || states > 0 || !info.empty() ||
         !structure.empty() || journal_lost;
}

std::string describe(const Damage& damage, const std::filesystem::path& store) {
  std::string text;
  const auto add = [&](const std::string& what) {
    if (!text.empty()) text += '\n';
    text += fmt::format("{}: {}", store.string(), what);
  };
  if (damage.journal_lost) {
    add("its journal (the file of that name with -wal) is gone; results that "
        "were only there are lost");
  }
  if (!damage.structure.empty()) {
    add(
        fmt::format("damaged: {}; `brachisto merge {} --out NEW` saves the "
                    "results that can be read",
                    damage.structure, store.parent_path().string()));
  }
  if (!damage.info.empty()) {
    add(fmt::format("damaged: what it has as {} does not match its checksum",
                    fmt::join(damage.info, " and as ")));
  }
  if (!damage.scenes.empty()) {
    add(fmt::format(
        "damaged: the results of {} do not match their checksums",
        scene_ranges({damage.scenes.begin(), damage.scenes.end()})));
  }
  if (damage.strays > 0) {
    add(fmt::format("damaged: {} results belong to no scene", damage.strays));
  }
  if (damage.states > 0) {
    add(fmt::format("damaged: what {} chains go on from", damage.states));
  }
  return text;
}

std::string scene_ranges(const std::vector<std::size_t>& scenes) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < scenes.size();) {
    std::size_t j = i;
    while (j + 1 < scenes.size() && scenes[j + 1] <= scenes[j] + 1) ++j;
    parts.push_back(scenes[i] == scenes[j]
                        ? fmt::format("{}", scenes[i])
                        : fmt::format("{}–{}", scenes[i], scenes[j]));
    i = j + 1;
  }
  return fmt::format("scene{} {}", scenes.size() == 1 ? "" : "s",
                     fmt::join(parts, ", "));
}

std::int64_t row_checksum(std::string_view key, std::string_view content) {
  std::string row(key);
  row += '\n';
  row += content;
  return static_cast<std::int64_t>(XXH3_64bits(row.data(), row.size()));
}

}  // namespace brachisto::sweep
