// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion that an arc_length problem found.

#pragma once

#include <span>
#include <vector>

#include "model/units.hpp"
#include "trajectory/prescribed_motion.hpp"

namespace brachisto {

class ArcLength;

/// A body on the smooth curve through nodes of a solution.
///
/// T, S and both end angles are those of the discrete solution. All that is
/// known of places between is the motion on the curve, which energy determines:
/// on a path from end to end, so that its time exceeds the least one by the
/// square of what the curve is off, whereas the discrete T errs by O(N⁻²).
///
/// The curve takes nodes √N/2 apart at first, then N^(1/4)/1.5 apart. The first
/// nodes of all, which are off by O(1/(N j²)) at node j in x/σ², are not among
/// them, so that what remains is O(N⁻²), and so is the error of interpolation
/// over the first pieces, (2√N)⁻⁴. At the start x/σ² is S cos β₀ and z/σ²
/// is S sin β₀ with the β₀ that the start demands: there R_n = 0 whatever N is,
/// and next to it R_n has the sign of its slope.
class ArcLengthMotion final : public Motion {
 public:
  /// \param x          a solution of `problem`
  /// \param T          its objective, in the units of the problem
  /// \param end_angle  β_end [rad]
  /// \param scene      in SI units
  ArcLengthMotion(const ArcLength& problem, std::span<const double> x, double T,
                  double end_angle, const Scene& scene, const Units& units);

  /// The motion on the curve through the nodes, which may stall if the mesh is
  /// much too coarse.
  [[nodiscard]] const PrescribedMotion& on_curve() const { return on_curve_; }

  /// The slope at the start that the nodes alone tell [rad].
  [[nodiscard]] double continued_start_angle() const {
    return continued_start_angle_;
  }

  [[nodiscard]] const Scene& scene() const override {
    return on_curve_.scene();
  }
  [[nodiscard]] double transit_time() const override { return transit_time_; }
  [[nodiscard]] double centre_path_length() const override { return length_; }
  [[nodiscard]] double start_angle() const override;
  [[nodiscard]] double end_angle() const override { return end_angle_; }
  [[nodiscard]] StartLimits at_start() const override;
  [[nodiscard]] TrajectoryPoint at(double sigma) const override {
    return on_curve_.at(sigma);
  }
  [[nodiscard]] std::vector<TrajectoryPoint> at_nodes() const override {
    return on_curve_.at_nodes();
  }
  [[nodiscard]] std::vector<TrajectoryPoint> fine_sample(
      int least) const override {
    return on_curve_.fine_sample(least);
  }
  /// Errors of extremes are told by the curve through half as many nodes: what
  /// the two differ by is about four times what interpolation leaves. What the
  /// nodes are off by is counted as N⁻² [m g].
  [[nodiscard]] PathDiagnostics diagnose() const override;

 private:
  ArcLengthMotion(const std::vector<int>& nodes, const ArcLength& problem,
                  std::span<const double> x, double T, double end_angle,
                  const Scene& scene, const Units& units);

  PrescribedMotion on_curve_;
  PlaneCurvePtr coarser_;  ///< through every second node of the curve
  double transit_time_, length_, end_angle_, continued_start_angle_;
  int num_pieces_;
};

}  // namespace brachisto
