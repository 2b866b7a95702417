// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An extremal as a function of the rolling time.

#pragma once

#include <array>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "model/units.hpp"

namespace brachisto {

/// States, costates and slope at one u, in SI units. The costates are minus
/// the gradient of the least time: 𝓗 = √A + p·f = 0 is minimal in β.
struct ExtremalState {
  double x = 0.0;        ///< centre [m]
  double z = 0.0;        ///< centre, down [m]
  double theta = 0.0;    ///< θ [rad]; 0 for a bead
  double w = 0.0;        ///< √(2 g E) [m/s]
  double p_theta = 0.0;  ///< [s]
  double p_w = 0.0;      ///< [s²/m]
  double beta = 0.0;     ///< slope angle, continuous along the path [rad]
  double t = 0.0;        ///< time since the start [s]
  double p_x = 0.0;      ///< [s/m]
  double p_z = 0.0;      ///< [s/m]
};

/// What a path has to satisfy besides stationarity to be an answer.
struct Regularity {
  /// Legendre: min of ∂²𝓗/∂β² over the path [-]; must be > 0.
  double min_legendre = 0.0;
  double min_w = 0.0;     ///< of w after the start, as a share of w_max
  double min_beta = 0.0;  ///< of the continuous slope angle [rad]
  double max_beta = 0.0;  ///< [rad]

  [[nodiscard]] bool legendre_holds() const { return min_legendre > 0.0; }
  [[nodiscard]] bool keeps_moving() const { return min_w > 0.0; }
  [[nodiscard]] bool free_of_loops() const;
};

/// An extremal through the steps of its integration; between them it is
/// integrated anew, so that every point has the accuracy of the integration.
class ExtremalPath {
 public:
  /// One accepted step: u [natural units] and what the integration had there.
  struct Knot {
    double u = 0.0;
    std::array<double, 6> y{};  ///< x, z, θ, w, p_θ, p_w in natural units
    double t = 0.0;
    double beta = 0.0;
    double p_x = 0.0, p_z = 0.0;  ///< in other worlds; else constant
  };

  ExtremalPath() = default;
  /// \param natural  the scene in its natural units
  /// \param knots    ascending in u from 0 to U
  ExtremalPath(const Scene& natural, const Units& units, double p_x, double p_z,
               std::vector<Knot> knots);

  [[nodiscard]] bool empty() const { return knots_.empty(); }
  /// The extremal at u = σ U, σ in [0, 1] (clamped); costs one step of the
  /// integration, allocates nothing. \pre !empty()
  [[nodiscard]] ExtremalState at(double sigma) const;
  /// Looks at every step.
  [[nodiscard]] Regularity regularity() const;

 private:
  [[nodiscard]] ExtremalState in_si(const Knot& knot) const;
  /// One step of length `span` from a knot towards the next, in another world.
  [[nodiscard]] Knot in_world(const Knot& knot, const Knot& next,
                              double span) const;

  Scene natural_;
  Units units_;
  double p_x_ = 0.0, p_z_ = 0.0;
  std::vector<Knot> knots_;
};

}  // namespace brachisto
