// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The extremal of a scene on one given mesh.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "brachisto/model/cycloid.hpp"
#include "brachisto/solvers/ipopt.hpp"
#include "brachisto/transcription/extremal_curve.hpp"
#include "brachisto/transcription/smooth_contact.hpp"

namespace brachisto {

/// Where a solve on a mesh starts.
struct MeshStart {
  PrimalDual point;
  double phi = 0.0;             ///< [rad]
  double closure_slope = -1.0;  ///< d(mismatch)/dφ, −1 if unknown
};

/// Outcome of all passes on one mesh.
struct MeshSolution {
  Status status = Status::InternalError;
  std::string message;
  PrimalDual point;          ///< of the last pass that was solved
  ContactClosure closure;    ///< with Contact::Centre: one pass, closed
  int first_iterations = 0;  ///< of the first pass
  int iterations = 0;        ///< of all passes
  int refused_points = 0;    ///< in the first pass
  std::string log;

  [[nodiscard]] bool solved() const { return status == Status::Solved; }
};

/// Budget and precision of the passes on one mesh.
struct MeshOptions {
  IpoptOptions ipopt;
  ClosureOptions closure;
};

/// Solves the problem between fixed end points and closes the contact around
/// it, each pass warm-started from the one before.
///
/// A pass that Ipopt breaks off near the solution, because steps drown in
/// rounding, counts as solved if its KKT residual is below kRoundingResidual.
[[nodiscard]] MeshSolution solve_on_mesh(RollingTime& problem,
                                         const MeshStart& start,
                                         const MeshOptions& options);

inline constexpr double kRoundingResidual = 1e-10;

}  // namespace brachisto
