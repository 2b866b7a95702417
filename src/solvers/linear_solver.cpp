// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/linear_solver.hpp"

namespace brachisto {

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
