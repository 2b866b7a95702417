// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's method for square systems.

#pragma once

#include "brachisto/solvers/square_system.hpp"

namespace brachisto {

/// Solves F'(x) step = −F(x), F(x) being given. False if F' is singular or not
/// defined at x.
using NewtonCorrection = std::function<bool(std::span<const double> x,
                                            std::span<const double> residual,
                                            std::span<double> step)>;

/// Newton's method, a step being halved until ‖F‖ falls by the factor
/// 1 − 10⁻⁴ α at the share α of it, where points at which F is not defined do
/// not count as a fall. Whoever calls chooses the linear algebra.
[[nodiscard]] SquareResult solve_by_damped_newton(
    const SquareResidual& residual, const NewtonCorrection& correction,
    std::vector<double> start, const SquareOptions& options);

}  // namespace brachisto
