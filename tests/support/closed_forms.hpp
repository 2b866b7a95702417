// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Closed forms of classics of optimal control, for any scalar that has sin,
/// cos, sqrt, atan, sinh, cosh and atanh: numbers, or balls that enclose them.
/// No code of the library is used.

#pragma once

#include <cmath>
#include <numbers>

namespace brachisto::testing {

// Of numbers; those of balls are found by their arguments.
using std::atan, std::atanh, std::cos, std::cosh, std::sin, std::sinh,
    std::sqrt;

template <class S>
struct Constants {
  [[nodiscard]] static S pi() { return std::numbers::pi_v<S>; }
};

/// A cycloid x = R (φ − sin φ), y = R (1 − cos φ) from rest to (L, 1): φ at its
/// end makes this vanish.
struct CycloidAngle {
  double L;
  template <class S>
  [[nodiscard]] S value(const S& phi) const {
    return phi - sin(phi) - S(L) * (S(1.0) - cos(phi));
  }
  template <class S>
  [[nodiscard]] S slope(const S& phi) const {
    return S(1.0) - cos(phi) - S(L) * sin(phi);
  }
};

/// The time along it with g = 1/2.
template <class S>
[[nodiscard]] S cycloid_time(const S& phi) {
  return sqrt(S(2.0) / (S(1.0) - cos(phi))) * phi;
}

/// To the line x = 1.
template <class S>
[[nodiscard]] S time_to_line(const S& g) {
  return sqrt(Constants<S>::pi() / g);
}

/// To it under y ≤ x/2 + 0.1: two cycloids with the slope of the wall, which is
/// cot(φ/2), at its ends, and a straight slide between them.
template <class S>
[[nodiscard]] S time_along_wall(const S& g) {
  const S slope(0.5), one(1.0), offset = one / S(10.0), pi = Constants<S>::pi();
  const S phi = S(2.0) * atan(one / slope);
  const S x = phi - sin(phi), y = one - cos(phi);
  const S first = offset / (y - slope * x);
  // From a place of the same slope to the horizontal at x = 1.
  const S rest = pi - phi + sin(phi);
  const S second = (offset + slope) / (y + slope * rest);
  const S sine = slope / sqrt(one + slope * slope);
  const auto speed = [&](const S& depth) { return sqrt(S(2.0) * g * depth); };
  return sqrt(first / g) * phi +
         (speed(second * y) - speed(first * y)) / (g * sine) +
         sqrt(second / g) * (pi - phi);
}

/// x = a cosh((t − b)/a) + c through (0, 1) and (1, 3) with the length 4: a
/// makes this vanish.
struct CatenaryParameter {
  template <class S>
  [[nodiscard]] S value(const S& a) const {
    return S(2.0) * a * sinh(S(0.5) / a) - sqrt(S(12.0));
  }
  template <class S>
  [[nodiscard]] S slope(const S& a) const {
    return S(2.0) * sinh(S(0.5) / a) - cosh(S(0.5) / a) / a;
  }
};

/// ∫ x ds along it.
template <class S>
[[nodiscard]] S catenary_cost(const S& a) {
  const S b = S(0.5) - a * atanh(S(0.5)), c = S(1.0) - a * cosh(b / a);
  return S(0.5) * a +
         S(0.25) * a * a *
             (sinh(S(2.0) * (S(1.0) - b) / a) + sinh(S(2.0) * b / a)) +
         S(4.0) * c;
}

/// Where a function that ascends or descends vanishes.
template <class Function>
[[nodiscard]] long double bisected(const Function& f, long double low,
                                   long double high) {
  const bool ascends = f(high) > 0.0L;
  for (int i = 0; i < 80; ++i) {
    const long double middle = 0.5L * (low + high);
    ((f(middle) > 0.0L) == ascends ? high : low) = middle;
  }
  return 0.5L * (low + high);
}

/// From rest to (L, 1), g = 1/2.
[[nodiscard]] inline double cycloid_time_to(double L) {
  const CycloidAngle angle{L};
  return static_cast<double>(cycloid_time(
      bisected([&](long double phi) { return angle.value(phi); }, 0.1L,
               2.0L * std::numbers::pi_v<long double> - 1e-6L)));
}

[[nodiscard]] inline double hanging_chain() {
  return static_cast<double>(catenary_cost(
      bisected([](long double a) { return CatenaryParameter().value(a); },
               0.05L, 10.0L)));
}

}  // namespace brachisto::testing
