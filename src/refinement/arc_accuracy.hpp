// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A path on known arcs, as accurately as is wanted.

#pragma once

#include <optional>
#include <vector>

#include "refinement/arc_search.hpp"

namespace brachisto {

/// A path under limits and what is known of its error.
struct LimitedAnswer {
  FittedPath path;
  std::optional<double> estimated_error;  ///< relative, of T
  /// Found by the indirect method; on the mesh nothing was solved.
  bool sampled = false;
};

/// On so many elements as are asked for, or one on each arc.
[[nodiscard]] std::optional<FittedPath> on_fixed_mesh(
    const FittedPath& path, int p, const std::vector<PathInequality>& limits,
    const Discretisation& wanted, ArcSearch& search);

/// Arcs get more elements until degree p + 1 on the same ones, by which the
/// error is estimated, changes T by no more than is wanted, and limits are kept
/// between the points.
///
/// \param path  of degree p
/// \return the most accurate one that was found; if there is none the protocol
///         tells why
[[nodiscard]] std::optional<LimitedAnswer> refine_arcs(
    std::optional<FittedPath> path, int p,
    const std::vector<PathInequality>& limits, const Discretisation& wanted,
    ArcSearch& search, PassProtocol& protocol);

}  // namespace brachisto
