// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An extremal followed from B back to where the body rests.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "extremal/arc_flow.hpp"

namespace brachisto {

/// How a body arrives at B. An extremal is known by it: the centre ends at B,
/// or where φ places it; there β = φ, the energy gives w, p_θ and p_w are 0,
/// and 𝓗 = ∂𝓗/∂β = 0 leave
///
///     w (p_x cos φ + p_z sin φ) = −√A,
///     w (p_z cos φ − p_x sin φ) = −η cos(θ − φ)/√A.
struct TerminalCondition {
  double theta = 0.0;  ///< orientation [rad]
  double phi = 0.0;    ///< slope angle of the track, and of the path [rad]
};

/// Where the path comes from. Energy is conserved, so that w = 0 on the height
/// of C_A if θ is θ_m; what is left to ask for is x and θ.
struct InitialCondition {
  double x = 0.0;      ///< of the centre, from C_A on
  double theta = 0.0;  ///< [rad]
  double transit_time = 0.0;
};

/// Integrates Hamilton's equations back from B.
class BackwardShooting {
 public:
  /// \param natural  the scene, off-centred, with Contact::Smooth or
  ///                 Contact::Centre, in natural units
  /// \param longest  the path of the centre is given up when it gets longer
  BackwardShooting(const Scene& natural, double longest);

  /// Nothing if the body cannot be at B that way, if its path ends or makes a
  /// loop (|β| > π), or if it does not come to rest.
  ///
  /// \param tolerance  local error of a step, in natural units
  /// \param path       [out] if not null: from the start on, u ascending from 0
  [[nodiscard]] std::optional<InitialCondition> shoot(
      const TerminalCondition& terminal, double tolerance,
      std::vector<arcs::Knot>* path) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// Steps of the integrator in all.
  [[nodiscard]] long steps() const { return steps_; }

 private:
  using Flow = ocp::Flow<rolling::SteeredFalling>;

  Scene scene_;
  double longest_;
  Point start_;  ///< C_A
  Flow flow_;
  mutable long steps_ = 0;
};

}  // namespace brachisto
