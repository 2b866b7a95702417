// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A body on a given path, in any world.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "model/plane_curve.hpp"

/// The Gauss rule by whose points motions on given paths advance.
namespace brachisto::gauss_step {

inline constexpr int kPoints = 12;

/// On [0, 1].
[[nodiscard]] inline const math::QuadratureRule& rule() {
  static const math::QuadratureRule gauss = math::gauss_legendre(kPoints);
  return gauss;
}

/// Row i integrates a polynomial given at the points, from 0 to point i.
[[nodiscard]] inline const math::SmallMatrix& integration_to_points() {
  static const math::SmallMatrix matrix =
      math::LagrangeBasis(rule().points).integrals_to(rule().points, rule());
  return matrix;
}

}  // namespace brachisto::gauss_step

namespace brachisto {

/// Why a body does not get to the end of a given path.
struct Stall {
  enum class Reason {
    DoesNotStart,  ///< at rest it is not drawn along the path
    Stops,         ///< its energy is used up on the way, by what brakes too
    DoesNotFit,    ///< a valley of the track is narrower than the body
    NotFollowed,   ///< it is braked within no time
  };
  Reason reason = Reason::Stops;
  double q = 0.0;  ///< where
  Point centre;    ///< where [m]

  [[nodiscard]] std::string message() const;
};

/// The motion along a given path of the centre:
///
///     ½ w² = ½ v₀² A + the fall of the potential at the centre of mass,
///     dt = √A ds / w,  θ = θ_m + s / r,
///
/// integrated over the curve's own parameter q by Gauss rules on cells that are
/// halved until T does not change; they end where the centre of mass passes the
/// surface of a sphere. In air and with losses ½ w² is the solution of
///
///     d(½ w²)/dq = w' ds/dq,  w' = speed_gain(),
///
/// by collocation at the same points, which from rest is smooth in q as w is,
/// and which no stiffness makes unstable; cells are divided before where a step
/// and its halves differ.
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

  /// The cell in which a place lies, from 0.
  [[nodiscard]] int cell_of(double q) const;
  /// Where a cell begins; after the last one, 1.
  [[nodiscard]] double start_of_cell(int cell) const {
    return cells_[static_cast<std::size_t>(cell)].q;
  }

  /// A step from the start of a cell by a Gauss rule, and its points.
  struct Step {
    double width = 0.0;  ///< of q
    double t = 0.0;      ///< time at its end [s]
    std::array<CurvePlace, gauss_step::kPoints> places;
    std::array<double, gauss_step::kPoints> s;  ///< arc lengths [m]
    std::array<double, gauss_step::kPoints> v;  ///< v_c [m/s]
  };
  /// \param q  within the cell, behind its start
  [[nodiscard]] Step step_to(int cell, double q) const;

  [[nodiscard]] const PlaneCurve& curve() const { return *curve_; }
  /// dβ/du at the start [rad/s]; from rest 0 where the curvature is finite.
  [[nodiscard]] double start_slope_rate() const {
    return start_energy_ > 0.0 ? start_curvature() * start_w()
                               : start_.turning / start_rate_;
  }
  /// κ_c there [1/m], or what is next to its infinity.
  [[nodiscard]] double start_curvature() const;
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
    double s = 0.0;       ///< arc length [m]
    double t = 0.0;       ///< time [s]
    double u = 0.0;       ///< rolling time [s]
    double energy = 0.0;  ///< ½ w² [m²/s²], where something brakes
  };
  /// The points of a Gauss rule between two places.
  struct Points {
    std::array<CurvePlace, gauss_step::kPoints> places;
    std::array<double, gauss_step::kPoints> s;       ///< arc lengths [m]
    std::array<double, gauss_step::kPoints> energy;  ///< ½ w² [m²/s²]
  };
  [[nodiscard]] std::variant<Sums, Stall> advance(const Sums& from, double q,
                                                  Points& points) const;
  [[nodiscard]] std::variant<Sums, Stall> advance(const Sums& from,
                                                  double q) const;
  [[nodiscard]] double brake(const Sums& from, double width,
                             Points& points) const;
  /// θ − θ_m once the centre has come the length s, and θ.
  [[nodiscard]] double turned_after(double s) const;
  [[nodiscard]] double theta_after(double s) const {
    return scene_.body.theta_m + turned_after(s);
  }
  /// Of the curve between two places [m].
  [[nodiscard]] double length_between(double from, double to) const;
  void end_pieces();
  void divide(Sums& from, double to, std::vector<double>& ends);
  void integrate(int cells_per_piece);
  [[nodiscard]] Sums sums_at(double q) const;
  /// Without what brakes.
  [[nodiscard]] double energy(const CurvePlace& place, double s) const;
  /// w' of a body that stands there [m/s²].
  [[nodiscard]] double gain_at_rest(const CurvePlace& place, double s) const;
  [[nodiscard]] double start_w() const;
  [[nodiscard]] TrajectoryPoint point_at(const Sums& sums) const;

  Scene scene_;
  PlaneCurvePtr curve_;
  CurvePlace start_;
  double start_rate_ = 0.0;     ///< du/dq at the start from rest [s]
  double memory_ = 0.0;         ///< q where it falls as fast as it was pushed
  double start_energy_ = 0.0;   ///< ½ w² there [m²/s²]
  double start_kinetic_ = 0.0;  ///< the same without losses
  std::vector<double> ends_;    ///< of pieces on which the motion is smooth
  std::vector<Sums> cells_{Sums{}};
  std::optional<Stall> stall_;
  double error_ = 0.0;
};

}  // namespace brachisto
