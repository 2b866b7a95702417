// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Paths that keep the limits of a scene, from many starts.

#pragma once

#include <string>
#include <vector>

#include "refinement/mesh_solve.hpp"
#include "search/global_search.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// Outcome of find_limited_paths().
struct LimitedSearch {
  std::vector<LimitedCurve> paths;  ///< on coarse meshes, fastest first
  int starts = 0;                   ///< that were tried
  Work work;
  /// What the search left undone because its work is bounded; empty if nothing.
  std::string remark;
};

/// No more extremals without limits are started from.
inline constexpr std::size_t kMostFreeStarts = 8;
/// No more paths are handed on.
inline constexpr std::size_t kMostLimitedPaths = 12;
/// Iterations of Ipopt for one start.
inline constexpr int kIterationsOfAStart = 600;

/// Limits are tightened on a coarse mesh (Tightening) from
///
/// - the extremals without limits, the first of which is the principal one,
/// - the first one bent past the discs that it passes near, once for each way
///   of being over or under them,
/// - each limit alone, the others being what the first one keeps, which is
///   another order than all of them together,
/// - the first one with random waves on it, always the same.
///
/// Where the slope at B is sought, contacts are looked for along it too, from
/// the first path that was found and from the fastest. Of paths
/// that lie next to each other one is handed on.
///
/// \param scene  in natural units, with limits
/// \param free   its extremals without them, not empty
/// \param options  the limit on iterations is for each start, if it is less
///                 than kIterationsOfAStart
[[nodiscard]] LimitedSearch find_limited_paths(
    const Scene& scene, const std::vector<ContactCandidate>& free,
    const MeshOptions& options);

}  // namespace brachisto
