// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The outcome of a solve: one answer, what is known of it, and how it was
/// sought.

#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/branches.hpp"
#include "brachisto/study/certification.hpp"
#include "brachisto/study/continuation.hpp"
#include "brachisto/study/discrete_answer.hpp"
#include "brachisto/study/refinement.hpp"
#include "brachisto/study/solve_options.hpp"
#include "brachisto/trajectory/arc_length_motion.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/prescribed_motion.hpp"
#include "brachisto/trajectory/trajectory.hpp"

namespace brachisto {

/// How a solve or a stage of it ended.
struct Outcome {
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
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

/// The finite problem that an answer solves.
struct ProgramSize {
  int nodes = 0, variables = 0, constraints = 0;
};

/// Of the formulation rolling_time; of Shooting the extremal sampled on
/// a mesh, with its own T.
struct CollocationAnswer {
  Trajectory trajectory;
  ProgramSize program;
  PrimalDual point;  ///< of the problem in natural units on the mesh
  double phi = 0.0;  ///< [rad]
};

/// Of the formulation arc_length.
struct PiecewiseAnswer {
  ArcLengthMotion motion;
  ProgramSize program;
};

/// The answers there are: none, found by collocation, found on straight pieces,
/// the motion on the path that a scene states, and a solution of the paper's
/// discrete system, which is not what is asked for.
using Answer = std::variant<std::monostate, CollocationAnswer, PiecewiseAnswer,
                            PrescribedMotion, DiscreteAnswer>;

/// A start other than the cycloid, and where it led on a coarse mesh.
struct ColdStart {
  Status status = Status::NotConverged;
  std::optional<double> tau;  ///< on the coarse mesh, if it converged
  bool principal = false;     ///< it led to the principal branch
};

/// Outcome of solve(). The numbers of motion() are worth something only if
/// verified() is true.
struct Solution {
  Scene scene;
  SolveOptions options;
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
  /// What the scene says but hardly means, such as θ_m of many turns.
  std::vector<std::string> warnings;

  Answer answer;
  std::optional<PathDiagnostics> diagnostics;  ///< of motion()
  std::optional<double> estimated_error;       ///< relative, of T
  Certificate certificate;
  std::optional<CrossCheck> extremal;

  Effort effort;
  /// η_m at which the branch from the cycloid turned on its way to the scene's
  /// η_m. Usually empty. Otherwise the solution lies beyond a fold: connected
  /// with the cycloid, but not what it turns into as η_m grows.
  std::vector<double> folds;
  std::optional<ColdStart> cold_start;
  std::vector<Branch> branches;  ///< of Search::Global, fastest first
  /// What Search::Global left undone, its work being bounded; empty if nothing.
  std::string search_remark;

  /// The motion, found or given; null if there is none.
  [[nodiscard]] const Motion* motion() const;
  /// The motion of a CollocationAnswer; null if the answer is another.
  [[nodiscard]] const Trajectory* trajectory() const;
  /// The finite problem solved; null if there is none.
  [[nodiscard]] const ProgramSize* program() const;
  /// Of a DiscreteSystem; null otherwise.
  [[nodiscard]] const DiscreteAnswer* discrete() const {
    return std::get_if<DiscreteAnswer>(&answer);
  }
  /// For scenes not far from this one. Nothing if the answer is not the end of
  /// the branch from the cycloid: what lies beyond a fold is not what
  /// neighbours continue.
  [[nodiscard]] std::optional<Neighbour> as_neighbour() const;

  /// Solved, and every check of the certificate passed. Never for a solution
  /// of the paper's discrete system.
  [[nodiscard]] bool verified() const;
  /// See brachisto::not_verified_because(); empty if nothing is solved.
  [[nodiscard]] std::vector<std::string> not_verified_because() const;
  /// What to try where the extremal that was found is no minimum between its
  /// fixed ends; empty otherwise, and where there is nothing to try.
  [[nodiscard]] std::string advice() const;
  /// See brachisto::infeasible_because(); empty as long as nothing is solved.
  [[nodiscard]] std::vector<std::string> infeasible_because() const;
  [[nodiscard]] bool feasible() const { return infeasible_because().empty(); }
  /// Forgets the answer with all that is known of it, not how it was sought.
  void discard_answer();
};

}  // namespace brachisto
