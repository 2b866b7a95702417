// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The principal branch: the extremal that continues from the cycloid as the
/// offset η_m of the centre of mass grows from zero.

#pragma once

#include <memory>
#include <vector>

#include "brachisto/study/mesh_solve.hpp"

namespace brachisto {

/// One accepted step of a continuation.
struct ContinuationStep {
  double eta_m = 0.0;
  double phi = 0.0;    ///< [rad]
  int iterations = 0;  ///< of all its passes
};

/// Outcome of a continuation.
struct Continuation {
  Status status = Status::InternalError;
  std::string message;  ///< why and at which η_m it stopped
  std::vector<ContinuationStep> steps;
  std::optional<ExtremalCurve> curve;  ///< at the scene's own η_m if solved
  double phi = 0.0;                    ///< [rad]
  double closure_slope = -1.0;
  int iterations = 0;
  int passes = 0;
  std::string log;
};

/// Follows the extremal of `scene` from η_m = 0, where it is the given cycloid,
/// to the scene's η_m on a fixed mesh.
///
/// Every step starts from the last solution, moved on along the secant of the
/// last two. A step is accepted if it is solved with few iterations and its
/// slope angles stay near the prediction; otherwise it is halved. That keeps
/// the path on one branch, or ends it with the η_m that could not be passed.
///
/// \param scene  in natural units
[[nodiscard]] Continuation continue_from_cycloid(const Scene& scene,
                                                 const CycloidArc& arc,
                                                 const Mesh& mesh,
                                                 const MeshOptions& options);

}  // namespace brachisto
