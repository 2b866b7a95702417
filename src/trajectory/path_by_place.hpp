// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path of an extremal as the re-integration sees it.

#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

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
/// In an element s is the integral of h U w, of degree p + 1: to the polynomial
/// through its values at the nodes belongs a multiple of Π (t − t_n). dβ/dt is
/// the exact derivative of β, so that both belong to one and the same path on
/// coarse meshes too: κ_c = (dβ/dt)/(ds/dt).
class PathByPlace {
 public:
  struct Place {
    double s;
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

  /// The bases at a place.
  struct Basis {
    ElementPlace place;
    double
        beyond;  ///< Π (t − t_n), what a polynomial of degree p cannot follow

    Basis(const CollocationScheme& scheme, double t)
        : place(scheme, t), beyond(scheme.nodes.node_polynomial(t)) {}
  };
  /// The coefficient of t^(p+1) of s.
  [[nodiscard]] double leading_s(int e) const {
    return pace(e, curve_.leading_w(e)) / (scheme_.degree + 1);
  }
  [[nodiscard]] double pace(int e, double w) const {
    return curve_.rolling_time() * curve_.mesh().length(e) * w;
  }

  const ExtremalCurve& curve_;
  const bool in_world_;
  const CollocationScheme& scheme_;
  const double first_length_;
  std::vector<Basis> stages_;  ///< of the last step
  std::size_t stage_ = 0;
  int element_ = 0;   ///< the last one that was asked for,
  double leading_s_;  ///< and its coefficient
};

}  // namespace brachisto
