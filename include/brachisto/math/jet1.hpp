// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// First-order forward jets: numbers that carry their exact gradient through
/// any formula written for a generic Scalar.

#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace brachisto::math {

/// Value and gradient with respect to `Size` independent variables.
///
/// \tparam Real  double, long double, or a jet of either
template <class Real, int Size>
struct Jet1 {
  Real value{};
  std::array<Real, Size> gradient{};

  Jet1() = default;
  template <std::convertible_to<Real> Number>
  Jet1(const Number& constant)  // NOLINT: numbers are jets
      : value(static_cast<Real>(constant)) {}

  /// The independent variable number `index`.
  [[nodiscard]] static Jet1 variable(Real v, int index) {
    Jet1 jet(v);
    jet.gradient[static_cast<std::size_t>(index)] = Real(1);
    return jet;
  }

  /// f(jet) from f and f' at its value, by the chain rule.
  [[nodiscard]] Jet1 chain(Real f, Real df) const {
    Jet1 out(f);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      out.gradient[i] = df * gradient[i];
    }
    return out;
  }

  Jet1& operator+=(const Jet1& other) {
    value += other.value;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] += other.gradient[i];
    }
    return *this;
  }
  Jet1& operator-=(const Jet1& other) {
    value -= other.value;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] -= other.gradient[i];
    }
    return *this;
  }
  [[nodiscard]] Jet1 operator-() const { return chain(-value, Real(-1)); }

  friend Jet1 operator+(Jet1 a, const Jet1& b) { return a += b; }
  friend Jet1 operator-(Jet1 a, const Jet1& b) { return a -= b; }
  friend Jet1 operator*(const Jet1& a, const Jet1& b) {
    Jet1 out(a.value * b.value);
    for (std::size_t i = 0; i < out.gradient.size(); ++i) {
      out.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
    }
    return out;
  }
  /// With a number no gradient has to be multiplied.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend Jet1 operator*(const Jet1& a, Number factor) {
    return a.chain(a.value * factor, Real(factor));
  }
  friend Jet1 operator/(const Jet1& a, const Jet1& b) {
    const Real inverse = Real(1) / b.value;
    return a * b.chain(inverse, -inverse * inverse);
  }
};

template <class Real, int Size>
[[nodiscard]] Jet1<Real, Size> sin(const Jet1<Real, Size>& a) {
  using std::cos;
  using std::sin;
  return a.chain(sin(a.value), cos(a.value));
}

template <class Real, int Size>
[[nodiscard]] Jet1<Real, Size> cos(const Jet1<Real, Size>& a) {
  using std::cos;
  using std::sin;
  return a.chain(cos(a.value), -sin(a.value));
}

template <class Real, int Size>
[[nodiscard]] Jet1<Real, Size> sqrt(const Jet1<Real, Size>& a) {
  using std::sqrt;
  const Real root = sqrt(a.value);
  return a.chain(root, Real(0.5) / root);
}

}  // namespace brachisto::math
