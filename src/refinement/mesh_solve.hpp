// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The extremal of a scene on one given mesh.

#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/smooth_contact.hpp"

namespace brachisto {

/// Where a solve on a mesh starts.
struct MeshStart {
  PrimalDual point;
  double phi = 0.0;              ///< [rad]
  double tangency_slope = -1.0;  ///< d(mismatch)/dφ, −1 if unknown
};

/// What polishing did.
struct Polish {
  int newton_steps = 0;
  double residual_before = 0.0;  ///< largest of the full system
  double residual_after = 0.0;   ///< never larger
};

/// Outcome of all passes on one mesh.
struct MeshSolution {
  Status status = Status::InternalError;
  std::string message;
  PrimalDual point;          ///< of the last pass that was solved
  Tangency tangency;         ///< with Contact::Centre: one pass, closed
  Polish polish;             ///< all zero if not asked for
  int first_iterations = 0;  ///< of the first pass
  int iterations = 0;        ///< of all passes
  int refused_points = 0;    ///< in the first pass
  /// Of Ipopt, if it ran: Chain or Mumps.
  std::optional<LinearSolver> linear_solver;
  std::string log;

  [[nodiscard]] bool solved() const { return status == Status::Solved; }
};

/// Budget and precision of the passes on one mesh.
struct MeshOptions {
  IpoptOptions ipopt;
  bool polish = true;
  bool newton_alone = false;   ///< no Ipopt: stay_on_mesh() in place of passes
  bool fixed_ends = false;     ///< φ stays: the contact is closed elsewhere
  ProgressHook progress = {};  ///< may be empty
};

/// A pass that Ipopt breaks off near the solution, because steps drown in
/// rounding, counts as solved if its KKT residual is below this, or below what
/// is reachable() if that is more.
inline constexpr double kRoundingResidual = 1e-10;

/// The larger of `tolerance` and what rounding leaves of residuals at x.
[[nodiscard]] double reachable(double tolerance, const Transcription& problem,
                               std::span<const double> x);

/// Solves the problem between fixed end points with Ipopt and closes the
/// contact around it, each pass warm-started from the one before. With
/// polishing, Newton's method on the optimality conditions and the contact
/// together does the last digits.
[[nodiscard]] MeshSolution solve_on_mesh(Transcription& problem,
                                         MeshStart start,
                                         const MeshOptions& options);

/// Newton's method alone on the optimality conditions and the contact together:
/// it stays at the extremal that the start is close to, also at one that is no
/// minimum between its end points, which Ipopt would leave.
[[nodiscard]] MeshSolution stay_on_mesh(Transcription& problem, MeshStart start,
                                        const MeshOptions& options);

/// solve_on_mesh() from so near that many iterations only mean that Ipopt went
/// elsewhere.
[[nodiscard]] MeshSolution solve_near(Transcription& problem, MeshStart start,
                                      MeshOptions options);

/// Puts `stayed`, of stay_on_mesh(), in place of what Ipopt `left` for; the
/// work of that counts all the same.
void take_instead(MeshSolution& left, MeshSolution stayed);

}  // namespace brachisto
