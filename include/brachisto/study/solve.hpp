// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A scene in, the fastest track out.

#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/continuation.hpp"
#include "brachisto/study/solve_options.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/trajectory.hpp"

namespace brachisto {

/// What was done to find a solution.
struct Effort {
  int iterations = 0;          ///< of the solver, in all passes on all meshes
  int first_iterations = 0;    ///< of the first pass on the final mesh
  int passes = 0;              ///< solves between fixed end points, in all
  int closure_passes = 0;      ///< of these on the final mesh
  double seconds = 0.0;        ///< wall clock, all of solve()
  double check_seconds = 0.0;  ///< of these for the certificate
  std::vector<ContinuationStep> continuation;  ///< empty: a cold start sufficed
};

/// Outcome of solve(). Numbers of the path live in `trajectory`; they are worth
/// something only if verified() is true.
struct Solution {
  Scene scene;
  SolveOptions options;
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
  std::optional<Trajectory> trajectory;
  std::optional<PathDiagnostics> diagnostics;
  Certificate certificate;
  /// Relative, of T: the difference to the same scene with degree p + 1, and
  /// what an open contact and rounding add.
  std::optional<double> estimated_error;
  int nodes = 0, variables = 0, constraints = 0;
  Effort effort;
  std::string log;  ///< of the solver, if asked for

  /// Solved, and every check of the certificate passed.
  [[nodiscard]] bool verified() const {
    return status == Status::Solved && certificate.verified();
  }
  /// Why the body could not run on this track: it would lift off (R_n ≤ 0) or
  /// the track folds (1 − r κ_c ≤ 0). Empty if neither happens; a bead on a
  /// wire can do both.
  [[nodiscard]] std::vector<std::string> infeasible_because() const;
  [[nodiscard]] bool feasible() const { return infeasible_because().empty(); }
};

/// What a caller may hook into.
struct SolveHooks {
  const std::atomic<int>* interrupt = nullptr;  ///< nonzero: stop
  bool verbose = false;                         ///< keep the solver's log
};

/// Finds the fastest track of a scene on the principal branch.
///
/// \throws std::invalid_argument if the scene is not valid()
[[nodiscard]] Solution solve(const Scene& scene,
                             const SolveOptions& options = {},
                             const SolveHooks& hooks = {});

}  // namespace brachisto
