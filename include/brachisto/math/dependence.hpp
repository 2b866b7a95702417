// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers without a value, which tell what a formula written for a generic
/// Scalar depends on.

#pragma once

#include <array>
#include <bitset>
#include <cstddef>

namespace brachisto::math {

/// On which of `Size` independent variables a formula depends, whatever their
/// values: a derivative by any other is zero everywhere.
template <int Size>
struct Dependence {
  using Set = std::bitset<Size>;
  Set any;
  /// By which second variables there may be second derivatives, of each.
  std::array<Set, Size> second;

  Dependence() = default;
  Dependence(double) {}  // NOLINT: numbers depend on nothing

  [[nodiscard]] static Dependence variable(int index) {
    Dependence out;
    out.any.set(static_cast<std::size_t>(index));
    return out;
  }
  /// Of a function that is not affine.
  [[nodiscard]] Dependence bent() const {
    Dependence out = *this;
    out.couple(any, any);
    return out;
  }

  Dependence& operator+=(const Dependence& other) {
    any |= other.any;
    for (std::size_t i = 0; i < second.size(); ++i)
      second[i] |= other.second[i];
    return *this;
  }
  [[nodiscard]] Dependence operator-() const { return *this; }
  Dependence& operator-=(const Dependence& other) { return *this += other; }

  friend Dependence operator+(Dependence a, const Dependence& b) {
    return a += b;
  }
  friend Dependence operator-(const Dependence& a, const Dependence& b) {
    return a + b;
  }
  friend Dependence operator*(const Dependence& a, const Dependence& b) {
    Dependence out = a + b;
    out.couple(a.any, b.any);
    out.couple(b.any, a.any);
    return out;
  }
  friend Dependence operator/(const Dependence& a, const Dependence& b) {
    return a * b.bent();
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

 private:
  void couple(const Set& these, const Set& those) {
    for (std::size_t i = 0; i < second.size(); ++i) {
      if (these[i]) second[i] |= those;
    }
  }
};

}  // namespace brachisto::math
