// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of a limited path changes with its bounds and its scene.

#pragma once

#include <vector>

#include "refinement/arc_fit.hpp"
#include "refinement/path_system.hpp"
#include "refinement/time_rates.hpp"

namespace brachisto {

/// Derivatives of a fitted path: with a bound or the scene, junctions and the
/// slopes that the contacts are built from move so that all its conditions go
/// on to hold. The arcs stay.
class Sensitivity {
 public:
  /// \param path  must outlive this
  explicit Sensitivity(const FittedPath& path);

  /// False if the optimality conditions are singular: then there are none.
  [[nodiscard]] bool regular() const { return regular_; }

  /// \param less, more  the path's limits, one bound being smaller, greater
  /// \param width       by so much both together
  [[nodiscard]] TimeRate price(const std::vector<PathInequality>& less,
                               const std::vector<PathInequality>& more,
                               double width);
  /// The same of all that a setting may differ in, its ends being those of the
  /// path.
  [[nodiscard]] TimeRate along(PathSetting less, PathSetting more,
                               double width);
  [[nodiscard]] const PathSetting& setting() const { return system_.setting(); }

 private:
  const Scene& scene_;
  PathSystem system_;
  bool regular_;
  std::vector<PathRates> unknowns_;
};

}  // namespace brachisto
