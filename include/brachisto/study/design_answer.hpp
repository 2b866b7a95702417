// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which bodies a design has found.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/study/design_plan.hpp"

namespace brachisto {

/// A number of a design under the name that its file or its result has for it;
/// in SI units, angles in radians.
struct NamedNumber {
  std::string name;
  double value = 0.0;
};
using NamedNumbers = std::vector<NamedNumber>;

/// A bound that the best body leans on.
struct BoundOfDesign {
  std::string name;  ///< key of the bound, or what it is a bound of
  double bound = 0.0;
  double multiplier = 0.0;  ///< dτ/d(bound), the contacts moving along
};

/// A body that no other one near it is quicker than; or, where a search was
/// lost at the edge of a fold, the quickest one that it has passed.
struct DesignMinimum {
  bool stationary = false;  ///< the former: first-order conditions hold
  Body body;
  NamedNumbers values;  ///< of what is free
  double tau = 0.0;
  bool feasible = false;  ///< with DesignPlan::max_grip, if there is one
  /// Solved anew from the cycloid its track passed every check, and has this τ:
  /// it lies on the principal branch.
  bool verified = false;
  std::vector<std::string> remarks;  ///< why not feasible, why not verified
  NamedNumbers gradient;  ///< dτ/d(value), the contacts moving along
  std::vector<BoundOfDesign> bounds_active;
  /// Eigenvalues, ascending, of the second derivative of τ along the bounds
  /// that hold, by the design's own coordinates; empty if all are held, or if
  /// it could not be had.
  std::vector<double> curvatures;
  int found_from = 0;  ///< as many searches led here
};

/// A body on the way of a search.
struct DesignStep {
  NamedNumbers values;
  double tau = 0.0;
};

/// Bodies on the way of a search, in their order.
using DesignPath = std::vector<DesignStep>;

/// A way of a search that led to no body.
struct LostSearch {
  int search = 0;      ///< its number, from 1 on
  std::string reason;  ///< in words
};

/// What a design came to. The best body is that of the Solution it belongs to.
struct DesignAnswer {
  DesignPlan plan;                    ///< what was asked for
  std::optional<DesignMinimum> best;  ///< one of the minima, or none
  std::vector<DesignMinimum> minima;  ///< quickest first
  std::vector<LostSearch> lost;       ///< each was begun again elsewhere
  std::vector<DesignPath> paths;      ///< of all ways
  int searches = 0;                   ///< that ended
  int starts = 0;  ///< bodies that they began at, in place of lost
                   ///< ones too
  int solves = 0;  ///< closed solutions, of all searches together
  /// The limit of time came before all searches had ended: if none had, the
  /// best is the quickest body that one had reached.
  bool stopped = false;
  double cpu_seconds = 0.0;  ///< of them
};

}  // namespace brachisto
