// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What many searches of a design came to: the best body, with its track.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "brachisto/study/design.hpp"
#include "brachisto/study/solve.hpp"
#include "design/design_search.hpp"
#include "math/wall_clock.hpp"

namespace brachisto {

/// The different minima of several searches, quickest first, and the best one.
[[nodiscard]] DesignAnswer gather_designs(const DesignPlan& plan,
                                          std::vector<DesignSearch> searches);

/// Of the limit of time searches leave a tenth for the track of the best body.
inline constexpr double kShareOfSearches = 0.9;

/// The bodies that searches had reached when the limit of time ended them,
/// quickest first.
[[nodiscard]] std::vector<DesignMinimum> reached_by(
    const std::vector<DesignSearch>& all);

/// The track of the best body, or in its place of the quickest one that a
/// search had reached in the time that there was, which then is the best. If
/// none is feasible it is that of the quickest there is; if there is none at
/// all the status says so.
/// \param interrupt  nonzero: stop; may be null
/// \param answer     [in, out] what the searches came to
[[nodiscard]] Solution solve_best(const Scene& scene,
                                  const SolveOptions& options,
                                  const std::vector<DesignMinimum>& reached,
                                  const std::atomic<int>* interrupt,
                                  WallClock::time_point end,
                                  DesignAnswer& answer);

/// What a design came to, and the track of its body.
struct Designed {
  Solution solution;
  DesignAnswer answer;
};

/// All searches of a plan in this process, one after the other: the numbers are
/// those of searches in processes of their own. Status::Interrupted if the
/// interrupt stopped it.
/// \param interrupt  nonzero: stop; may be null
/// \pre the plan leaves something free
[[nodiscard]] Designed find_design(const Scene& scene,
                                   const SolveOptions& options,
                                   const DesignPlan& plan,
                                   const std::atomic<int>* interrupt);

/// Why a design that ran out of its limit of time has less than was asked for.
[[nodiscard]] std::string cut_short(const SolveOptions& options,
                                    const DesignAnswer& answer, int starts);

}  // namespace brachisto
