// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// That a path passes the surface of a sphere where an element ends.

#pragma once

#include <span>

#include "nlp/tangency_condition.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// The height h = |C_m − C| − R of the centre of mass above the surface of the
/// sphere about C at the beginning of an element, and its derivatives: with
/// n = (C_m − C)/|C_m − C|
///
///     ∂h/∂(x, z) = n,  ∂h/∂θ = r η (n_z cos θ − n_x sin θ).
///
/// h = 0 determines where that end lies, on which h itself does not depend.
[[nodiscard]] nlp::TangencyCondition::Linearisation height_at_beginning(
    const RollingTime& problem, int element, std::span<const double> x);

}  // namespace brachisto
