// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A scene in, its smooth-contact extremal out.

#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/branches.hpp"
#include "brachisto/study/certification.hpp"
#include "brachisto/study/cold_start.hpp"
#include "brachisto/study/continuation.hpp"
#include "brachisto/study/fsolve_answer.hpp"
#include "brachisto/study/progress.hpp"
#include "brachisto/study/solve_options.hpp"
#include "brachisto/trajectory/arc_length_motion.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/prescribed_motion.hpp"
#include "brachisto/trajectory/trajectory.hpp"

namespace brachisto {

/// What was done to find a solution.
struct Effort {
  int iterations = 0;        ///< of Ipopt, in all passes on all meshes
  int first_iterations = 0;  ///< of the first pass on the final mesh
  int passes = 0;            ///< solves between fixed end points, in all
  int closure_passes = 0;    ///< of these on the final mesh
  int newton_steps = 0;      ///< of continuation, polishing and checks
  /// Of Ipopt on the final mesh: Chain or Mumps; nothing where Ipopt did not
  /// run there.
  std::optional<LinearSolver> linear_solver;
  double seconds = 0.0;              ///< wall clock, all of solve()
  double certificate_seconds = 0.0;  ///< of these for the certificate
  /// Processor time of solve() without the certificate and second opinions.
  double cpu_seconds = 0.0;
  double certificate_cpu_seconds = 0.0;  ///< processor time of these two
  PhaseSeconds phases;                   ///< processor time of solve()
  std::vector<ContinuationStep> continuation;
  std::vector<MeshRecord> meshes;  ///< in the order in which they were tried
};

/// Outcome of solve(). Numbers of the path live in `trajectory`; they are worth
/// something only if verified() is true.
struct Solution {
  Scene scene;
  SolveOptions options;
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
  /// What the scene says but hardly means, such as θ_m of many turns.
  std::vector<std::string> warnings;
  std::optional<Trajectory> trajectory;
  /// In place of a trajectory, if the formulation is arc_length.
  std::shared_ptr<const ArcLengthMotion> through_nodes;
  /// In place of a trajectory, if the scene states its path.
  std::shared_ptr<const PrescribedMotion> on_given_path;
  /// In place of a trajectory, with Method::Fsolve. Not what is asked for.
  std::optional<FsolveAnswer> discrete;
  std::optional<PathDiagnostics> diagnostics;
  Certificate certificate;
  std::optional<double> estimated_error;  ///< relative, of T
  int nodes = 0, variables = 0, constraints = 0;
  Effort effort;
  /// η_m at which the branch from the cycloid turned on its way to the scene's
  /// η_m. Usually empty. Otherwise the solution lies beyond a fold: connected
  /// with the cycloid, but not what it turns into as η_m grows.
  std::vector<double> folds;
  std::optional<ColdStart> cold_start;
  std::vector<Branch> branches;  ///< of Search::Global, fastest first
  /// What Search::Global left undone, its work being bounded; empty if nothing.
  std::string search_remark;
  std::optional<ExtremalOpinion> extremal;
  std::optional<Neighbour> as_neighbour;  ///< for scenes not far from this one
  std::string log;                        ///< of Ipopt, if asked for

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
  /// The motion, found or given; null if there is none.
  [[nodiscard]] const Motion* motion() const {
    if (trajectory) return &*trajectory;
    if (through_nodes) return through_nodes.get();
    return on_given_path.get();
  }
  [[nodiscard]] bool feasible() const { return infeasible_because().empty(); }
  /// Forgets the answer with all that is known of it, not how it was sought.
  void discard_answer();
};

/// What a caller may hook into.
struct SolveHooks {
  const std::atomic<int>* interrupt = nullptr;  ///< nonzero: stop
  bool verbose = false;                         ///< keep the solver's log
  ProgressHook progress = {};                   ///< may be empty
  /// A solved scene not far away. If its extremal can be followed to this scene
  /// the continuation from the cycloid is spared; if not, or if it makes no
  /// sense, or if the result is not verified, it is not used.
  const Neighbour* neighbour = nullptr;
};

/// Finds the smooth-contact extremal of a scene (docs/theory.md, section 3),
/// or evaluates the path that it states.
/// Method::Fsolve solves the paper's discrete system instead, compares its time
/// with that of the extremal method, and is never verified.
///
/// May be called in several threads at once. What they do with Ipopt, which is
/// not safe in threads with MUMPS, they do one after the other; with
/// Method::NewtonKkt and a chain, and with Method::Extremal, they do not wait.
/// The limit of time counts the waiting too.
///
/// \throws std::invalid_argument  with all that is wrong, if the scene is not
///         valid, an option is out of its bounds, or the formulation arc_length
///         is combined with what it does not have: a degree, another method or
///         search, a tolerance below kSmallestArcLengthTolerance
[[nodiscard]] Solution solve(const Scene& scene,
                             const SolveOptions& options = {},
                             const SolveHooks& hooks = {});

}  // namespace brachisto
