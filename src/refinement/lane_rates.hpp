// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of an extremal that was shot for changes with its scene.

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lanes/many_scenes.hpp"
#include "refinement/time_rates.hpp"

namespace brachisto {

/// With R(y, p) = 0 the conditions at B, y being the costates at the start and
/// U, R_y and T_y from the flow and R_p, T_p from shots of scenes next to this
/// one, all with the same y:
///
///     y_p = −R_y⁻¹ R_p,   dT/dp = T_p + T_y y_p.
///
/// Steps change more of these than of T: of dτ/dp of random scenes, whose T
/// errs by less than 1e-10, at most 2e-9 (docs/benchmarks.md, Sweeps). Where
/// shots spread so fast that orders above four matter it is not a number.
class LaneRates final : public TimeRates {
 public:
  /// \param natural   the scene of the extremal, in natural units
  LaneRates(const Scene& natural, std::shared_ptr<const lanes::Extremal>);

  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] double time() const override { return extremal_->transit_time; }
  [[nodiscard]] bool regular() const override { return true; }
  void expect(std::span<const SceneCoordinate> coordinates) override;
  [[nodiscard]] TimeRate by(SceneCoordinate coordinate) override;
  [[nodiscard]] double contact_response() override;
  /// Not known.
  [[nodiscard]] std::unique_ptr<TimeRates> next(SceneCoordinate,
                                                double) override {
    return nullptr;
  }

 private:
  /// Of T, the slopes at B and at A, and R.
  struct Rates {
    double time = 0.0, beta = 0.0, start_beta = 0.0;
    Eigen::VectorXd open;
  };

  /// Of one of the slopes, the unknowns moving along.
  [[nodiscard]] double slope_rate(double Rates::*slope, Rates direct) const;

  Scene scene_;  ///< its start is built from the slope of the extremal
  std::shared_ptr<const lanes::Extremal> extremal_;
  std::vector<Rates> unknowns_;
  /// By a number of the scene, all unknowns held, and what orders above four
  /// have in them.
  struct Direct {
    Rates rates, of_high_orders;
  };
  std::array<std::optional<Direct>, kSceneCoordinates.size()> direct_;
};

}  // namespace brachisto
