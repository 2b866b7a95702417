// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A body on a given path, released from rest.

#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "brachisto/model/plane_curve.hpp"
#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// Why a body does not get to the end of a given path.
struct Stall {
  enum class Reason {
    DoesNotStart,  ///< at rest it is not drawn along the path
    Stops,         ///< its energy is used up on the way
    DoesNotFit,    ///< a valley of the track is narrower than the body
  };
  Reason reason = Reason::Stops;
  double q = 0.0;  ///< where
  Point centre;    ///< where [m]

  [[nodiscard]] std::string message() const;
};

/// The motion along a given path of the centre, which energy alone determines:
///
///     w² = 2 g E,  dt = √(A / 2gE) ds,  θ = θ_m + s / r,
///
/// integrated over the curve's own parameter by Gauss rules on cells that are
/// halved until T does not change.
class PrescribedMotion final : public Motion {
 public:
  /// \param centre  path of the centre, in metres; see centre_path_over()
  PrescribedMotion(const Scene& scene, PlaneCurvePtr centre);

  /// Set if the body does not arrive; then there are no other results.
  [[nodiscard]] const std::optional<Stall>& stall() const { return stall_; }
  /// Relative, of T: what the last halving of the cells changed.
  [[nodiscard]] double error_estimate() const { return error_; }
  [[nodiscard]] int num_cells() const {
    return static_cast<int>(cells_.size()) - 1;
  }

  [[nodiscard]] const PlaneCurve& curve() const { return *curve_; }
  /// dβ/du at the start [rad/s]; 0 where the curvature is finite.
  [[nodiscard]] double start_slope_rate() const {
    return start_.turning / start_rate_;
  }
  /// The place q that the centre reaches after the arc length s ∈ [0, S].
  [[nodiscard]] double place_at_length(double s) const;

  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] double transit_time() const override { return cells_.back().t; }
  [[nodiscard]] double centre_path_length() const override {
    return cells_.back().s;
  }
  [[nodiscard]] double start_angle() const override { return start_.beta; }
  [[nodiscard]] double end_angle() const override {
    return curve_->at(1.0).beta;
  }
  [[nodiscard]] StartLimits at_start() const override;
  [[nodiscard]] TrajectoryPoint at(double q) const override {
    return point_at(sums_at(q));
  }
  [[nodiscard]] std::vector<TrajectoryPoint> at_nodes() const override;
  [[nodiscard]] std::vector<TrajectoryPoint> fine_sample(
      int least) const override;

 private:
  /// Integrals from the start to a place.
  struct Sums {
    double q = 0.0;
    double s = 0.0;  ///< arc length [m]
    double t = 0.0;  ///< time [s]
    double u = 0.0;  ///< rolling time [s]
  };
  [[nodiscard]] std::variant<Sums, Stall> advance(const Sums& from,
                                                  double q) const;
  void integrate(int cells_per_piece);
  [[nodiscard]] Sums sums_at(double q) const;
  [[nodiscard]] double energy(const CurvePlace& place, double s) const;
  [[nodiscard]] TrajectoryPoint point_at(const Sums& sums) const;

  Scene scene_;
  PlaneCurvePtr curve_;
  CurvePlace start_;
  double start_rate_ = 0.0;  ///< du/dq at the start [s]
  std::vector<Sums> cells_{Sums{}};
  std::optional<Stall> stall_;
  double error_ = 0.0;
};

}  // namespace brachisto
