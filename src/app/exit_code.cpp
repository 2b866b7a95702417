// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/exit_code.hpp"

namespace brachisto::app {

int exit_code(const Solution& solution, int signal) {
  switch (solution.status) {
    case Status::Solved:
      if (!solution.verified()) return kNotSolved;
      return solution.feasible() ? kSuccess : kInfeasible;
    case Status::IterationLimit:
    case Status::TimeLimit:
    case Status::OutOfMemory:
      return kLimit;
    case Status::Interrupted:
      return kSignalBase + signal;
    case Status::InternalError:
      return kInternalError;
    case Status::NotConverged:
    case Status::NotEvaluable:
    case Status::NoAdmissiblePath:
    case Status::Stalled:
      return kNotSolved;
  }
  return kInternalError;
}

}  // namespace brachisto::app
