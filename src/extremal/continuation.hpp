// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pseudo-arclength continuation of extremals in the offset η.

#pragma once

#include "extremal/newton.hpp"
#include "extremal/shooting.hpp"

namespace brachisto::shooting {

enum class BranchEnd {
  Reached,    ///< η_m
  TurnsBack,  ///< a fold, and no leave to follow it; or back at η = 0
  StepTooSmall,
  NoStart,  ///< Newton's method fails at η = 0
  MaxSteps,
  Stopped,  ///< from outside
};

struct FollowedBranch {
  BranchEnd end = BranchEnd::NoStart;
  ChainVector point;          ///< the last one reached
  ContinuationReport report;  ///< times in natural units
  int newton_steps = 0;
};

/// Follows the branch through `start`, a solution for η = 0, to η = `target`.
///
/// The unknowns are moved along the tangent of the branch and corrected in the
/// hyperplane across it (Keller 1977), so that folds in η are no obstacle. The
/// step is controlled by the contraction of Newton's method and by the turn of
/// the tangent, in order not to fall onto a neighbouring branch.
[[nodiscard]] FollowedBranch follow_branch(const ShootingSystem& system,
                                           const ChainVector& start,
                                           const ChainScale& scale,
                                           double target,
                                           const ExtremalOptions& options);

}  // namespace brachisto::shooting
