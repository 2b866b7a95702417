// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is wrong with a store.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::sweep {

/// What was found to be damaged or lost. The rest is as it was recorded.
struct Damage {
  std::set<std::size_t> scenes;   ///< whose results are damaged
  std::size_t strays = 0;         ///< results that belong to no scene
  std::size_t states = 0;         ///< chains that cannot be gone on with
  std::vector<std::string> info;  ///< what a StoreInfo lacks
  std::string structure;      ///< what SQLite objects to in the file as such
  bool journal_lost = false;  ///< results may be missing without a trace

  [[nodiscard]] explicit operator bool() const;
};

/// What there is of it, a line for each kind.
/// \param store  file that it was found in
[[nodiscard]] std::string describe(const Damage& damage,
                                   const std::filesystem::path& store);

/// "scenes 0–15, 32, 40".
/// \param scenes  in ascending order, at least one
[[nodiscard]] std::string scene_ranges(const std::vector<std::size_t>& scenes);

/// 64-bit XXH3 of a row.
///
/// \param key  of the row and of its table, "result 17": a row whose key has
///             changed is as wrong as one whose content has
[[nodiscard]] std::int64_t row_checksum(std::string_view key,
                                        std::string_view content);

}  // namespace brachisto::sweep
