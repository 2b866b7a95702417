// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion that was found under limits.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/trajectory/motion.hpp"
#include "model/units.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// A solution under limits on its way out, and the units it was solved in. Its
/// places are σ = u / U.
class LimitedMotion final : public Motion {
 public:
  /// \param scene         in SI units; its θ_m may differ from the curve's by
  ///                      whole turns
  /// \param transit_time  T [s], if it is known better than from the curve
  LimitedMotion(LimitedCurve curve, const Scene& scene, const Units& units,
                std::optional<double> transit_time = std::nullopt);

  [[nodiscard]] const LimitedCurve& curve() const { return curve_; }

  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] double transit_time() const override { return transit_time_; }
  [[nodiscard]] double centre_path_length() const override {
    return ends_.back().s * units_.length;
  }
  [[nodiscard]] double start_angle() const override {
    return curve_.at(0.0).state.beta;
  }
  [[nodiscard]] double end_angle() const override {
    return curve_.at(1.0).state.beta;
  }
  /// Where a limit of curvature or force holds from the start the curvature of
  /// the centre's path is finite there, otherwise dβ/du is not zero.
  [[nodiscard]] StartLimits at_start() const override;
  [[nodiscard]] TrajectoryPoint at(double sigma) const override;
  /// At every node of the mesh.
  [[nodiscard]] std::vector<TrajectoryPoint> at_nodes() const override;
  [[nodiscard]] std::vector<TrajectoryPoint> fine_sample(
      int least) const override;

 private:
  /// Time and length of the centre's path, in natural units.
  struct Passed {
    double t = 0.0, s = 0.0;
  };
  /// From the start of an element to its place t.
  [[nodiscard]] Passed within(int element, double t) const;
  [[nodiscard]] TrajectoryPoint convert(int element, double t) const;

  LimitedCurve curve_;
  Scene scene_;
  Units units_;
  double transit_time_;
  math::QuadratureRule rule_;
  std::vector<Passed> ends_;  ///< at the boundaries of elements
};

}  // namespace brachisto
