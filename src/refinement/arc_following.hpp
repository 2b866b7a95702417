// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the path of one scene to that of another, step by step.

#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "refinement/arc_search.hpp"

namespace brachisto {

/// A scene on the way, and its limits.
struct Stage {
  std::vector<PathInequality> limits;
  std::optional<Scene> scene = {};  ///< nothing: that of the path
};

/// Of the way from one scene to another: shares of it.
struct WaySteps {
  double first, largest = 0.2, smallest = 1e-3;
};

/// The last path that was found on a way, and where on it.
struct Followed {
  std::optional<FittedPath> path;
  double share = 0.0;
  [[nodiscard]] bool arrived() const { return path && share == 1.0; }
};

/// Steps of Newton's method along one way: those that lead anywhere take a few
/// hundred.
inline constexpr int kMostFollowingSteps = 800;

/// Follows a path while limits and scene change, with arcs corrected and
/// contacts closed at every step; one that leads nowhere is made shorter.
///
/// \param most  steps of Newton's method
/// \return the last path; why it is not that of share 1, the protocol tells
[[nodiscard]] Followed follow(
    std::optional<FittedPath> path,
    const std::function<Stage(double share)>& stage_at, WaySteps steps,
    int degree, int most, ArcSearch& arcs, PassProtocol& protocol);

}  // namespace brachisto
