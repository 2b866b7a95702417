// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The grip that rolling needs, as a friction coefficient and in words.

#pragma once

#include <span>
#include <string>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// μ = tan ρ of a friction angle ρ ∈ [0, π]; ∞ from π/2 on.
[[nodiscard]] double friction_coefficient(double rho);

/// "0.621", rounded up to three digits; "more than any" for ∞.
[[nodiscard]] std::string grip_in_words(double mu);

/// "0.621 from 1 % of the time on, 0.45 from 5 % on; more than any at the start
/// itself": what least μ is asked for, in plain letters.
///
/// \param grip  by ascending share of the time, as in PathDiagnostics
[[nodiscard]] std::string grip_in_words(std::span<const LeastGrip> grip);

}  // namespace brachisto
