// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of a limited path changes with its scene.

#pragma once

#include <memory>

#include "refinement/prices.hpp"
#include "refinement/time_rates.hpp"

namespace brachisto {

/// Discs, half-planes and the floor stay where they are.
class LimitedRates final : public TimeRates {
 public:
  /// Null if the path is not found again with θ among its unknowns.
  [[nodiscard]] static std::unique_ptr<TimeRates> make(FittedPath path);

  [[nodiscard]] const Scene& scene() const override {
    return path_.curve.problem().scene();
  }
  [[nodiscard]] double time() const override {
    return path_.curve.transit_time();
  }
  [[nodiscard]] bool regular() const override { return sensitivity_.regular(); }
  [[nodiscard]] TimeRate by(SceneCoordinate coordinate) override;
  [[nodiscard]] std::unique_ptr<TimeRates> next(SceneCoordinate coordinate,
                                                double by) override;

 private:
  explicit LimitedRates(FittedPath path);
  LimitedRates(const LimitedRates&) = delete;
  LimitedRates& operator=(const LimitedRates&) = delete;
  /// The setting where the scene is another.
  [[nodiscard]] PathSetting setting_of(const Scene& scene) const;

  FittedPath path_;
  Sensitivity sensitivity_;
};

}  // namespace brachisto
