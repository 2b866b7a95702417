// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Costates of a solved problem, read from its multipliers.

#pragma once

#include <span>
#include <vector>

#include "model/hamiltonian.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// Costates along a solution of a rolling_time problem.
///
/// The defect rows are D X − h U f, so the Lagrangian holds h U f_j with the
/// coefficient −λ_j, and 𝓗 = √A + p·f weighed by b_j: p = −λ_j/b_j at
/// collocation point j. Gauss collocation is its own adjoint: these are the
/// values of polynomials of degree p that satisfy the costate equations at the
/// same points, start from p_θ = p_w = 0 at the end, and are right to order 2p
/// at element ends.
///
/// p_x and p_z are constant along the path, unless the field depends on the
/// place.
struct CostateSolution {
  double p_x = 0.0;                    ///< at the end
  double p_z = 0.0;                    ///< at the end
  std::vector<double> p_theta_points;  ///< N p values; empty without θ
  std::vector<double> p_w_points;      ///< N p values
  std::vector<double> p_theta_nodes;   ///< N p + 1 values; empty without θ
  std::vector<double> p_w_nodes;       ///< N p + 1 values
  std::vector<double> p_x_nodes;       ///< N p + 1 values; empty if constant
  std::vector<double> p_z_nodes;       ///< N p + 1 values; empty if constant
};

/// \param x, lambda  a solution of `problem`
[[nodiscard]] CostateSolution costates(const RollingTime& problem,
                                       std::span<const double> x,
                                       std::span<const double> lambda);

}  // namespace brachisto
