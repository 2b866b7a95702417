// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of a limited path changes with its bounds and its scene.

#pragma once

#include <memory>
#include <vector>

#include "refinement/arc_fit.hpp"
#include "refinement/path_system.hpp"
#include "refinement/time_rates.hpp"

namespace brachisto {

/// Derivatives of a fitted path: with a bound or the scene, junctions and the
/// slopes that the contacts are built from move so that all its conditions go
/// on to hold. The arcs stay; so do discs, half-planes and the floor where the
/// scene is another.
class LimitedRates final : public TimeRates {
 public:
  /// Of all coordinates of a scene. Null if the path is not found again with θ
  /// among its unknowns.
  [[nodiscard]] static std::unique_ptr<TimeRates> make(FittedPath path);

  explicit LimitedRates(FittedPath path);
  LimitedRates(const LimitedRates&) = delete;
  LimitedRates& operator=(const LimitedRates&) = delete;

  [[nodiscard]] const Scene& scene() const override {
    return path_.curve.problem().scene();
  }
  [[nodiscard]] double time() const override {
    return path_.curve.transit_time();
  }
  [[nodiscard]] bool regular() const override { return regular_; }
  [[nodiscard]] TimeRate by(SceneCoordinate coordinate) override;
  [[nodiscard]] std::unique_ptr<TimeRates> next(SceneCoordinate coordinate,
                                                double by) override;

  /// By a bound.
  /// \param less, more  the path's limits, one bound being smaller, greater
  /// \param width       by so much both together
  [[nodiscard]] TimeRate price(const std::vector<PathInequality>& less,
                               const std::vector<PathInequality>& more,
                               double width);

 private:
  /// By all that settings may differ in, their ends being those of the path.
  [[nodiscard]] TimeRate along(PathSetting less, PathSetting more,
                               double width);

  FittedPath path_;
  PathSystem system_;
  bool regular_;
  std::vector<PathRates> unknowns_;
};

}  // namespace brachisto
