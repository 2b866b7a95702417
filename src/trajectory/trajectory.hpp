// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion that was found.

#pragma once

#include <span>
#include <vector>

#include "brachisto/trajectory/motion.hpp"
#include "model/units.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// A solution on its way out: an ExtremalCurve and the units it was solved in.
/// Its places are σ = u / U.
class Trajectory final : public Motion {
 public:
  /// \param scene         in SI units; its θ_m may differ from the curve's by
  ///                      whole turns
  /// \param transit_time  T [s], if it is known better than from the curve
  Trajectory(ExtremalCurve curve, const Scene& scene, const Units& units,
             std::optional<double> transit_time = std::nullopt);

  [[nodiscard]] const ExtremalCurve& curve() const { return curve_; }

  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] double transit_time() const override { return transit_time_; }
  [[nodiscard]] double centre_path_length() const override {
    return curve_.arc_length() * units_.length;
  }
  [[nodiscard]] double start_angle() const override;
  [[nodiscard]] double end_angle() const override {
    return curve_.at(1.0).beta;
  }
  [[nodiscard]] StartLimits at_start() const override;
  [[nodiscard]] TrajectoryPoint at(double sigma) const override {
    return convert(curve_.at(sigma), sigma);
  }
  /// At every node of the mesh.
  [[nodiscard]] std::vector<TrajectoryPoint> at_nodes() const override;
  [[nodiscard]] std::vector<TrajectoryPoint> fine_sample(
      int least) const override;
  /// `per_element` places in each element, the element's start left out; the
  /// first entry is the start of the path.
  [[nodiscard]] std::vector<TrajectoryPoint> sample(int per_element) const;

 private:
  [[nodiscard]] TrajectoryPoint convert(const ExtremalPoint& point,
                                        double sigma) const;
  /// At the start, and at the same places 0 < t ≤ 1 of all elements.
  [[nodiscard]] std::vector<TrajectoryPoint> at_places(
      std::span<const double> places) const;

  ExtremalCurve curve_;
  Scene scene_;
  Units units_;
  double transit_time_;
};

}  // namespace brachisto
