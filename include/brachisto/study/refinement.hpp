// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a coarse extremal to a solution as accurate as wanted.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/adaptive_mesh.hpp"
#include "brachisto/transcription/discretisation.hpp"

namespace brachisto {

/// What was done on the way from a coarse extremal to a solution.
struct RefinementProtocol {
  Status status = Status::NotConverged;  ///< of the last mesh
  std::string message;                   ///< of the last mesh
  std::vector<MeshRecord> meshes;  ///< in the order in which they were tried
  std::string log;                 ///< of Ipopt
};

/// Enters a mesh that was solved on, and takes its iterations off the budget.
/// \param error  relative, of T
void book(const Transcription& problem, const MeshSolution& solution,
          const std::optional<double>& error, MeshOptions& options,
          RefinementProtocol& out);

/// Whether a mesh on which there is no solution may only be too coarse.
[[nodiscard]] bool too_coarse(const MeshSolution& solution);

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

}  // namespace brachisto
