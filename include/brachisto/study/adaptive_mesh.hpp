// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Meshes that are refined until the error is as small as wanted.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/study/mesh_solve.hpp"

namespace brachisto {

/// One mesh that was solved on.
struct MeshRecord {
  int degree = 0;
  int elements = 0;
  /// Relative, of T; nothing if the check could not be done.
  std::optional<double> estimated_error;
  int passes = 0;            ///< solves between fixed end points
  int first_iterations = 0;  ///< of Ipopt, in the first pass
  int iterations = 0;        ///< of Ipopt, in all passes
  int newton_steps = 0;      ///< of polishing and of the check
  /// Of Ipopt, if it ran: Chain or Mumps.
  std::optional<LinearSolver> linear_solver;
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

/// Solves `scene` on `mesh`, starting from `curve`, and estimates the error.
///
/// Let ΔT and Δφ be the changes of T and φ when the scene is solved on the same
/// elements with degree p + 1. The estimate is
///
///     max(2 |ΔT|, |T_φ Δφ| + |ΔT − T_φ Δφ|) + Σ_e |U ∫_e 𝓗 dσ|,
///
/// T_φ = r √A / w being dT/dφ, and the sum taken on the finer solution: ΔT is
/// the error but for that of the finer solution, which the sum bounds from
/// above. The factor 2 keeps it honest where the two degrees err to the same
/// side, the split where the errors of the end point and between fixed ends
/// cancel by accident. What an open contact and rounding add comes on top.
///
/// If the answer of a coarser mesh is given, it takes the place of degree p +
/// 1, and its own estimate that of the sum: the triangle inequality, for the
/// price of the coarser mesh.
///
/// Where Ipopt leaves the extremal that `curve` shows, because between its ends
/// it is no minimum, Newton's method finds it alone.
[[nodiscard]] MeshAnswer answer_on_mesh(const Scene& scene, const Mesh& mesh,
                                        const ExtremalCurve& curve, double phi,
                                        const MeshOptions& options,
                                        const MeshAnswer* coarser = nullptr);

/// Degree to start with for a wanted relative error.
[[nodiscard]] int starting_degree(double tolerance);

/// The next mesh to try after `answer` missed `tolerance`: the next degree on
/// the same elements where that will do, otherwise elements of the same degree
/// that share the error evenly.
[[nodiscard]] Mesh next_mesh(const MeshAnswer& answer, double tolerance,
                             bool degree_is_fixed);

}  // namespace brachisto
