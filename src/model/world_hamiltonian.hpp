// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pontryagin's Hamiltonian in any world. In an ordinary one the functions are
/// those of model/hamiltonian.hpp.

#pragma once

#include <array>

#include "brachisto/math/jet.hpp"
#include "model/field.hpp"
#include "model/hamiltonian.hpp"

namespace brachisto {

/// State of the motion at one u, on all of which rates may depend.
struct MovingState {
  Point centre;
  double theta = 0.0;  ///< [rad]
  double w = 0.0;      ///< of the kinetic energy ½ w² per mass
};

/// States, costates and slope, in the order of a jet's variables.
template <class Scalar>
struct PhasePoint {
  Scalar x, z, theta, w, p_x, p_z, p_theta, p_w, beta;
};

/// 𝓗 = √A + w (p_x cos β + p_z sin β + p_θ/r) + p_w w', w' = speed_gain().
///
/// \param inverse_radius  1/r; 0 for a body that does not roll
template <class Scalar>
[[nodiscard]] Scalar hamiltonian_of(const Scene& scene, double inverse_radius,
                                    const PhasePoint<Scalar>& at) {
  using std::cos;
  using std::sin;
  const Scalar root = root_of_inertia(scene, at.theta, at.beta);
  const Scalar gain =
      speed_gain(scene, at.x, at.z, at.theta, at.w, at.beta, root);
  return root +
         at.w * (at.p_x * cos(at.beta) + at.p_z * sin(at.beta) +
                 at.p_theta * inverse_radius) +
         at.p_w * gain;
}

/// 𝓗 with its first and second derivatives by all of PhasePoint.
using PhaseJet = math::Jet2<double, 9>;
inline constexpr std::size_t kPhaseBeta = 8;  ///< the place of β
[[nodiscard]] PhaseJet hamiltonian_jet(const Scene& scene,
                                       double inverse_radius,
                                       const PhasePoint<double>& at);

// Of the same names and meanings as in model/hamiltonian.hpp; but where the
// world changes rates, the value of slope_hamiltonian() is all of 𝓗.

[[nodiscard]] SlopeHamiltonian slope_hamiltonian(const Scene& scene,
                                                 const MovingState& state,
                                                 const Costates& p,
                                                 double beta);
[[nodiscard]] double hamiltonian(const Scene& scene, const MovingState& state,
                                 const Costates& p, double beta);
[[nodiscard]] double gain_of_other_directions(const Scene& scene,
                                              const MovingState& state,
                                              const Costates& p, double beta);
[[nodiscard]] double slope_rate(const Scene& scene, const MovingState& state,
                                const Costates& p, double beta);
[[nodiscard]] double minimising_slope(const Scene& scene,
                                      const MovingState& state,
                                      const Costates& p, double near);

/// dβ/du along a path with other rates than the extremal's: of x, z, θ, w and
/// the costates, in this order.
[[nodiscard]] double slope_rate_along(const Scene& scene,
                                      const MovingState& state,
                                      const Costates& p, double beta,
                                      const std::array<double, 8>& rates);

}  // namespace brachisto
