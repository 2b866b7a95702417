// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The loop of all refinements: from mesh to mesh.

#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "refinement/refinement.hpp"

namespace brachisto {

/// Whether a mesh on which there is no solution may only be too coarse.
[[nodiscard]] inline bool too_coarse(const MeshSolution& solution) {
  return solution.status == Status::NotConverged ||
         solution.status == Status::NotEvaluable;
}

/// What the end of a path means for the error of T, in natural units.
struct EndErrors {
  double per_radian;  ///< dT/dφ: the end point moves along the path
  double open;        ///< of a contact that is not quite closed
  /// The ends are sums of lengths; a dozen roundings of the largest of them go
  /// into the path and its end slope, and with Contact::Smooth that slope moves
  /// the end by r for each radian. T changes by |p| for each length.
  double rounding;
};
/// \param p  at the end
[[nodiscard]] EndErrors errors_of_end(const Scene& scene,
                                      const Tangency& tangency,
                                      const Costates& p);

/// What is known of a mesh that was solved on.
[[nodiscard]] MeshRecord record_of(const Transcription& problem,
                                   const MeshSolution& solution,
                                   const std::optional<double>& error);
[[nodiscard]] std::string text_of(const MeshRecord& mesh);

/// Solves on one mesh after the other, and keeps to the budget of iterations.
///
/// \param sequence  knows the meshes: `name()` of the next one; `solve(options,
///                  out)` on it, with an estimate of the error;
///                  `goes_on(answer, stop, out)` puts a good answer into `out`,
///                  and chooses the mesh after it or ends the sequence
template <class Sequence, class Refinement>
Refinement run(Sequence sequence, MeshOptions options) {
  Refinement out;
  for (bool on = true; on;) {
    const std::string name = sequence.name();
    if (options.progress) options.progress(name, "solving");
    auto answer = sequence.solve(options, out);
    const MeshSolution& solution = answer.solution;
    out.meshes.push_back(
        record_of(answer.problem, solution, answer.estimated_error));
    out.log += solution.log;
    out.status = solution.status;
    out.message = solution.message;
    options.ipopt.max_iterations =
        std::max(0, options.ipopt.max_iterations - solution.iterations);
    if (options.progress) {
      options.progress(name, solution.solved() ? text_of(out.meshes.back())
                                               : solution.message);
    }
    on = sequence.goes_on(std::move(answer), options.ipopt.stop, out);
  }
  return out;
}

}  // namespace brachisto
