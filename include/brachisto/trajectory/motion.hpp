// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a body does on its path, in SI units: as functions of the place, as a
/// table, and in numbers.

#pragma once

#include <optional>
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

/// Extreme value and where it is taken.
struct Extreme {
  double value = 0.0;
  double x = 0.0;  ///< x_b, of the point of the track [m]
};

/// What a path does to the body. At the start itself R_n = 0, the friction
/// needed is infinite if k > 0, and the track's curvature tends to −1/r. These
/// limits say nothing about the path, so R_n and κ_b count from the end of
/// their first monotone rise; what remains are true extrema, found by
/// minimisation between samples.
struct PathDiagnostics {
  Extreme min_normal_force, max_normal_force;  ///< of R_n [m g]
  double friction_above_0_3 = 0.0;  ///< share of T with |R_t| > 0.3 R_n
  double friction_above_0_5 = 0.0;
  double friction_above_1 = 0.0;
  Extreme min_curvature, max_curvature;  ///< of κ_b [1/m]
  Extreme min_fold_margin;               ///< of 1 − r κ_c
  double max_abs_slope = 0.0;            ///< of the continuous β [rad]
  std::optional<Point> self_crossing;    ///< of the track [m]
};

/// A motion from A to B.
class Motion {
 public:
  virtual ~Motion() = default;

  [[nodiscard]] virtual const Scene& scene() const = 0;
  [[nodiscard]] virtual double transit_time() const = 0;        ///< T [s]
  [[nodiscard]] virtual double centre_path_length() const = 0;  ///< S [m]
  [[nodiscard]] virtual double start_angle() const = 0;         ///< β₀ [rad]
  [[nodiscard]] virtual double end_angle() const = 0;  ///< β_end [rad]
  /// At σ ∈ [0, 1], which grows along the path, from rest like the speed.
  [[nodiscard]] virtual TrajectoryPoint at(double sigma) const = 0;
  /// The rows of its table.
  [[nodiscard]] virtual std::vector<TrajectoryPoint> at_nodes() const = 0;
  /// So many places that no feature lies between two of them, and `least` of
  /// them at least; the first one is the start.
  [[nodiscard]] virtual std::vector<TrajectoryPoint> fine_sample(
      int least) const = 0;

  [[nodiscard]] double tau() const;  ///< T √(2g/H)
  /// S + r (β₀ − β_end), the signed ∫(1 − r κ_c) ds [m].
  [[nodiscard]] double rail_length() const;
  /// θ_end − θ_m [rad]; nothing for a bead.
  [[nodiscard]] std::optional<double> rotation() const;
  /// From a fine sample of the path.
  [[nodiscard]] PathDiagnostics diagnose() const;

 protected:
  Motion() = default;
  Motion(const Motion&) = default;
  Motion& operator=(const Motion&) = default;
};

}  // namespace brachisto
