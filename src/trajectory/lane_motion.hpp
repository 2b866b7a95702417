// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion of a scene that was solved side by side with others, and its
/// certificate.

#pragma once

#include <memory>
#include <vector>

#include "lanes/many_scenes.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto {

/// An extremal by its places at equal steps of u, and between them by the
/// polynomials of degree 7 that have values and rates of four places.
class LaneMotion final : public MeshMotion {
 public:
  /// \param natural   the scene of the extremal, in natural units
  /// \param extremal  found
  /// \param scene     see MeshMotion
  LaneMotion(const Scene& natural, const lanes::Extremal& extremal,
             const Scene& scene, const Units& units);

  [[nodiscard]] double start_angle() const override;
  [[nodiscard]] double end_angle() const override { return extremal_->phi; }

  using MeshMotion::natural;
  [[nodiscard]] const std::shared_ptr<const lanes::Extremal>& extremal() const {
    return extremal_;
  }

 private:
  friend Certificate certify(const LaneMotion& motion);

  [[nodiscard]] Place place(int element, double t) const override;

  /// Energy that the air takes from the beginning of a step to its place t, per
  /// mass.
  [[nodiscard]] double lost_within(int step, double t) const;

  /// How an extremal changes at one of its places, over a step.
  struct Change {
    double x, z, theta, w;
  };

  std::shared_ptr<const lanes::Extremal> extremal_;
  double turn_;                  ///< dθ/ds
  double step_;                  ///< of u
  std::vector<Change> changes_;  ///< one of each place
};

/// Tests an extremal found side by side with others.
///
/// Optimality:
///   shooting         largest residual of the shooting
///   hamiltonian      max |𝓗| / √A
///   second_order     conjugate points: places where the Jacobi determinant
///                    changes its sign, or an end whose free length makes no
///                    minimum
///   legendre         −min ∂²𝓗/∂β²; below zero on a minimum
///   turning_costate  of a field about a centre what turning it keeps of the
///                    costates
///   weierstrass      max (𝓗(β) − 𝓗(b)) / √A over all directions b
/// Integrity:
///   contact_error    distance of the track's ends from A and B
///   energy_drift     max |w²/2g − E|, E less what the air takes
///   surface          how far the centre of mass goes beyond where the field
///                    has a kink
///   reintegration_error  T, place and θ at the end by Gauss's rule along the
///                    slopes, with the speed from the energy
///   slope_angle      continuous slope angle within [−π, π]: no loop
///   speed            share of the places after the start without w > 0
[[nodiscard]] Certificate certify(const LaneMotion& motion);

}  // namespace brachisto
