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
#include "refinement/path_system.hpp"

namespace brachisto {

/// A path whose arcs are known.
struct FittedPath {
  std::vector<Arc> arcs;
  LimitedEnds ends;
  LimitedCurve curve;  ///< of a problem whose limits are equations or absent
  ContactMismatch mismatch;
  /// What rounding leaves of the equations, where more than elsewhere.
  double missed = 0.0;
  /// Both are relative to T. What the mesh errs by comes on top.
  [[nodiscard]] double error_of_conditions() const {
    return mismatch.largest() + missed;
  }
};

/// Outcome of fit_arcs().
struct ArcFit {
  std::optional<FittedPath> path;
  std::string message;  ///< why there is none
  int passes = 0, newton_steps = 0;
  double work = 0.0;  ///< see PassProtocol
};

/// Finds variables, multipliers, the places of the junctions and the slopes
/// that the contacts are built from, all together, by Newton's method; while
/// the border of its matrix foretells what a step gains it is followed by
/// Broyden's formula. An arc that shrinks to nothing is left out. If that leads
/// nowhere, once more with steps that may lead further off the conditions.
///
/// \param nearby   a solution to start from, perhaps under other bounds
/// \param setting  where to begin, of the limits to keep
[[nodiscard]] ArcFit fit_arcs(const LimitedCurve& nearby, PathSetting setting,
                              int degree, const MeshOptions& options);

/// The path on arcs that point and ends are of; nothing if they do not belong
/// together.
/// \param scene  in natural units; its limits are those of the path
[[nodiscard]] std::optional<FittedPath> path_on_arcs(const Scene& scene,
                                                     std::vector<Arc> arcs,
                                                     const LimitedEnds& ends,
                                                     int degree,
                                                     PrimalDual point);

}  // namespace brachisto
