// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The second stage of a solve: an extremal on a coarse mesh.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "refinement/limited_refinement.hpp"
#include "search/continuation.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// Where refinement starts, and how that was found.
struct Start : Continuation {
  std::vector<double> folds;                    ///< see Solution::folds
  std::optional<double> continued_from_L = {};  ///< see Solution
  /// In the ordinary world, with its φ, where none was reached in this one but
  /// under limits there may be a path all the same; otherwise nothing.
  std::optional<ExtremalCurve> ordinary = {};
  double ordinary_phi = 0.0;
};

/// The principal branch. Where its continuation in natural parameters is stuck,
/// pseudo-arclength continuation of the indirect method goes on: through folds,
/// and past near meetings of branches. Into another world the extremal is
/// continued from there; where that fails, the uniform body goes first, and its
/// offset grows in that world.
///
/// Where the uniform cylinder has no path to B, an off-centred body may have
/// one: then a scene of greater L, where both have one, is started from, and
/// its extremal followed back in L. What that does not reach is
/// Status::NotReached, but Status::NoAdmissiblePath of the uniform cylinder
/// itself, from rest, with slopes of its own in a uniform field.
[[nodiscard]] Start start_from_cycloid(const PosedProblem& posed);

/// How a solve ends that can only start from the cycloid, of a scene without
/// one.
[[nodiscard]] Outcome without_cycloid(const PosedProblem& posed);

/// Whether the answer is the end of one branch, which the neighbour's extremal
/// can_continue() to.
[[nodiscard]] bool can_start_beside(const PosedProblem& posed,
                                    const Neighbour& neighbour);

[[nodiscard]] Start start_beside(const PosedProblem& posed,
                                 const Neighbour& neighbour);

/// The neighbour's path, if both scenes have limits and are comparable().
[[nodiscard]] std::optional<FittedPath> path_beside(const PosedProblem& posed,
                                                    const Neighbour& neighbour);

/// A start of Guess::Straight or Guess::Random and the work it took.
struct OtherStart {
  ColdStart cold;
  Work work;
};

/// Runs the solver from the guess that the options ask for, on the mesh of the
/// principal branch, and says where it led. The principal branch stays the
/// answer.
///
/// \param principal  with a curve
/// \param done       before; it may take half of what is left
[[nodiscard]] OtherStart start_elsewhere(const PosedProblem& posed,
                                         const Start& principal,
                                         const Work& done);

}  // namespace brachisto
