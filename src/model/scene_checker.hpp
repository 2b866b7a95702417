// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the checks of validate() have in common, and those that are not in
/// model/scene.cpp.

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// Collects violations; each check says the value, the bound and the reason.
class SceneChecker {
 public:
  bool finite(const char* key, double value) {
    if (std::isfinite(value)) return true;
    add(key, fmt::format("{} is not a finite number", value));
    return false;
  }
  void positive(const char* key, double value, const char* unit,
                const char* reason) {
    if (!finite(key, value)) return;
    if (value > 0.0) return representable(key, value, unit);
    add(key, fmt::format("{}{} is not allowed: it must be > 0, {}", value, unit,
                         reason));
  }
  void representable(const char* key, double value, const char* unit) {
    if (value >= kSmallestQuantity && value <= kLargestQuantity) return;
    add(key,
        fmt::format(
            "{}{} is not allowed: it must be from {:g} to {:g}, for products "
            "of several such numbers have to be normal numbers of "
            "64 bits",
            value, unit, kSmallestQuantity, kLargestQuantity));
  }
  /// Of either sign, or zero.
  void moderate(const char* key, double value, const char* unit) {
    if (!finite(key, value) || std::abs(value) <= kLargestQuantity) return;
    add(key,
        fmt::format("{}{} is not allowed: it must be at most {:g}, either sign",
                    value, unit, kLargestQuantity));
  }
  /// \param unit  without the space before it, or ""
  void number(const char* key, double value, const std::string& unit,
              Allowed allowed, const char* reason) {
    const std::string behind = unit.empty() ? unit : " " + unit;
    switch (allowed) {
      case Allowed::Any:
        return moderate(key, value, behind.c_str());
      case Allowed::Positive:
        return positive(key, value, behind.c_str(), reason);
      case Allowed::NotNegative:
        if (value == 0.0 || !finite(key, value)) return;
        if (value > 0.0) return representable(key, value, behind.c_str());
        return add(key, fmt::format("{}{} is not allowed: it must be ≥ 0, {}",
                                    value, behind, reason));
      case Allowed::Fraction:
        if (!finite(key, value) || (value >= 0.0 && value < 1.0)) return;
        return add(key, fmt::format("{}{} is not allowed: 0 ≤ m < 1, {}", value,
                                    behind, reason));
    }
  }
  /// \param last  of the enumerators, which count from 0
  template <class Enum>
  void known(const char* key, Enum value, Enum last) {
    const auto number = static_cast<int>(value);
    if (number >= 0 && number <= static_cast<int>(last)) return;
    add(key, fmt::format("there is no value {}", number));
  }
  void angle(const char* key, double value) {
    if (!finite(key, value) || std::abs(value) <= kLargestAngle) return;
    add(key,
        fmt::format("{} rad is not allowed: it must be at most {:g} rad, "
                    "beyond which the "
                    "rounding of the number alone turns it by more than "
                    "6e-11 rad; leave out whole turns, or give degrees, of "
                    "which they are taken off exactly",
                    value, kLargestAngle));
  }
  void add(std::string key, std::string message) {
    errors_.push_back({std::move(key), std::move(message)});
  }
  /// Whether nothing was refused so far.
  [[nodiscard]] bool sound() const { return errors_.empty(); }
  [[nodiscard]] std::vector<SceneError> take() { return std::move(errors_); }

 private:
  std::vector<SceneError> errors_;
};

/// Refuses limits that are no limits, that no motion can keep to, or without
/// which a contact leaves no fastest track. What numbers demand of each other
/// is only asked where nothing else was refused.
void check_limits(const Scene& scene, SceneChecker& check);

/// Checks of validate() for scenes whose world is not ordinary.
void check_world(const Scene& scene, SceneChecker& check);

}  // namespace brachisto
