// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where unknowns and equations of the discrete system stand. Nodes count from
/// 0 here; chord i leads from node i to node i + 1. With them the conditions
/// at the ends and along the chords.

#pragma once

#include <cmath>
#include <span>

#include "brachisto/math/index.hpp"
#include "brachisto/run/solve_options.hpp"
#include "model/contact.hpp"
#include "paper/chord_time.hpp"
#include "paper/discrete_variations.hpp"

namespace brachisto::paper {

/// Columns: unknowns of DiscreteVariations.
struct Columns {
  int n;
  [[nodiscard]] int x(int node) const { return node; }
  [[nodiscard]] int z(int node) const { return n + node; }
  [[nodiscard]] int S() const { return 2 * n; }
};

/// Rows: equations of DiscreteVariations.
struct EquationRows {
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

/// Calls put(row, column, value) for every entry of eqs. (13)–(15), (17) and
/// (19), always the same ones in the same order; values of one place add up.
template <class Put>
void for_conditions(const DiscreteVariations& system,
                    std::span<const double> unknowns, Put&& put) {
  const int n = system.num_nodes();
  const Unknowns u{n, unknowns};
  const EquationRows row{n};
  const Columns column{n};
  const double r = contact_radius(system.scene());
  const auto end = [&](int chord, int node, int x_row, int z_row) {
    const EndSlope slope(system.reading().slopes, u.dx(chord), u.dz(chord));
    put(x_row, column.x(node), 1.0);
    put(z_row, column.z(node), 1.0);
    for (const int side : {0, 1}) {
      const double sign = side == 0 ? -1.0 : 1.0;
      const int x = column.x(chord + side);
      const int z = column.z(chord + side);
      put(x_row, x, -sign * r * slope.dsine_dx);
      put(x_row, z, -sign * r * slope.dsine_dz);
      put(z_row, x, sign * r * slope.dcosine_dx);
      put(z_row, z, sign * r * slope.dcosine_dz);
    }
  };
  end(0, 0, row.start_x(), row.start_z());
  end(n - 2, n - 1, row.end_x(), row.end_z());
  for (int i = 0; i + 1 < n; ++i) {
    const double l = chord_length(u.dx(i), u.dz(i));
    const double c = u.dx(i) / l;
    const double s = u.dz(i) / l;
    put(row.chord(i), column.x(i), -c);
    put(row.chord(i), column.x(i + 1), c);
    put(row.chord(i), column.z(i), -s);
    put(row.chord(i), column.z(i + 1), s);
    put(row.chord(i), column.S(), -1.0 / (n - 1));
  }
}

}  // namespace brachisto::paper
