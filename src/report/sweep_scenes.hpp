// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which scenes of a sweep go together, and what came out for them.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/sweep_table.hpp"

namespace brachisto::report {

/// Numbers of scenes.
using Scenes = std::vector<std::size_t>;

/// \throws std::invalid_argument if columns or axes do not fit the outcomes, or
///                               a verified scene has no τ
void check(const SweepTable& table);

/// All scenes in their order.
[[nodiscard]] Scenes all_scenes(const SweepTable& table);

/// Place of a scene along an axis.
[[nodiscard]] std::size_t index_along(const SweepTable& table, std::size_t axis,
                                      std::size_t scene);

/// The scenes apart by their place along all axes but `inner`: each group has
/// one scene per combination of inner values, in the order of the sweep.
[[nodiscard]] std::vector<Scenes> scenes_along(
    const SweepTable& table, const std::vector<std::size_t>& inner);

/// How many scenes came out how, and which stand out.
struct SweepDigest {
  std::size_t verified = 0, failed = 0, missing = 0, infeasible = 0;
  // Scenes; of equals the first:
  std::optional<std::size_t> fastest, fastest_feasible, slowest, least_accurate;
  std::optional<std::size_t> faster_infeasible;  ///< than all feasible ones
};
[[nodiscard]] SweepDigest digest(const SweepTable& table, const Scenes& scenes);

/// The columns whose value is the same in all these scenes, or is not.
[[nodiscard]] std::vector<std::size_t> columns_that_vary(
    const SweepTable& table, const Scenes& scenes, bool vary = true);

/// The words of a column in these scenes, each once, as they come.
[[nodiscard]] std::vector<std::string> distinct_words(const SweepColumn& column,
                                                      const Scenes& scenes);

/// The state of a scene in a word.
[[nodiscard]] const char* name(SweepOutcome::State state);

}  // namespace brachisto::report
