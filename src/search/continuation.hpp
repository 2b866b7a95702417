// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Extremals that continue others: the principal branch, which begins with the
/// cycloid as the offset η_m of the centre of mass grows from zero, and the
/// extremals of neighbouring scenes.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/status.hpp"
#include "model/cycloid.hpp"
#include "refinement/arcs.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// Outcome of a continuation.
struct Continuation {
  Status status = Status::NotConverged;
  std::string message;  ///< why and at which η_m it stopped
  std::vector<ContinuationStep> steps;
  std::optional<ExtremalCurve> curve;  ///< at the scene's own η_m if solved
  double phi = 0.0;                    ///< [rad]
  int newton_steps = 0;                ///< in all, rejected steps included
  int rejected_steps = 0;
  double reached = 0.0;  ///< share of the way to the scene
};

/// An extremal that was found for a scene not far away.
struct Neighbour {
  Scene scene;
  Mesh mesh;
  PrimalDual point;  ///< of the problem in natural units on that mesh
  double phi = 0.0;  ///< [rad]
  /// Of a path under limits, whose mesh is theirs, and its slopes at the
  /// contacts.
  std::vector<Arc> arcs = {};
  LimitedEnds ends = {};
};

/// Follows the extremal of `scene` from η_m = 0, where it is the given cycloid,
/// to the scene's η_m.
///
/// Every step predicts states, multipliers and φ from the last solutions and
/// corrects them by Newton's method on all of them together. A step is accepted
/// if few iterations suffice, no slope angle ends far from its prediction, and
/// the determinant of the Jacobian keeps its sign, which neighbouring branches
/// have opposite; otherwise it is halved. That keeps the path on one branch, or
/// ends it with the η_m that could not be passed.
///
/// A body that makes a few turns is followed on the given mesh, by polynomials
/// through up to four solutions, of the degree that reaches furthest. One that
/// makes many is followed on meshes of equal turns, of as many elements, by a
/// polynomial through the last five solutions as functions of the rotation;
/// then θ may not end far from its prediction either.
///
/// \param scene  in natural units
[[nodiscard]] Continuation continue_from_cycloid(const Scene& scene,
                                                 const CycloidArc& arc,
                                                 const Mesh& mesh,
                                                 const StopCondition& stop,
                                                 const ProgressHook& = {});

/// True if the extremals of both scenes have the same unknowns, and their
/// worlds are ordinary.
[[nodiscard]] bool comparable(const Scene& a, const Scene& b);

/// True if the neighbour's scene is valid and comparable() and its mesh, point
/// and φ are finite numbers of the right count.
[[nodiscard]] bool can_continue(const Neighbour& neighbour, const Scene& scene);

/// Follows the extremal of a neighbour on its own mesh along the straight line
/// between the two scenes, with the same care; usually in one step.
///
/// \param scene          in natural units
/// \param neighbour      that can_continue() to it
/// \param smallest_step  as a share of the way; where the cycloid is another
///                       start, it is the shorter way beyond a few steps
[[nodiscard]] Continuation continue_from_neighbour(const Scene& scene,
                                                   const Neighbour& neighbour,
                                                   const StopCondition& stop,
                                                   double smallest_step = 1.0 /
                                                                          8.0);

}  // namespace brachisto
