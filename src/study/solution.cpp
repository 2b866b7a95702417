// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solution.hpp"

#include <fmt/format.h>

#include <cmath>

#include "refinement/mesh_choice.hpp"
#include "search/continuation.hpp"
#include "study/answer_kinds.hpp"
#include "study/blocking_limit.hpp"
#include "study/wider_search.hpp"
#include "trajectory/feasibility.hpp"

namespace brachisto {

const Motion* Solution::motion() const {
  if (const Trajectory* found = trajectory_of(*this)) return found;
  if (const auto* pieces = answer_as<PiecewiseAnswer>(answer)) {
    return &pieces->motion;
  }
  if (const auto* limited = answer_as<LimitedPathAnswer>(answer)) {
    return &limited->motion;
  }
  if (const auto* one_of_many = answer_as<LaneAnswer>(answer)) {
    return &one_of_many->motion;
  }
  return answer_as<PrescribedMotion>(answer);
}

const ProgramSize* Solution::program() const {
  if (const auto* found = answer_as<CollocationAnswer>(answer)) {
    return &found->program;
  }
  if (const auto* limited = answer_as<LimitedPathAnswer>(answer)) {
    return &limited->program;
  }
  const auto* pieces = answer_as<PiecewiseAnswer>(answer);
  return pieces == nullptr ? nullptr : &pieces->program;
}

const DiscreteAnswer* Solution::discrete() const {
  return answer_as<DiscreteAnswer>(answer);
}

std::shared_ptr<const Neighbour> neighbour_of(const Solution& solution) {
  if (!solution.options.follows_the_branch()) return nullptr;
  const Scene& scene = solution.scene;
  if (const auto* limited = answer_as<LimitedPathAnswer>(solution.answer)) {
    if (limited->arcs.empty()) return nullptr;
    const LimitedCurve& curve = limited->motion.curve();
    return std::make_shared<const Neighbour>(Neighbour{
        without_whole_turns(scene), curve.problem().mesh(), curve.point(),
        limited->ends.phi, limited->arcs, limited->ends});
  }
  const auto* found = answer_as<CollocationAnswer>(solution.answer);
  if (found == nullptr) return nullptr;
  return std::make_shared<const Neighbour>(
      Neighbour{without_whole_turns(scene), found->trajectory.curve().mesh(),
                found->point, found->phi});
}

std::shared_ptr<const Neighbour> Solution::as_neighbour() const {
  return folds.empty() ? neighbour_of(*this) : nullptr;
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

std::vector<std::string> Solution::undecided_because() const {
  if (!diagnostics) return {};
  return brachisto::undecided_because(scene, *diagnostics);
}

std::vector<std::string> Solution::not_verified_because() const {
  return brachisto::not_verified_because(certificate);
}

std::string Solution::advice() const {
  const Check* turn = certificate.find("weierstrass");
  if (turn != nullptr && turn->value > kAnotherSlope) {
    return fmt::format(
        "another slope would be faster about {}: the fastest path may turn on "
        "the spot there, which no smooth one does; a smaller eta_m{} may let "
        "it be smooth",
        turn->where, scene.world.air.any() ? " or less air" : "");
  }
  const Check* second_order = certificate.find("second_order");
  if (second_order == nullptr || !(second_order->value > 0.0)) {
    constexpr double kTouches = 1e-6;
    const Check* kept = certificate.find("limits");
    const auto* program = options.of<Collocation>();
    if (kept != nullptr && !kept->passed && kept->value <= kTouches &&
        program != nullptr && !program->discretisation.fixed()) {
      return fmt::format(
          "a bound that is a millionth larger or smaller: the path touches "
          "that of {}, along less than can be resolved",
          kept->where);
    }
    // Next to what no path keeps, multipliers grow and lose their digits.
    const Check* signs = certificate.find("multiplier_signs");
    return signs == nullptr || signs->passed ? std::string()
                                             : looser_limits(scene);
  }
  const std::string search = wider_search(scene, options);
  if (search.empty()) return {};
  return "the extremal is no minimum between its fixed ends; " + search +
         " looks for those that are";
}

void Solution::discard_answer() {
  answer.reset();
  diagnostics.reset();
  estimated_error.reset();
  limits.clear();
  relaxed.reset();
  sensitivities.reset();
  extremal.reset();
  certificate = {};
}

}  // namespace brachisto
