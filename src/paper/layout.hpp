// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where unknowns and equations of the discrete system stand. Nodes count from
/// 0 here; chord i leads from node i to node i + 1.

#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "brachisto/paper/discrete_reading.hpp"

namespace brachisto::paper {

[[nodiscard]] inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Columns: unknowns of DiscreteVariations.
struct Columns {
  int n;
  [[nodiscard]] int x(int node) const { return node; }
  [[nodiscard]] int z(int node) const { return n + node; }
  [[nodiscard]] int S() const { return 2 * n; }
};

/// Rows: equations of DiscreteVariations.
struct Rows {
  int n;
  [[nodiscard]] int start_x() const { return 0; }                   // (13)
  [[nodiscard]] int chord(int i) const { return i + 1; }            // (14)
  [[nodiscard]] int start_z() const { return n; }                   // (17)
  [[nodiscard]] int variation(int node) const { return n + node; }  // (18)
  [[nodiscard]] int end_z() const { return 2 * n - 1; }             // (19)
  [[nodiscard]] int end_x() const { return 2 * n; }                 // (15)
};

/// The unknowns by name.
struct Unknowns {
  int n;
  std::span<const double> values;
  [[nodiscard]] double x(int node) const { return values[at(node)]; }
  [[nodiscard]] double z(int node) const { return values[at(n + node)]; }
  [[nodiscard]] double S() const { return values[at(2 * n)]; }
  [[nodiscard]] double dx(int chord) const { return x(chord + 1) - x(chord); }
  [[nodiscard]] double dz(int chord) const { return z(chord + 1) - z(chord); }
};

/// Sine and cosine of the slope of a chord as the end conditions have them,
/// and their derivatives.
struct EndSlope {
  double sine, cosine;
  double dsine_dx, dsine_dz, dcosine_dx, dcosine_dz;

  EndSlope(DiscreteReading::Slopes slopes, double dx, double dz) {
    const double l = std::hypot(dx, dz);
    const bool backwards = std::signbit(dx);
    const double sign =
        slopes == DiscreteReading::Slopes::Literal && backwards ? -1.0 : 1.0;
    const double s = dz / l;
    const double c = dx / l;
    sine = sign * s;
    cosine = sign * c;
    dsine_dx = -sign * c * s / l;
    dsine_dz = sign * c * c / l;
    dcosine_dx = sign * s * s / l;
    dcosine_dz = -sign * c * s / l;
  }
};

}  // namespace brachisto::paper
