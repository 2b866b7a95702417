// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a solve ended, and who factorised its matrices.

#pragma once

#include <string_view>

#include "brachisto/math/clock.hpp"

namespace brachisto {

/// How a solver stopped; what the point is worth is for the certificate.
enum class Status {
  Solved,            ///< the conditions hold to the wanted tolerance
  NotConverged,      ///< the solver stopped without reaching the tolerance
  NotEvaluable,      ///< the iteration ran into points where the model is
                     ///< undefined
  IterationLimit,    ///< limits.iterations reached
  TimeLimit,         ///< limits.seconds reached
  Interrupted,       ///< SIGINT or SIGTERM
  OutOfMemory,       ///< there is less memory than it takes
  NoAdmissiblePath,  ///< no path can exist
  NotReached,        ///< no branch was followed to the scene; there may be one
  NoSmoothContact,   ///< under the limits no slope at B continues the path
  NoFastestTrack,  ///< none is reached by the sharper and sharper turns at rest
                   ///< that its limits allow
  Infeasible,      ///< the solver ended where limits give way at any price
  Stalled,         ///< on a given path the body does not arrive
  InternalError,   ///< the solver reported a fault of the set-up
};

/// One word, as in result files: "solved", "time_limit".
[[nodiscard]] std::string_view name(Status status);

/// How a solve ends that `stop` ended: Interrupted or TimeLimit.
[[nodiscard]] Status stopped_by(const StopCondition& stop);

/// True if a limit of time or a signal ended the solve, or would have.
[[nodiscard]] constexpr bool was_stopped(Status status) {
  return status == Status::TimeLimit || status == Status::Interrupted;
}

/// One sentence for the user.
[[nodiscard]] std::string_view describe(Status status);

/// Factorisation of symmetric indefinite matrices.
enum class LinearSolver {
  Auto,   ///< Chain where the problem is a chain, Mumps otherwise
  Chain,  ///< along the chain of elements; only for such problems
  Mumps,  ///< multifrontal, for any sparsity
};

/// "auto", "chain", "mumps".
[[nodiscard]] std::string_view name(LinearSolver solver);

}  // namespace brachisto
