// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a coarse extremal to a solution as accurate as wanted.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/run/solve_options.hpp"
#include "refinement/mesh_solve.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto {

/// What was done on the way from a coarse extremal to a solution.
struct RefinementProtocol {
  Status status = Status::NotConverged;  ///< of the last mesh
  std::string message;                   ///< of the last mesh
  std::vector<MeshRecord> meshes;  ///< in the order in which they were tried
  std::string log;                 ///< of Ipopt
};

/// A solution on a mesh and what is known of its error.
struct MeshAnswer {
  RollingTime problem;  ///< with the end point of the solution
  MeshSolution solution;
  std::optional<double> estimated_error;  ///< relative, of T
  std::optional<ExtremalCurve> finer;     ///< the same with degree p + 1
  double finer_phi = 0.0;
  /// Of the mesh that the error was estimated by; 0 if that was degree p + 1.
  int coarser_elements = 0;

  [[nodiscard]] ExtremalCurve curve() const {
    return ExtremalCurve(problem, solution.point);
  }
};

/// Outcome of refine().
struct Refinement : RefinementProtocol {
  std::optional<MeshAnswer> answer;  ///< the best one; nothing if none solved
};

/// Solves on the mesh that `wanted` fixes, or on meshes that follow its
/// tolerance, each from the solution of the one before, until the estimated
/// error is small enough or rounding keeps it from falling. A mesh that cannot
/// be solved on is doubled. A large mesh that is fixed starts from the solution
/// on a coarser one, which also tells its error if it is exact enough.
///
/// \param scene  in natural units
/// \param curve  an extremal of the scene on a coarse mesh, with the end angle
/// φ
[[nodiscard]] Refinement refine(const Scene& scene,
                                const Discretisation& wanted,
                                const ExtremalCurve& curve, double phi,
                                MeshOptions options);

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
/// `curve`; each further one has up to four times as many, of a mesh that is
/// fixed up to sixteen times, if that leaves the one before fine enough, and
/// starts from the one before, multipliers included.
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

}  // namespace brachisto
