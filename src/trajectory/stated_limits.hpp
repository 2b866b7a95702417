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
#include "model/path_inequality.hpp"

namespace brachisto {

/// A bound in words: "R_n ≥ 0.1 m g".
struct BoundInWords {
  std::string_view quantity;  ///< two of one quantity are a range of it
  std::string_view relation;
  double number = 0.0;
  std::string_view unit;
};

/// One bound of a scene.
struct StatedLimit {
  std::string name;  ///< as LimitOnPath has it
  std::optional<double> bound;
  std::optional<BoundInWords> words;  ///< nothing of what the body keeps off
  /// Distance from the bound in its unit, negative beyond it:
  ///
  ///     μ R_n − |R_t|,  R_n − ρ_min,  ρ_max − R_n,  K − κ,  K + κ,
  ///     1 − r κ_c − m,  D − r − z,  |C − P| − R − r,  (C − P)·e − r
  ///
  /// with κ the curvature of the track or of the centre's path.
  std::function<double(const TrajectoryPoint&)> slack;
  /// Whether it is the bound at which one of the path's inequalities is held;
  /// `index` counts those of its kind from 0. Of a bound on the hump and a fold
  /// margin the sharper one is in force.
  std::function<bool(PathInequality::Kind, int index, bool lower)> is;
  /// Adds to the bound, in the units of the limits; a half-plane moves along
  /// its normal.
  std::function<void(PathLimits&, double by)> move;
  double natural = 1.0;  ///< one of its unit in natural_units() of the scene
};

/// All of a scene's, in the order of PathLimits. A disc or a half-plane is
/// counted from 1 where there are several.
[[nodiscard]] std::vector<StatedLimit> stated_limits(const Scene& scene);

}  // namespace brachisto
