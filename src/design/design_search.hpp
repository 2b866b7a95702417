// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The search of a design: from one body to the quickest ones near it, and what
/// many such searches came to.

#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/design_answer.hpp"
#include "brachisto/study/design_plan.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto {

/// What one search came to.
struct DesignSearch {
  /// The last one is the answer: feasible, if that is required and could be
  /// had. Empty: none was found, and the message says why.
  std::vector<DesignMinimum> minima;
  std::optional<Solution> answer;  ///< of the last minimum, if it was solved
  std::vector<DesignStep> path;
  std::string message;
  int solves = 0;
  double cpu_seconds = 0.0;
};

/// Searches from one of the starts of a plan: the first is the body of the
/// scene, the others are random and depend on the seed and their number alone.
/// If feasibility is required it is asked for where the quickest body lacks it:
/// most do not, and margins cost up to eight solves a gradient.
///
/// \param start  its number, from 1 on
/// \throws Stopped  if the interrupt tells so
[[nodiscard]] DesignSearch search_design(const Scene& scene,
                                         const SolveOptions& options,
                                         const DesignPlan& plan, int start,
                                         const std::atomic<int>* interrupt);

/// The different minima of several searches, quickest first, and the best one.
[[nodiscard]] DesignAnswer gather_designs(const DesignPlan& plan,
                                          std::vector<DesignSearch> searches);

}  // namespace brachisto
