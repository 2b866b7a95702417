// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pseudo-arclength continuation of extremals in a parameter of the scene.

#pragma once

#include <functional>
#include <vector>

#include "extremal/arc_system.hpp"

namespace brachisto::arcs {

/// Scenes that a parameter leads through, in natural units; analytic in it.
struct Family {
  std::function<Scene(double)> scene;
  double from = 0.0, to = 1.0;
  bool follow_folds = false;  ///< on from where the parameter turns back
};

enum class BranchEnd {
  Reached,    ///< the last parameter
  TurnsBack,  ///< a fold, and no leave to follow it; or back before the first
  StepTooSmall,
  NoStart,  ///< Newton's method fails at the first parameter
  MaxSteps,
};

struct BranchPoint {
  double parameter = 0.0;
  double phi = 0.0;           ///< slope angle at B [rad]
  double transit_time = 0.0;  ///< to some 8 digits
};

struct FollowedBranch {
  BranchEnd end = BranchEnd::NoStart;
  ArcSystem::Point point;           ///< the last one reached
  std::vector<BranchPoint> points;  ///< from the first on
  std::vector<double> folds;        ///< parameters where the branch turned
  int rejected_steps = 0;
  int newton_steps = 0;
};

/// Follows the branch through a solution of the family's first scene.
///
/// The unknowns are moved along the tangent of the branch and corrected in the
/// hyperplane across it (Keller 1977), so that folds are no obstacle. The step
/// is controlled by the contraction of Newton's method and by the turn of the
/// tangent, in order not to fall onto a neighbouring branch.
///
/// \param system   of the first scene
/// \param start    a solution of it, or nearly one
/// \param reached  is told the parameter of every point
/// \pre the system is one free arc, from < to, and the family has scenes next
/// to its last one
[[nodiscard]] FollowedBranch follow_branch(
    const ArcSystem& system, const ArcSystem::Point& start,
    const Family& family, const std::function<void(double)>& reached = {});

}  // namespace brachisto::arcs
