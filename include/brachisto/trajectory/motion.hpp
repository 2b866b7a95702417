// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a body does on its path, in SI units: as functions of the place, as a
/// table, and in numbers; and what is known of it beyond the solver's word.

#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/kinematics.hpp"
#include "brachisto/model/scene.hpp"

namespace brachisto {

/// One row of a trajectory.
struct TrajectoryPoint {
  double sigma = 0.0;  ///< the place, in [0, 1]; see Motion::at()
  double u = 0.0;      ///< rolling time [s]
  double t = 0.0;      ///< time [s]
  double s = 0.0;      ///< arc length of the centre's path [m]
  Point centre;        ///< (x_c, z_c) [m]
  double theta = 0.0;  ///< [rad]
  double beta = 0.0;   ///< continuous slope angle [rad]
  Kinematics motion;   ///< SI units, forces in m g
};

/// Extreme value over u > 0 and where it is taken.
struct Extreme {
  double value = 0.0;
  double x = 0.0;  ///< x_b, of the point of the track [m]
  /// It is the limit at the start, which the path approaches and does not take.
  bool at_start = false;
};

/// The grip that rolling needs from a share of the transit time on.
struct LeastGrip {
  double share_of_time = 0.0;
  /// Least friction coefficient: the supremum of |R_t|/R_n; ∞: none would do,
  /// as where R_n → 0 and R_t does not.
  double mu = 0.0;
};

/// The shares of the transit time that are asked about.
inline constexpr std::array<double, 3> kGripShares{0.0, 0.01, 0.05};

/// What a path does to the body for u > 0; what the start itself tends to
/// stands apart, in `at_start`. On every extremal R_n → 0 there, κ_b → −1/r (a
/// bead's −∞), and the friction needed grows without bound if k > 0. Extremes
/// are minimised between samples.
struct PathDiagnostics {
  StartLimits at_start;
  Extreme min_normal_force, max_normal_force;  ///< of R_n [m g]
  /// The smallest R_n after its first monotone rise from the start [m g].
  Extreme normal_force_after_rise;
  double friction_above_0_3 = 0.0;  ///< share of T with |R_t| > 0.3 R_n
  double friction_above_0_5 = 0.0;
  double friction_above_1 = 0.0;
  /// After each of kGripShares.
  std::array<LeastGrip, kGripShares.size()> least_grip;
  /// Of κ_b [1/m]; ∓∞ if the track folds, where κ_b has a pole.
  Extreme min_curvature, max_curvature;
  /// The smallest κ_b after its first monotone rise from the start [1/m].
  Extreme curvature_after_rise;
  Extreme min_fold_margin;  ///< of 1 − r κ_c
  /// As far as the track does where that is negative [m].
  double folds_back = 0.0;
  double max_abs_slope = 0.0;          ///< of the continuous β [rad]
  std::optional<Point> self_crossing;  ///< of the track [m]
  /// What the mesh leaves open, estimated: of R_n after its first rise [m g],
  /// and of the smallest 1 − r κ_c. 0 where the path is known much better.
  double normal_force_error = 0.0, fold_margin_error = 0.0;
};

/// A motion from A to B.
class Motion {
 public:
  virtual ~Motion() = default;

  [[nodiscard]] virtual const Scene& scene() const = 0;
  [[nodiscard]] virtual double transit_time() const = 0;        ///< T [s]
  [[nodiscard]] virtual double centre_path_length() const = 0;  ///< S [m]
  [[nodiscard]] virtual double start_angle() const = 0;         ///< β₀ [rad]
  [[nodiscard]] virtual double end_angle() const = 0;      ///< β_end [rad]
  [[nodiscard]] virtual StartLimits at_start() const = 0;  ///< as u → 0
  /// At σ ∈ [0, 1], which grows along the path, from rest like the speed.
  [[nodiscard]] virtual TrajectoryPoint at(double sigma) const = 0;
  /// The rows of its table.
  [[nodiscard]] virtual std::vector<TrajectoryPoint> at_nodes() const = 0;
  /// So many places that no feature lies between two of them, and `least` of
  /// them at least; the first one is the start.
  [[nodiscard]] virtual std::vector<TrajectoryPoint> fine_sample(
      int least) const = 0;

  /// The σ of samples at which the curvature is known to jump; ascending,
  /// without the ends.
  [[nodiscard]] virtual std::vector<double> joints() const { return {}; }

  [[nodiscard]] double tau() const;  ///< T √(2g/H)
  /// S + r (β₀ − β_end), the signed ∫(1 − r κ_c) ds [m].
  [[nodiscard]] double rail_length() const;
  /// θ_end − θ_m [rad]; nothing for a bead.
  [[nodiscard]] std::optional<double> rotation() const;
  /// From a fine sample of the path.
  [[nodiscard]] virtual PathDiagnostics diagnose() const;
  /// The greatest angle atan2(|R_t|, R_n) between the force of the track and
  /// its normal from t = share·T on [rad]: rolling needs μ ≥ tan of it; at π/2
  /// or more no μ would do. Unlike |R_t|/R_n it is regular where R_n = 0.
  /// \param share  in [0, 1); at 0 the start counts with its limit
  [[nodiscard]] double friction_angle_after(double share) const;
  /// The least of each figure of the path, found between places of the sample
  /// too; not a number if it is that somewhere behind the start.
  [[nodiscard]] std::vector<double> least_of(
      const std::vector<std::function<double(const TrajectoryPoint&)>>& figures)
      const;

 protected:
  Motion() = default;
  Motion(const Motion&) = default;
  Motion& operator=(const Motion&) = default;
};

/// One statement about a result that was tested.
struct Check {
  std::string name;        ///< as in result files: "kkt_residual"
  double value = 0.0;      ///< what was found
  double threshold = 0.0;  ///< passed iff value ≤ threshold
  std::string where;       ///< where on the path the value was found, or empty
  bool passed = false;
};

/// Outcome of all checks.
struct Certificate {
  std::vector<Check> checks;

  /// True iff there are checks and all of them passed.
  [[nodiscard]] bool verified() const;
  /// The check of that name, or null.
  [[nodiscard]] const Check* find(const std::string& name) const;
  /// Adds a check; NaN never passes.
  void add(std::string name, double value, double threshold,
           std::string where = {});
};

/// One sentence per failed check, with its value and its threshold.
[[nodiscard]] std::vector<std::string> not_verified_because(
    const Certificate& certificate);

/// The answer of the indirect method beside another.
struct CrossCheck {
  bool solved = false;  ///< the indirect method found an extremal
  std::string message;
  double tau = 0.0;
  double error_estimate = 0.0;  ///< relative, of the extremal method
  double difference = 0.0;  ///< relative, |τ − τ_extremal| / τ_extremal
  /// Of a limited track: largest difference of the slopes at A and B [rad], and
  /// of the places where arcs meet, as shares of U.
  std::optional<double> of_slopes = {}, of_junctions = {};
};

}  // namespace brachisto
