// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A family of scenes and what came out for each, as a table.

#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace brachisto {

/// A key of the problem file that differs between the scenes of a sweep.
struct SweepColumn {
  std::string key;                   ///< dotted, "scene.body.eta_m"
  std::vector<double> numbers = {};  ///< one per scene, SI units, rad; or
  std::vector<std::string> words =
      {};  ///< one per scene, if it is not a number

  [[nodiscard]] bool numeric() const { return words.empty(); }
};

/// A direction of the product: the columns that change along it together.
struct SweepAxis {
  std::vector<std::size_t> columns;
  std::size_t count = 0;  ///< values
  bool ordered = true;    ///< false for a random sample
};

/// A stretch of a path along which a limit holds.
struct SweepArc {
  std::string limit;            ///< its name, "friction"
  double from = 0.0, to = 0.0;  ///< shares of the transit time
};

/// What came out for one scene.
struct SweepOutcome {
  /// Missing: not run yet. Failed: no verified result.
  enum class State { Missing, Failed, Verified };
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  State state = State::Missing;
  std::string status;   ///< of the result, "solved", "crashed", …
  std::string message;  ///< why, if it failed
  bool feasible = false;
  // NaN unless verified:
  double tau = kNone;               ///< T / √(H / 2g)
  double transit_time = kNone;      ///< T [s]
  double estimated_error = kNone;   ///< relative, of T
  double end_angle = kNone;         ///< [rad]
  std::vector<SweepArc> arcs = {};  ///< in the order of the path
  std::vector<std::string> infeasible_because = {};
  /// η_m at which the branch from the cycloid turned on the way to the scene.
  std::vector<double> folds = {};
};

/// A key that has the same number in all scenes without being swept.
struct SweepConstant {
  std::string key;
  double value = 0.0;  ///< SI units, rad
};

/// Scene number i has the index along each axis that i has in a product whose
/// last axis is the fastest. Columns that belong to no axis depend on others.
struct SweepTable {
  std::string title;
  std::vector<SweepColumn> columns;
  std::vector<SweepAxis> axes;
  std::vector<SweepConstant> constants;  ///< what else τ depends on
  std::vector<SweepOutcome> outcomes;    ///< one per scene
};

}  // namespace brachisto
