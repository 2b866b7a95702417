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
  int judged_by = 0;  ///< elements of a coarser mesh; 0: by degree p + 1
};

/// On so many elements as are asked for, or one on each arc: if they are many,
/// judged by as few as are accurate, otherwise by degree p + 1.
[[nodiscard]] std::optional<LimitedAnswer> on_fixed_mesh(
    const FittedPath& path, int p, const Discretisation& wanted,
    ArcSearch& search, PassProtocol& protocol);

/// Arcs get more elements until degree p + 1 on the same ones, by which the
/// error is estimated, changes T by no more than is wanted, and limits are kept
/// between the points.
///
/// \param path  of degree p
/// \return the most accurate one that was found; if there is none the protocol
///         tells why
[[nodiscard]] std::optional<LimitedAnswer> refine_arcs(
    std::optional<FittedPath> path, int p, const Discretisation& wanted,
    ArcSearch& search, PassProtocol& protocol);

}  // namespace brachisto
