// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Closed forms in balls of real numbers: bounds that are proven, by Arb, with
/// Newton's method for intervals where an equation is solved. Nothing in a
/// build without Arb.

#pragma once

#include <optional>

namespace brachisto::benchmarks {

struct Enclosure {
  double lower, upper;
};

[[nodiscard]] std::optional<Enclosure> enclosed_root_of_3();
[[nodiscard]] std::optional<Enclosure> enclosed_least_fuel();
[[nodiscard]] std::optional<Enclosure> enclosed_hanging_chain();
[[nodiscard]] std::optional<Enclosure> enclosed_cycloid_time(double L);
/// \param thousand_g  1000 g, a number that a double is: g itself is none
[[nodiscard]] std::optional<Enclosure> enclosed_time_to_line(double thousand_g);
[[nodiscard]] std::optional<Enclosure> enclosed_time_along_wall(
    double thousand_g);

}  // namespace brachisto::benchmarks
