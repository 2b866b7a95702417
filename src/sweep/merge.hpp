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
  std::vector<std::size_t> overlaps;   ///< scenes in several parts, all alike
  std::vector<std::size_t> conflicts;  ///< scenes with different results; the
                                       ///< one that came first is kept
  std::vector<std::size_t> gaps;       ///< scenes without a result
};

/// Adds the results of `parts` to `target`. Doing it again adds nothing.
/// Results are alike if they differ in times at most.
///
/// \throws StoreError  if a part is of another sweep or program; nothing of
///                     any part is added then
[[nodiscard]] MergeReport merge(const std::vector<std::filesystem::path>& parts,
                                Store& target, const Job& job);

}  // namespace brachisto::sweep
