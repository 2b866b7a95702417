// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Cubic splines: twice continuously differentiable interpolation, but where its
// slope may jump.

#pragma once

#include <optional>
#include <vector>

namespace brachisto {

/// One coordinate as a function of a parameter. The second derivatives at the
/// ends are those of the cubics through the four points next to them, or the
/// last one follows from the derivative there.
class CubicSpline {
 public:
  /// \param t       ascending; y of the same length, two or more. Where one is
  ///                given twice, with the same y, another spline begins.
  /// \param at_end  dy/dt at the last t, where it is known
  CubicSpline(std::vector<double> t, std::vector<double> y,
              std::optional<double> at_end = {});

  /// Value and derivatives.
  struct Value {
    double f, d1, d2;
  };
  /// By the cubic of a piece, also outside of it.
  [[nodiscard]] Value at(int piece, double t) const;
  /// The piece that t lies in, or the first or last one.
  [[nodiscard]] int piece_of(double t) const;

 private:
  std::vector<double> t_, y_, m_;
};

}  // namespace brachisto
