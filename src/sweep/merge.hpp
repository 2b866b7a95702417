// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Parts of a sweep, made on several machines, into one.

#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "sweep/job.hpp"
#include "sweep/store.hpp"

namespace brachisto::sweep {

/// What merge() found.
struct MergeReport {
  std::size_t added = 0;
  std::vector<std::size_t> overlaps;   ///< scenes in several parts, alike
  std::vector<std::size_t> conflicts;  ///< scenes with different results; the
                                       ///< one that came first is kept
  std::vector<std::size_t> gaps;       ///< scenes without a result
  bool damaged = false;  ///< and some of the gaps may come from damage
};

/// Opens parts of the sweep that `target` describes, each once.
/// \throws StoreError  if one is of another sweep or program
[[nodiscard]] std::vector<Store> open_parts(
    const std::vector<std::filesystem::path>& parts, const StoreInfo& target);

/// Adds the results of `parts` to `target`, which then counts as merged. Doing
/// it again adds nothing. Results are alike if they differ in times at most;
/// those that are damaged count as not there, and others take their place.
[[nodiscard]] MergeReport merge(std::vector<Store>& parts, Store& target,
                                const Job& job);

}  // namespace brachisto::sweep
