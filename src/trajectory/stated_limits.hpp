// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Limits as the scene states them, at points of a motion in SI units.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/trajectory/motion.hpp"
#include "model/limit_table.hpp"

namespace brachisto {

/// One bound of a scene.
struct StatedLimit {
  std::string name;  ///< as LimitOnPath has it
  std::optional<double> bound;
  std::optional<BoundInWords> words;  ///< nothing of what the body keeps off
  /// Distance from the bound in its unit, negative beyond it: as LimitEntry
  /// has it, or |C − P| − R − r of a disc, (C − P)·e − r of a half-plane.
  std::function<double(const TrajectoryPoint&)> slack;
  /// Whether it is the bound at which one of the path's inequalities is held;
  /// `index` counts those of its kind from 0.
  std::function<bool(PathInequality::Kind, int index, bool lower)> is;
  /// Adds to the bound, in the units of the limits; a half-plane moves along
  /// its normal.
  std::function<void(PathLimits&, double by)> move;
  double natural = 1.0;  ///< one of its unit in natural_units() of the scene
  std::string looser;    ///< "a lower floor"
};

/// All of a scene's, in the order of PathLimits. A disc or a half-plane is
/// counted from 1 where there are several.
[[nodiscard]] std::vector<StatedLimit> stated_limits(const Scene& scene);

}  // namespace brachisto
