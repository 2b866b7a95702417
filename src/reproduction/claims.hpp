// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Statements of the paper by what they are about; judge() has the others.

#pragma once

#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

// Bodies.
[[nodiscard]] Claim about_possible_bodies();

// Shape.
[[nodiscard]] Claim about_dependence_on_inertia(const Results& found);
[[nodiscard]] Claim about_cycloids(const Results& found);
[[nodiscard]] Claim about_pull(const Results& found);
[[nodiscard]] Claim about_depth(const Results& found);
[[nodiscard]] Claim about_effect_of_offset(const Results& found);
[[nodiscard]] Claim about_place_of_peaks(const Results& found);
[[nodiscard]] Claim about_effect_of_inertia(const Results& found);
[[nodiscard]] Claim about_number_of_peaks(const Results& found);

// Motion.
[[nodiscard]] Claim about_rise_of_normal_force(const Results& found);
[[nodiscard]] Claim about_bulk_of_normal_force(const Results& found);
[[nodiscard]] Claim about_angular_speed(const Results& found);
[[nodiscard]] Claim about_incline(const Results& found);
[[nodiscard]] Claim about_start(const Results& found);

// The map of Fig. 13.
[[nodiscard]] Claim about_effect_of_orientation(const Results& found);
[[nodiscard]] Claim about_minimum(const Results& found);
[[nodiscard]] Claim about_orientation(const Results& found);

}  // namespace brachisto::reproduction
