// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The outcome of a solve: one answer, what is known of it, and how it was
/// sought.

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/effort.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/design_answer.hpp"
#include "brachisto/study/discrete_answer.hpp"
#include "brachisto/study/limit_on_path.hpp"
#include "brachisto/study/sensitivities.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// How a solve or a stage of it ended.
struct Outcome {
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
};

/// The finite problem that an answer solves.
struct ProgramSize {
  int nodes = 0, variables = 0, constraints = 0;
  std::optional<int> degree;  ///< p; nothing of straight pieces
  int elements = 0;           ///< N, or pieces
};

/// What a Solution keeps of the problem it solves; the library alone knows it.
struct Answer;

/// An extremal that was found, to start from in a scene not far away.
struct Neighbour;

/// Outcome of solve(). The numbers of motion() are worth something only if
/// verified() is true. A copy shares the answer, which neither can change.
struct Solution {
  Scene scene;
  SolveOptions options;
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
  /// What the scene says but hardly means, such as θ_m of many turns.
  std::vector<std::string> warnings;

  std::shared_ptr<const Answer> answer;        ///< null: there is none
  std::optional<PathDiagnostics> diagnostics;  ///< of motion()
  std::optional<double> estimated_error;       ///< relative, of T
  Certificate certificate;
  std::optional<CrossCheck> extremal;
  std::vector<LimitOnPath> limits;  ///< one for each bound of the scene
  /// Where limits were not reached, verified: the answer under those that ask
  /// for less, tightened as far as a path was found. Null otherwise.
  std::shared_ptr<const Solution> relaxed;
  /// If they were asked for; see brachisto::sensitivities().
  std::optional<Sensitivities> sensitivities;

  Effort effort;
  /// η_m at which the branch from the cycloid turned on its way to the scene's
  /// η_m. Usually empty. Otherwise the solution lies beyond a fold: connected
  /// with the cycloid, but not what it turns into as η_m grows.
  std::vector<double> folds;
  /// L [m] of the scene whose branch from the cycloid was followed back in L
  /// to this one, where the uniform cylinder has no path to B: then no branch
  /// of this scene is principal. Usually nothing.
  std::optional<double> continued_from_L;
  std::optional<ColdStart> cold_start;
  std::vector<Branch> branches;  ///< of Search::Global, fastest first
  /// What Search::Global left undone, its work being bounded; empty if nothing.
  std::string search_remark;
  std::optional<DesignAnswer> design;  ///< that chose the body, if one did

  /// The motion, found or given; null if there is none.
  [[nodiscard]] const Motion* motion() const;
  /// The finite problem solved; null if there is none.
  [[nodiscard]] const ProgramSize* program() const;
  /// Of a DiscreteSystem; null otherwise.
  [[nodiscard]] const DiscreteAnswer* discrete() const;
  /// For scenes not far from this one; see SolveHooks. Null if the answer is
  /// not the end of the branch from the cycloid: what lies beyond a fold is not
  /// what neighbours continue.
  [[nodiscard]] std::shared_ptr<const Neighbour> as_neighbour() const;

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
  /// See brachisto::undecided_because(); empty as long as nothing is solved.
  [[nodiscard]] std::vector<std::string> undecided_because() const;
  /// Forgets the answer with all that is known of it, not how it was sought.
  void discard_answer();
};

}  // namespace brachisto
