// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The bounds that a scene may state with one number each.

#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "brachisto/model/kinematics.hpp"
#include "brachisto/model/scene.hpp"
#include "model/path_inequality.hpp"

namespace brachisto {

/// A bound in words: "R_n ≥ 0.1 m g".
struct BoundInWords {
  std::string_view quantity;  ///< two of one quantity are a range of it
  std::string_view relation;
  double number = 0.0;
  std::string_view unit;
};

/// What a path without limits does that limits may forbid, from u = 0.05 U on.
struct FreePath {
  double min_normal = std::numeric_limits<double>::infinity();
  double max_normal = -std::numeric_limits<double>::infinity();
  double max_hump = 0.0;  ///< of κ_c
  double deepest = 0.0;
  std::vector<TurningPoint<double>> places = {};  ///< of the whole path
};

/// One bound: what units, checks, problem files, words, results and the way
/// from a path without limits know of it. Its formula is value_of().
struct LimitEntry {
  const char* key;        ///< of problem files, below "scene.limits."
  const char* meaning;    ///< in the words of their reference
  const char* unit = "";  ///< of SI, or "m g"
  Dimension dimension = {};
  Allowed allowed;
  const char* reason = "";  ///< why nothing else is
  std::optional<double>& (*bound_in)(PathLimits&);
  BoundInWords (*words)(const PathLimits&, double bound);
  /// Distance from the bound in its unit, negative beyond it:
  ///
  ///     μ R_n − |R_t|,  R_n − ρ_min,  ρ_max − R_n,  K − κ,  K + κ,
  ///     1 − r κ_c − m,  D − r − z
  ///
  /// with κ the curvature of the track or of the centre's path.
  double (*slack)(const Scene&, double bound, Point centre, const Kinematics&);
  /// Whether it is the bound at which one of the path's inequalities is held.
  /// Of a bound on the hump and a fold margin the sharper one is in force.
  bool (*is)(const Scene&, PathInequality::Kind, bool lower);
  /// The bound in loosened_limits().
  double (*loosened)(const Scene&, double bound, double by);
  /// Adds its inequalities; nullptr where they are another bound's as well,
  /// which adds them.
  void (*pose)(const Body&, const PathLimits&, std::vector<PathInequality>&);
  /// Widens such an inequality to what a free path keeps. Whether its number
  /// grows by factors then, and not by steps.
  bool (*widen)(const Scene&, const FreePath&, PathInequality&);

  [[nodiscard]] const std::optional<double>& bound(
      const PathLimits& limits) const {
    return bound_in(const_cast<PathLimits&>(limits));  // which changes nothing
  }
  /// What it keeps bodies off, where that is a half-plane.
  HalfPlane (*forbids)(double bound) = nullptr;
  const char* looser;  ///< what to try where it leaves no path

  /// As LimitOnPath has it.
  [[nodiscard]] std::string_view name() const;
};

/// In the order of PathLimits.
[[nodiscard]] std::span<const LimitEntry> limit_table();

}  // namespace brachisto
