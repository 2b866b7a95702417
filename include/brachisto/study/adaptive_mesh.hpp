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
};

/// A solution on a mesh and what is known of its error.
struct MeshAnswer {
  RollingTime problem;  ///< with the end point of the solution
  MeshSolution solution;
  std::optional<double> estimated_error;  ///< relative, of T
  std::optional<ExtremalCurve> finer;     ///< the same with degree p + 1
  double finer_phi = 0.0;

  [[nodiscard]] ExtremalCurve curve() const {
    return ExtremalCurve(problem, solution.point);
  }
};

/// Solves `scene` on `mesh`, starting from `curve`, and estimates the error.
///
/// The estimate is 2 |T_{p+1} − T_p| + Σ_e |U ∫_e 𝓗 dσ|, the sum taken on the
/// solution of degree p + 1 on the same elements, contact closed anew: the
/// first term is the error but for that of the finer solution, which the second
/// one bounds from above, and the factor 2 keeps it honest where the two
/// degrees err to the same side. What an open contact and rounding add comes
/// on top.
[[nodiscard]] MeshAnswer answer_on_mesh(const Scene& scene, const Mesh& mesh,
                                        const ExtremalCurve& curve, double phi,
                                        const MeshOptions& options);

/// Degree to start with for a wanted relative error.
[[nodiscard]] int starting_degree(double tolerance);

/// The next mesh to try after `answer` missed `tolerance`: the next degree on
/// the same elements where that will do, otherwise elements of the same degree
/// that share the error evenly.
[[nodiscard]] Mesh next_mesh(const MeshAnswer& answer, double tolerance,
                             bool degree_is_fixed);

}  // namespace brachisto
