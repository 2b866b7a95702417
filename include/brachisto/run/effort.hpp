// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a solution was sought: the work, and what was met on the way.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/solvers/linear_solver.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// One accepted step of a continuation.
struct ContinuationStep {
  double eta_m = 0.0;
  double phi = 0.0;      ///< [rad]
  int newton_steps = 0;  ///< to get there from the prediction
};

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

/// Work that a stage of a solve took.
struct Work {
  int iterations = 0;    ///< of Ipopt, in all passes on all meshes
  int passes = 0;        ///< solves between fixed end points
  int newton_steps = 0;  ///< of continuation, polishing and checks
  std::string log;       ///< of Ipopt, if asked for

  Work& operator+=(const Work& other);
};

/// What was done to find a solution.
struct Effort : Work {
  double seconds = 0.0;              ///< wall clock, all of solve()
  double certificate_seconds = 0.0;  ///< of these for the certificate
  /// Processor time of solve() without the certificate and cross-checks.
  double cpu_seconds = 0.0;
  double certificate_cpu_seconds = 0.0;  ///< processor time of these two
  PhaseSeconds phases;                   ///< processor time of solve()
  std::vector<ContinuationStep> continuation;
  /// On the way to the answer, in the order in which they were tried.
  std::vector<MeshRecord> meshes;

  /// The mesh that was tried last; all zero if there was none.
  [[nodiscard]] MeshRecord final_mesh() const {
    return meshes.empty() ? MeshRecord{} : meshes.back();
  }
};

/// A start other than the cycloid, and where it led on a coarse mesh.
struct ColdStart {
  Status status = Status::NotConverged;
  std::optional<double> tau;  ///< on the coarse mesh, if it converged
  bool principal = false;     ///< it led to the principal branch
};

/// One smooth contact that Search::Global found.
struct Branch {
  double tau = 0.0;
  double estimated_error = 0.0;     ///< relative
  double end_angle = 0.0;           ///< [rad]
  double centre_path_length = 0.0;  ///< [m]
  bool principal = false;
  bool verified = false;
  bool minimum = false;  ///< second-order sufficiency at fixed φ
  bool feasible = false;
  std::vector<std::string> remarks;  ///< failed checks, why infeasible
};

}  // namespace brachisto
