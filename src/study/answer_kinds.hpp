// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The kinds of answers, which a Solution keeps without showing them.

#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/study/solution.hpp"
#include "refinement/arcs.hpp"
#include "trajectory/arc_length_motion.hpp"
#include "trajectory/lane_motion.hpp"
#include "trajectory/prescribed_motion.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto {

/// Of the formulation rolling_time; of Shooting the extremal sampled on
/// a mesh, with its own T.
struct CollocationAnswer {
  Trajectory trajectory;
  ProgramSize program;
  PrimalDual point;  ///< of the problem in natural units on the mesh
  double phi = 0.0;  ///< [rad]
};

/// Of the formulation arc_length.
struct PiecewiseAnswer {
  ArcLengthMotion motion;
  ProgramSize program;
  PrimalDual point;  ///< of the problem in natural units
  double phi = 0.0;  ///< [rad]
};

/// Under limits, or with slopes at the contacts that are not the extremal's
/// own; of Shooting likewise a sample with its own T.
struct LimitedPathAnswer {
  LimitedMotion motion;
  ProgramSize program;
  std::vector<Arc> arcs;
  LimitedEnds ends;  ///< in natural units, as the motion's curve
};

/// Of a scene that was solved side by side with others.
struct LaneAnswer {
  LaneMotion motion;
};

/// The answers there are: found by collocation, found on straight pieces, found
/// under limits, the motion on the path that a scene states, a solution of the
/// paper's discrete system, which is not what is asked for, and one found side
/// by side with others.
struct Answer
    : std::variant<CollocationAnswer, PiecewiseAnswer, LimitedPathAnswer,
                   PrescribedMotion, DiscreteAnswer, LaneAnswer> {
  using variant::variant;
};

/// The answer if it is of that kind; null if it is another or there is none.
template <class Kind>
[[nodiscard]] const Kind* answer_as(
    const std::shared_ptr<const Answer>& answer) {
  return answer == nullptr ? nullptr : std::get_if<Kind>(answer.get());
}

/// The motion of a CollocationAnswer; null if the answer is another.
[[nodiscard]] inline const Trajectory* trajectory_of(const Solution& solution) {
  const auto* found = answer_as<CollocationAnswer>(solution.answer);
  return found == nullptr ? nullptr : &found->trajectory;
}

}  // namespace brachisto
