// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The discrete problem written down a second time, for any kind of number.

#pragma once

#include <cmath>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"
#include "derivatives/problems.hpp"

namespace brachisto::testing {

/// f and g as functions of the unknowns.
template <class Scalar>
struct Functions {
  Scalar f;
  std::vector<Scalar> g;
};

/// Value and slope at t of the Lagrange polynomials through `nodes`: products
/// and sums as in the textbook.
struct Lagrange {
  std::vector<double> value, slope;

  Lagrange(const std::vector<double>& nodes, double t)
      : value(nodes.size(), 1.0), slope(nodes.size(), 0.0) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i == j) continue;
        const double gap = nodes[j] - nodes[i];
        slope[j] = slope[j] * (t - nodes[i]) / gap + value[j] / gap;
        value[j] *= (t - nodes[i]) / gap;
      }
    }
  }
};

/// Reads the unknowns in their documented order, x_0 z_0 [θ_0] w_0 β_0 x_1 …,
/// and writes the equations of motion in theirs, x z [θ] w per point, with the
/// inertia factor as the paper has it.
template <class Scalar>
[[nodiscard]] Functions<Scalar> literal_functions(
    const ProblemCase& row, const std::vector<Scalar>& unknowns) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Body& body = row.scene.body;
  const bool has_theta = body.eta_m != 0.0;
  const std::size_t num_states = has_theta ? 4 : 3;
  const auto p = static_cast<std::size_t>(row.mesh.degree);
  const double eta = body.eta_m;
  const double g = row.scene.gravity;
  const auto nodes = math::gauss_lobatto_points(row.mesh.degree + 1);
  const auto rule = math::gauss_legendre(row.mesh.degree);
  const Scalar& U = unknowns.back();

  Functions<Scalar> out{Scalar(0.0), {}};
  for (int e = 0; e < row.mesh.num_elements(); ++e) {
    const double h = row.mesh.length(e);
    for (std::size_t j = 0; j < p; ++j) {
      const Lagrange basis(nodes, rule.points[j]);
      const std::size_t first = static_cast<std::size_t>(e) * p;
      std::vector<Scalar> value(num_states), slope(num_states);
      for (std::size_t n = 0; n <= p; ++n) {
        for (std::size_t s = 0; s < num_states; ++s) {
          const Scalar& x = unknowns[(first + n) * (num_states + 1) + s];
          value[s] += basis.value[n] * x;
          slope[s] += basis.slope[n] * x;
        }
      }
      const Scalar& beta =
          unknowns[(first + j) * (num_states + 1) + num_states];
      const Scalar& w = value.back();
      const Scalar hU = h * U;
      out.g.push_back(slope[0] - hU * w * cos(beta));
      out.g.push_back(slope[1] - hU * w * sin(beta));
      Scalar A(1.0 + eta * eta + body.k);
      // The pull of the field at the centre of mass, along its motion.
      Scalar along_x = cos(beta), along_z = sin(beta);
      Scalar x_cm = value[0], z_cm = value[1];
      if (has_theta) {
        const Scalar& theta = value[2];
        out.g.push_back(slope[2] - hU * w * (1.0 / body.radius));
        A -= 2.0 * eta * sin(theta - beta);
        along_x -= eta * sin(theta);
        along_z += eta * cos(theta);
        x_cm += body.radius * eta * cos(theta);
        z_cm += body.radius * eta * sin(theta);
      }
      Scalar gain = g * along_z;
      if (const auto& sphere = row.scene.world.sphere) {
        const Scalar dx = x_cm - sphere->centre.x;
        const Scalar dz = z_cm - sphere->centre.z;
        const Scalar d = sqrt(dx * dx + dz * dz);
        const bool inside = d.value < sphere->radius;
        const double R = sphere->radius;
        const Scalar ratio = inside ? Scalar(1.0 / R) : R * R / (d * d * d);
        gain = -sphere->surface_gravity * ratio * (along_x * dx + along_z * dz);
      }
      const Air& air = row.scene.world.air;
      const Scalar v = w / sqrt(A);
      gain -= air.linear * v + air.quadratic * v * v;
      out.g.push_back(slope.back() - hU * gain);
      out.f += hU * rule.weights[j] * sqrt(A);
    }
  }
  return out;
}

}  // namespace brachisto::testing
