// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "brachisto/trajectory/feasibility.hpp"
#include "study/wider_search.hpp"

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

std::string Solution::advice() const {
  const Check* second_order = certificate.find("second_order");
  if (second_order == nullptr || !(second_order->value > 0.0)) return {};
  const std::string search = wider_search(scene.contact, options);
  if (search.empty()) return {};
  return "the extremal is no minimum between its fixed ends; " + search +
         " looks for those that are";
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
