// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Trajectories in closed form.

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <string>

#include "brachisto/model/scene.hpp"
#include "plot/trajectory_table.hpp"

namespace brachisto::testing {

inline constexpr const char* kTableHead =
    "u,t,x_c,z_c,x_cm,z_cm,x_b,z_b,theta,beta,v_c,omega,R_n,R_t,kappa_b\n";

/// A body with its centre of mass on its axis down a straight incline:
/// s = a t²/2, θ = s/r; all that is not given is constant.
struct Incline {
  double slope = 0.5, acceleration = 3.0, radius = 0.25, time = 1.5;
  /// R_n of a row; of the real motion it is constant.
  std::function<double(int)> normal = [](int) { return 0.875; };

  [[nodiscard]] Scene scene() const {
    Scene scene;
    scene.body = Body::cylinder(radius, 0.0, 0.0, 0.5);
    const double s = 0.5 * acceleration * time * time;
    scene.L = s * std::cos(slope);
    scene.H = s * std::sin(slope);
    return scene;
  }
  /// Rows at equal times.
  [[nodiscard]] std::string csv(int rows) const {
    std::string out = kTableHead;
    const double c = std::cos(slope), n = std::sin(slope), r = radius;
    for (int i = 0; i < rows; ++i) {
      const double t = time * i / (rows - 1);
      const double v = acceleration * t, s = 0.5 * v * t;
      const double x = r * n + s * c, z = -r * c + s * n;
      fmt::format_to(std::back_inserter(out),
                     "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},"
                     "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},0.25,"
                     "0\n",
                     t, t, x, z, x, z, s * c, s * n, s / r, slope, v, v / r,
                     normal(i));
    }
    return out;
  }
};

}  // namespace brachisto::testing
