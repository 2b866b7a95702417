// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An extremal without limits as a function of the rolling time.

#pragma once

#include "extremal/arc_path.hpp"
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

/// A path of one free arc, in SI units.
class ExtremalPath {
 public:
  ExtremalPath() = default;
  /// \param natural  the scene in its natural units, as is the path
  ExtremalPath(const Scene& natural, const Units& units, arcs::ArcPath path);

  [[nodiscard]] bool empty() const { return path_.empty(); }
  /// The extremal at u = σ U, σ in [0, 1] (clamped); costs one step of the
  /// integration. \pre !empty()
  [[nodiscard]] ExtremalState at(double sigma) const;
  /// Looks at every step.
  [[nodiscard]] Regularity regularity() const;

 private:
  bool rolls_ = false;
  Units units_;
  arcs::ArcPath path_;
};

/// In SI units what stands at a place of a free arc in natural ones.
[[nodiscard]] ExtremalState in_si(const arcs::Knot& knot, const Units& units,
                                  bool rolls);

}  // namespace brachisto
