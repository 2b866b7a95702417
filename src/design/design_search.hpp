// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The search of a design: from one body to the quickest ones near it.

#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/design.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto {

/// What one search came to.
struct DesignSearch {
  /// The last one is the answer: feasible, if that is required and could be
  /// had. Empty: none was found, and the message says why.
  std::vector<DesignMinimum> minima;
  std::optional<Solution> answer;  ///< of the last minimum, if it was solved
  std::vector<DesignPath> paths;
  std::vector<std::string> lost;  ///< ways that led nowhere, why
  std::string message;            ///< of the last such way
  bool stopped = false;           ///< the limit of time ended it on its way
  /// Of a search that was stopped: the quickest body that it has passed, not
  /// solved anew, hence not verified.
  std::optional<DesignMinimum> reached;
  int number = 1;  ///< of the search, from 1 on
  int starts = 0;  ///< bodies that it began at
  int solves = 0;
  double cpu_seconds = 0.0;
};

/// Searches from one of the starts of a plan: the first is the body of the
/// scene, the others are random and depend on the seed and their number alone.
/// If feasibility is required it is asked for where the quickest body lacks it:
/// most do not, and margins cost up to eight solves a gradient. For the same
/// reason the margin of the branch is asked for where a way over its edge led
/// nowhere. A way that is lost for good is begun again at another body, which
/// the seed and the number determine too.
///
/// \param options  of the solves; the limit of time is that of the search
/// \param start    its number, from 1 on
/// \throws Stopped  if the interrupt tells so
[[nodiscard]] DesignSearch search_design(const Scene& scene,
                                         const SolveOptions& options,
                                         const DesignPlan& plan, int start,
                                         const std::atomic<int>* interrupt);

/// Whether only the edge of its branch keeps a body from being quicker: from
/// there on its track is no minimum between its ends.
[[nodiscard]] bool at_edge_of_branch(const DesignMinimum& minimum);

}  // namespace brachisto
