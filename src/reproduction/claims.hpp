// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Statements of the paper by what they are about; judge() has the others.

#pragma once

#include "reproduction/comparison.hpp"

namespace brachisto::reproduction {

// Bodies.
[[nodiscard]] Claim about_possible_bodies();

// Shape.
[[nodiscard]] Claim about_dependence_on_inertia(const Findings& found);
[[nodiscard]] Claim about_cycloids(const Findings& found);
[[nodiscard]] Claim about_pull(const Findings& found);
[[nodiscard]] Claim about_depth(const Findings& found);
[[nodiscard]] Claim about_effect_of_offset(const Findings& found);
[[nodiscard]] Claim about_place_of_peaks(const Findings& found);
[[nodiscard]] Claim about_effect_of_inertia(const Findings& found);
[[nodiscard]] Claim about_number_of_peaks(const Findings& found);

// Motion.
[[nodiscard]] Claim about_rise_of_normal_force(const Findings& found);
[[nodiscard]] Claim about_bulk_of_normal_force(const Findings& found);
[[nodiscard]] Claim about_angular_speed(const Findings& found);
[[nodiscard]] Claim about_incline(const Findings& found);
[[nodiscard]] Claim about_start(const Findings& found);

// The map of Fig. 13.
[[nodiscard]] Claim about_effect_of_orientation(const Findings& found);
[[nodiscard]] Claim about_minimum(const Findings& found);
[[nodiscard]] Claim about_orientation(const Findings& found);

}  // namespace brachisto::reproduction
