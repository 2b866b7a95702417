// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solution.hpp"

#include <cmath>

#include "brachisto/trajectory/feasibility.hpp"
#include "study/start.hpp"

namespace brachisto {

Work& Work::operator+=(const Work& other) {
  iterations += other.iterations;
  passes += other.passes;
  newton_steps += other.newton_steps;
  log += other.log;
  return *this;
}

const Motion* Solution::motion() const {
  if (const Trajectory* found = trajectory()) return found;
  if (const auto* pieces = std::get_if<PiecewiseAnswer>(&answer)) {
    return &pieces->motion;
  }
  return std::get_if<PrescribedMotion>(&answer);
}

const Trajectory* Solution::trajectory() const {
  const auto* found = std::get_if<CollocationAnswer>(&answer);
  return found == nullptr ? nullptr : &found->trajectory;
}

const ProgramSize* Solution::program() const {
  if (const auto* found = std::get_if<CollocationAnswer>(&answer)) {
    return &found->program;
  }
  const auto* pieces = std::get_if<PiecewiseAnswer>(&answer);
  return pieces == nullptr ? nullptr : &pieces->program;
}

std::optional<Neighbour> Solution::as_neighbour() const {
  const auto* found = std::get_if<CollocationAnswer>(&answer);
  if (found == nullptr || !folds.empty() || !options.follows_the_branch()) {
    return std::nullopt;
  }
  return Neighbour{without_whole_turns(scene), found->trajectory.curve().mesh(),
                   found->point, found->phi};
}

bool Solution::verified() const {
  const Motion* path = motion();
  return status == Status::Solved && certificate.verified() &&
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
  answer = {};
  diagnostics.reset();
  estimated_error.reset();
  extremal.reset();
  certificate = {};
}

}  // namespace brachisto
