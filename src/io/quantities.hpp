// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The quantities that expressions of a sweep may name.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace brachisto::io {

/// A number of the scene under the name that the notation gives it.
struct Quantity {
  std::string_view name;
  std::string_view path;  ///< dotted key of its value
};

inline constexpr std::array<Quantity, 6> kQuantities{{
    {"r", "scene.body.radius"},
    {"eta_m", "scene.body.eta_m"},
    {"theta_m", "scene.body.theta_m"},
    {"k", "scene.body.k"},
    {"L", "scene.finish.L"},
    {"H", "scene.finish.H"},
}};

/// Their values in one scene, in SI units and rad.
using QuantityValues = std::array<double, kQuantities.size()>;

/// Index of the quantity with a name, kQuantities.size() if there is none.
[[nodiscard]] constexpr std::size_t quantity_named(std::string_view name) {
  const auto found = std::ranges::find(kQuantities, name, &Quantity::name);
  return static_cast<std::size_t>(found - kQuantities.begin());
}

/// Index of the quantity that is the value of a key, or kQuantities.size().
[[nodiscard]] constexpr std::size_t quantity_of_key(std::string_view path) {
  const auto found = std::ranges::find(kQuantities, path, &Quantity::path);
  return static_cast<std::size_t>(found - kQuantities.begin());
}

}  // namespace brachisto::io
