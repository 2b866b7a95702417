// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "brachisto/trajectory/feasibility.hpp"

namespace brachisto {

bool Solution::verified() const {
  const Motion* path = motion();
  return status == Status::Solved && !discrete && certificate.verified() &&
         path != nullptr && std::isfinite(path->tau());
}

std::vector<std::string> Solution::infeasible_because() const {
  if (!diagnostics) return {};
  return brachisto::infeasible_because(scene, *diagnostics);
}

std::vector<std::string> Solution::not_verified_because() const {
  return brachisto::not_verified_because(certificate);
}

void Solution::discard_answer() {
  trajectory.reset();
  discrete.reset();
  through_nodes.reset();
  diagnostics.reset();
  estimated_error.reset();
  extremal.reset();
  as_neighbour.reset();
  certificate = {};
  nodes = variables = constraints = 0;
}

}  // namespace brachisto
