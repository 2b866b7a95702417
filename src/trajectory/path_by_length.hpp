// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The found path as pure geometry.

#pragma once

#include <vector>

#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// Slope angle and curvature of the centre's path as functions of its arc
/// length s, element by element: slopes have kinks where elements meet.
///
/// In an element s is the integral of U w, of degree p + 1, and κ_c is the
/// exact derivative of β along it, so that both belong to one and the same path
/// on coarse meshes too.
class PathByLength {
 public:
  struct Place {
    double beta = 0.0;   ///< NaN where the curve has none
    double kappa = 0.0;  ///< κ_c
  };

  /// \param curve  must outlive this
  explicit PathByLength(const ExtremalCurve& curve);

  [[nodiscard]] int num_elements() const {
    return static_cast<int>(ends_.size()) - 1;
  }
  /// s where element e begins, or where element e − 1 ends.
  [[nodiscard]] double end(int e) const {
    return ends_[static_cast<std::size_t>(e)];
  }
  /// In element e; beyond its ends the path goes on with its polynomials.
  /// \pre s > 0
  [[nodiscard]] Place at(int e, double s) const;

 private:
  [[nodiscard]] double combine(int e, const std::vector<double>& values,
                               const std::vector<double>& nodal) const;
  /// w at t and ∫₀ᵗ w, of element e.
  struct Speed {
    double w, integral;
  };
  [[nodiscard]] Speed speed(int e, double t) const;

  const ExtremalCurve& curve_;
  const CollocationScheme& scheme_;
  math::QuadratureRule rule_;  ///< exact for w
  std::vector<double> ends_;
  std::vector<double> theta_, w_, p_w_;  ///< at nodes
};

}  // namespace brachisto
