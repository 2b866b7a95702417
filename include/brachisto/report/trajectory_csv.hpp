// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path as a table.

#pragma once

#include <string>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto::report {

/// Comma-separated values with a header line, one row per node, 17 digits:
/// u, t, x_c, z_c, x_cm, z_cm, x_b, z_b, theta, beta, v_c, omega, R_n, R_t,
/// kappa_b, in SI units, angles in radians, forces in m g. A bead has no theta,
/// omega and R_t, which stay empty.
[[nodiscard]] std::string trajectory_csv(const Motion& motion);

}  // namespace brachisto::report
