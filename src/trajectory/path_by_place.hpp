// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path of an extremal as the re-integration sees it.

#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "math/gauss.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// A direction along a path.
struct Direction {
  double beta, cosine, sine;
};

[[nodiscard]] inline Direction direction_of(double beta) {
  return {beta, std::cos(beta), std::sin(beta)};
}

/// The centre's path by the places t of its elements: its slope angle and, by
/// the length of what is passed, its arc length. Slopes have kinks where
/// elements meet.
///
/// In an element s is the integral of h U w, of degree p + 1, and dβ/dt is the
/// exact derivative of β, so that both belong to one and the same path on
/// coarse meshes too: κ_c = (dβ/dt)/(ds/dt).
class PathByPlace {
 public:
  struct Place {
    Direction along;  ///< NaN where the curve has none
    double turning;   ///< dβ/dt
    double pace;      ///< ds/dt
  };

  /// \param curve  must outlive this
  explicit PathByPlace(const ExtremalCurve& curve);

  [[nodiscard]] int num_elements() const {
    return curve_.mesh().num_elements();
  }
  /// S, and s where the first element ends.
  [[nodiscard]] double length() const { return curve_.arc_length(); }
  [[nodiscard]] double first_length() const { return first_length_; }
  /// h_e, as a share of U.
  [[nodiscard]] double share(int e) const { return curve_.mesh().length(e); }
  /// The scene as element e sees it.
  [[nodiscard]] const Scene& scene_in(int e) const {
    return curve_.scene_in(e);
  }
  /// In element e; beyond its ends the path goes on with its polynomials.
  /// \pre s > 0 there
  [[nodiscard]] Place at(int e, double t);
  /// The place of the first element at s.
  [[nodiscard]] double in_first(double s) const;

 private:
  /// Of a step of the integrator. Steps that are as long as an element ask for
  /// the same places in all of them.
  static constexpr std::size_t kStages = 13;

  /// w at t and ∫₀ᵗ w, in the first element.
  struct Speed {
    double w, integral;
  };
  [[nodiscard]] Speed speed_in_first(double t) const;
  [[nodiscard]] const ElementPlace& basis(double t);

  const ExtremalCurve& curve_;
  const bool in_world_;
  const CollocationScheme& scheme_;
  math::QuadratureRule rule_;    ///< exact for w
  std::vector<double> first_w_;  ///< at the nodes of the first element
  double first_length_;
  std::vector<ElementPlace> bases_;
  std::size_t stage_ = 0;
};

}  // namespace brachisto
