// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which bodies a design has found.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"

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

/// A body that no other one near it is quicker than.
struct DesignMinimum {
  Body body;
  NamedNumbers values;  ///< of what is free
  double tau = 0.0;
  bool feasible = false;
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
  int found_from = 0;  ///< as many starts led here
};

/// A body on the way of a search.
struct DesignStep {
  NamedNumbers values;
  double tau = 0.0;
};

/// What a design came to. The best body is that of the Solution it belongs to.
struct DesignAnswer {
  std::optional<DesignMinimum> best;           ///< one of the minima, or none
  std::vector<DesignMinimum> minima;           ///< quickest first
  std::vector<std::vector<DesignStep>> paths;  ///< of each start
  int solves = 0;            ///< closed solutions, of all starts together
  double cpu_seconds = 0.0;  ///< of them
};

}  // namespace brachisto
