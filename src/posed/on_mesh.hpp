// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The solution of a stated problem on one mesh.

#pragma once

#include <memory>
#include <string>
#include <utility>

#include "brachisto/posed/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// A mesh with its program and what was found on it.
struct OnMesh {
  Mesh mesh;
  Layout layout;
  std::unique_ptr<nlp::Problem> program;
  /// The message says in the problem's words why it is not solved.
  SolverResult result;
  double cost = 0.0;
  /// The bounds' multipliers times what is left to them.
  double gap = 0.0;
  /// What holds as an equation is known, and does to the last digit.
  bool exact = false;

  [[nodiscard]] MeshPath path() const { return {mesh, layout, result.point}; }
  [[nodiscard]] bool solved() const { return result.status == Status::Solved; }
};

/// Solves a problem on one mesh after the other: by Ipopt, then to the last
/// digit by Newton's method if it is known which bounds hold. The problem and
/// the options are kept by reference.
class MeshSolver {
 public:
  MeshSolver(const Posed& problem, const SolveBy& by)
      : problem_(problem), by_(by), said_(problem.statement()) {}

  [[nodiscard]] OnMesh solved_near(const MeshPath& nearby, const Mesh& mesh) {
    return solved_from(&nearby, mesh, by_.most_iterations);
  }
  /// From the guess, by a detour where it is far from a path.
  [[nodiscard]] OnMesh solved_from_guess(const Mesh& mesh);
  /// Solves the program that is given with its mesh and its layout, and fills
  /// in the rest.
  void fill_in(OnMesh& here, const PrimalDual& start, int most_iterations);

  /// The larger of |cost| and ∫ |L| dt; positive.
  [[nodiscard]] double size_of_cost(const OnMesh& here) const;
  /// Of the solver, since they were asked for last.
  [[nodiscard]] int take_iterations() { return std::exchange(iterations_, 0); }

 private:
  [[nodiscard]] OnMesh not_solved(const Mesh& mesh) const {
    return {mesh, problem_.layout(mesh), problem_.on(mesh), {}, 0.0, 0.0,
            false};
  }
  /// \param nearby  a path to start from; the guess without one
  [[nodiscard]] OnMesh solved_from(const MeshPath* nearby, const Mesh& mesh,
                                   int most_iterations);
  [[nodiscard]] std::string why_not(OnMesh& here) const;
  [[nodiscard]] std::string not_evaluable(const OnMesh& here) const;
  [[nodiscard]] std::string missed(OnMesh& here) const;

  const Posed& problem_;
  const SolveBy& by_;
  const Statement& said_;
  int iterations_ = 0;
};

}  // namespace brachisto::ocp
