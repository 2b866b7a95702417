// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The rolling body: a bead that slides, or a cylinder that rolls without slip
/// and whose centre of mass may lie off its axis.

#pragma once

#include <optional>

namespace brachisto {

/// Shape of the body. A bead is a point mass that slides without friction.
enum class Shape { Bead, Cylinder };

/// Mass distribution of the body, section "Governing Equations" of the paper.
///
/// A bead has radius, offset and inertia zero, which turns every formula for a
/// cylinder into the formula for the bead.
struct Body {
  Shape shape = Shape::Cylinder;
  double radius = 0.0;   ///< r [m]
  double eta_m = 0.0;    ///< η_m = r_m / r, offset of the centre of mass [-]
  double theta_m = 0.0;  ///< θ_m, its angle at the start, from +x towards +z
                         ///< (downwards) [rad]
  double k = 0.0;        ///< I_cm / (m r²) [-]
  std::optional<double> mass;  ///< m [kg]; only turns forces into newtons

  [[nodiscard]] static Body bead() {
    return {Shape::Bead, 0.0, 0.0, 0.0, 0.0, std::nullopt};
  }
  [[nodiscard]] static Body cylinder(double radius, double eta_m,
                                     double theta_m, double k) {
    return {Shape::Cylinder, radius, eta_m, theta_m, k, std::nullopt};
  }

  /// True if the body turns as it moves, so that θ has a meaning.
  [[nodiscard]] bool rolls() const { return shape == Shape::Cylinder; }
  /// True if the motion depends on θ; otherwise A is constant and θ drops out.
  [[nodiscard]] bool off_centred() const { return rolls() && eta_m != 0.0; }
};

}  // namespace brachisto
