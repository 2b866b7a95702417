// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sequences of arc_length meshes.

#pragma once

#include <optional>

#include "brachisto/study/refinement.hpp"
#include "brachisto/trajectory/arc_length_motion.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

/// A solution on a mesh of straight pieces and what is known of its error.
struct ArcLengthAnswer {
  ArcLength problem;  ///< with the end point of the solution, moved to it
  MeshSolution solution;
  double transit_time = 0.0;              ///< T_h, in units of the scene
  std::optional<double> estimated_error;  ///< relative, of T
  int coarser_pieces = 0;                 ///< of the mesh it was estimated by
};

/// Outcome of refine_arc_length().
struct ArcLengthRefinement : RefinementProtocol {
  std::optional<ArcLengthAnswer> answer;  ///< nothing if the last mesh failed
};

/// Solves on the mesh that `wanted` fixes, or on one that follows from its
/// tolerance. The first mesh, of some dozen pieces per turn, starts from
/// `curve`; each further one has up to four times as many and starts from the
/// one before, multipliers included.
///
/// The error of N pieces is estimated from those of M < N. With ΔT and Δφ the
/// changes from M to N, it is
///
///     (|T_φ Δφ| + |ΔT − T_φ Δφ|) / ((N/M)^1.58 − 1),
///
/// Richardson's estimate, its parts from the end point and between fixed ends
/// kept from cancelling, for an order lower than 2, as terms of higher order
/// can make it seem: of halved pieces half as much again as for order 2. It is
/// not less than the estimate of the mesh before over (N/M)². An open contact
/// and rounding add to it.
///
/// \param scene  in natural units
/// \param curve  an extremal of the scene on a coarse mesh, with the end angle
///               φ
[[nodiscard]] ArcLengthRefinement refine_arc_length(
    const Scene& scene, const Discretisation& wanted,
    const ExtremalCurve& curve, double phi, MeshOptions options);

/// certify(), and the check "agreement" as in certify_answer().
[[nodiscard]] Certificate certify_answer(ArcLengthAnswer& answer,
                                         const ArcLengthMotion& motion,
                                         const Discretisation& wanted);

}  // namespace brachisto
