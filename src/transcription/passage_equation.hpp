// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// That a path passes the surface of its field where an element ends.

#pragma once

#include <span>

#include "nlp/tangency_condition.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// The height h of the centre of mass above the surface of the scene's field at
/// the beginning of an element, and its derivatives by x, z and θ there.
/// h = 0 determines where that end lies, on which h itself does not depend.
[[nodiscard]] nlp::TangencyCondition::Linearisation height_at_beginning(
    const RollingTime& problem, int element, std::span<const double> x);

}  // namespace brachisto
