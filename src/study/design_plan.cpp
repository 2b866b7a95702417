// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/design.hpp"

#include <algorithm>
#include <limits>

#include "math/enum_table.hpp"

namespace brachisto {

std::string_view name(BodyKey key) {
  static constexpr auto kNames =
      table_by<BodyKey>(std::string_view("eta_m"), std::string_view("theta_m"),
                        std::string_view("k"), std::string_view("r"));
  return kNames[key];
}

bool DesignPlan::is_free(BodyKey key) const {
  return std::ranges::count(free, key) > 0;
}

DesignBounds DesignPlan::bounds_of(BodyKey key) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr auto kOfAllBodies = table_by<BodyKey>(
      DesignBounds{0.0, kLargestOffset}, DesignBounds{-kInfinity, kInfinity},
      DesignBounds{0.0, 1.0}, DesignBounds{0.0, kInfinity});
  return bounds[static_cast<std::size_t>(key)].value_or(kOfAllBodies[key]);
}

}  // namespace brachisto
