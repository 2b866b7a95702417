// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Jacobian of the equations that do not contain the transit time.

#pragma once

#include "brachisto/paper/discrete_variations.hpp"
#include "paper/chord_time.hpp"
#include "paper/layout.hpp"

namespace brachisto::paper {

/// Radius on which the centre turns about the ends of the track.
[[nodiscard]] inline double contact_radius(const Scene& scene) {
  return scene.contact == Contact::Smooth ? scene.body.radius : 0.0;
}

/// Calls put(row, column, value) for every entry of eqs. (13)–(15), (17) and
/// (19), always the same ones in the same order; values of one place add up.
template <class Put>
void for_conditions(const DiscreteVariations& system,
                    std::span<const double> unknowns, Put&& put) {
  const int n = system.num_nodes();
  const Unknowns u{n, unknowns};
  const Rows row{n};
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
