// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The grip that rolling needs, as a friction coefficient and in words.

#pragma once

#include <span>
#include <string>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// To what limits on forces are kept [m g].
inline constexpr double kForceKept = 1e-8;

/// A force [m g] as it is told: 0 where it is less than limits are kept to.
[[nodiscard]] constexpr double told_force(double force) {
  return force < kForceKept && force > -kForceKept ? 0.0 : force;
}

/// μ = tan ρ of a friction angle ρ ∈ [0, π]; ∞ from π/2 on.
[[nodiscard]] double friction_coefficient(double rho);

/// "0.621", rounded up to three digits, but for what limits are kept to; "more
/// than any" for ∞.
[[nodiscard]] std::string grip_in_words(double mu);

/// "0.621 from 1 % of the time on, 0.45 from 5 % on; more than any at the start
/// itself": what least μ is asked for, in plain letters.
///
/// \param grip  by ascending share of the time, as in PathDiagnostics
[[nodiscard]] std::string grip_in_words(std::span<const LeastGrip> grip);

}  // namespace brachisto
