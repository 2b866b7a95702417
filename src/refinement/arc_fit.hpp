// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path under limits on a mesh whose elements end at its junctions.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "refinement/mesh_solve.hpp"
#include "refinement/open_conditions.hpp"
#include "refinement/path_response.hpp"

namespace brachisto {

/// A path whose arcs are known.
struct FittedPath {
  std::vector<Arc> arcs;
  LimitedEnds ends;
  LimitedCurve curve;  ///< of a problem whose limits are equations or absent
  ContactMismatch mismatch;
  /// Of the Jacobian of its open conditions, roughly; may be empty.
  Eigen::MatrixXd inverse;
};

/// Outcome of fit_arcs().
struct ArcFit {
  std::optional<FittedPath> path;
  std::string message;  ///< why there is none
  int passes = 0, newton_steps = 0;
};

/// Finds the places of the junctions and the slopes that the contacts are built
/// from, all together by Broyden's method around Newton's on the optimality
/// conditions of fixed arcs. An arc that shrinks to nothing is left out.
///
/// \param nearby   a solution to start from, perhaps under other bounds
/// \param setting  where to begin, of the limits to keep
/// \param before   the path fitted before, or null: its inverse serves again if
///                 it had the same arcs
[[nodiscard]] ArcFit fit_arcs(const LimitedCurve& nearby, PathSetting setting,
                              int degree, const MeshOptions& options,
                              const FittedPath* before = nullptr);

}  // namespace brachisto
