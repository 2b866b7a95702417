// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/status.hpp"

#include "brachisto/solvers/linear_solver.hpp"

namespace brachisto {

std::string_view name(Status status) {
  switch (status) {
    case Status::Solved:
      return "solved";
    case Status::NotConverged:
      return "not_converged";
    case Status::NotEvaluable:
      return "not_evaluable";
    case Status::IterationLimit:
      return "iteration_limit";
    case Status::TimeLimit:
      return "time_limit";
    case Status::Interrupted:
      return "interrupted";
    case Status::OutOfMemory:
      return "out_of_memory";
    case Status::NoAdmissiblePath:
      return "no_admissible_path";
    case Status::Stalled:
      return "stalled";
    case Status::InternalError:
      return "internal_error";
  }
  return "unknown";
}

Status stopped_by(const StopCondition& stop) {
  return stop.interrupted() ? Status::Interrupted : Status::TimeLimit;
}

std::string_view describe(Status status) {
  switch (status) {
    case Status::Solved:
      return "The optimality conditions hold to the wanted tolerance.";
    case Status::NotConverged:
      return "The iteration stopped before the optimality conditions held.";
    case Status::NotEvaluable:
      return "The iteration ran into points where the body would not move on "
             "(w ≤ 0, U ≤ 0 or A ≤ 0).";
    case Status::IterationLimit:
      return "The limit on iterations was reached.";
    case Status::TimeLimit:
      return "The limit on wall-clock time was reached.";
    case Status::Interrupted:
      return "The solve was interrupted.";
    case Status::OutOfMemory:
      return "There is not enough memory.";
    case Status::NoAdmissiblePath:
      return "No path satisfies the conditions of the scene.";
    case Status::Stalled:
      return "The body does not reach the end of the given path.";
    case Status::InternalError:
      return "The solver reported an internal error.";
  }
  return "Unknown status.";
}

std::string_view name(LinearSolver solver) {
  switch (solver) {
    case LinearSolver::Auto:
      return "auto";
    case LinearSolver::Chain:
      return "chain";
    case LinearSolver::Mumps:
      return "mumps";
  }
  return "";
}

}  // namespace brachisto
