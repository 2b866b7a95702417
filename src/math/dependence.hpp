// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers without a value, which tell what a formula written for a generic
/// Scalar depends on.

#pragma once

#include <bitset>
#include <cstddef>

namespace brachisto::math {

/// On which of `Size` independent variables a formula depends, whatever their
/// values: a derivative by any other is zero everywhere.
template <int Size>
struct Dependence {
  std::bitset<Size> any;
  std::bitset<Size> curved;  ///< those in which it need not be affine

  Dependence() = default;
  Dependence(double) {}  // NOLINT: numbers depend on nothing

  [[nodiscard]] static Dependence variable(int index) {
    Dependence out;
    out.any.set(static_cast<std::size_t>(index));
    return out;
  }
  /// Of a function that is not affine.
  [[nodiscard]] Dependence bent() const {
    Dependence out;
    out.any = out.curved = any;
    return out;
  }

  friend Dependence operator+(Dependence a, const Dependence& b) {
    a.any |= b.any;
    a.curved |= b.curved;
    return a;
  }
  friend Dependence operator-(const Dependence& a, const Dependence& b) {
    return a + b;
  }
  friend Dependence operator*(const Dependence& a, const Dependence& b) {
    const Dependence both = a + b;
    return a.any.none() || b.any.none() ? both : both.bent();
  }
  friend Dependence operator/(const Dependence& a, const Dependence& b) {
    return b.any.none() ? a : (a + b).bent();
  }
  friend Dependence sin(const Dependence& a) { return a.bent(); }
  friend Dependence cos(const Dependence& a) { return a.bent(); }
  friend Dependence sqrt(const Dependence& a) { return a.bent(); }
  /// Of both, for the place of the bound is nobody's.
  template <class Above, class Below>
  friend Dependence where_above(const Dependence&, double, const Above& above,
                                const Below& below) {
    return above() + below();
  }
};

}  // namespace brachisto::math
