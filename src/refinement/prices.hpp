// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of a limited path changes with its bounds.

#pragma once

#include <vector>

#include "refinement/arc_fit.hpp"
#include "refinement/path_system.hpp"

namespace brachisto {

/// dT/d(bound), in natural units.
struct Price {
  double total = 0.0;              ///< the contacts moving along
  double at_fixed_contacts = 0.0;  ///< what the multipliers say
};

/// Derivatives of a fitted path: with a bound, junctions and the slopes that
/// the contacts are built from move so that all its conditions go on to hold.
/// The arcs stay.
class Sensitivity {
 public:
  /// \param path  must outlive this
  explicit Sensitivity(const FittedPath& path);

  /// False if the optimality conditions are singular: then there are no prices.
  [[nodiscard]] bool regular() const { return regular_; }

  /// \param less, more  the path's limits, one bound being smaller, greater
  /// \param width       by so much both together
  [[nodiscard]] Price price(const std::vector<PathInequality>& less,
                            const std::vector<PathInequality>& more,
                            double width);

 private:
  const Scene& scene_;
  PathSystem system_;
  bool regular_;
  std::vector<PathRates> unknowns_;
};

}  // namespace brachisto
