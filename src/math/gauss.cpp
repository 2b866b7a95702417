// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/polynomial_basis.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace brachisto::math {

namespace {

/// Legendre polynomial P_n on [−1, 1] and its first two derivatives.
struct Legendre {
  long double value, slope, curvature;
};

Legendre legendre(int n, long double x) {
  long double previous = 1.0L;
  long double current = x;
  for (int i = 2; i <= n; ++i) {
    const long double next =
        ((2 * i - 1) * x * current - (i - 1) * previous) / i;
    previous = current;
    current = next;
  }
  // Both follow from the recurrence and Legendre's equation, |x| < 1.
  const long double gap = 1.0L - x * x;
  const long double slope = n * (previous - x * current) / gap;
  const long double curvature =
      (2.0L * x * slope - n * (n + 1.0L) * current) / gap;
  return {current, slope, curvature};
}

}  // namespace

QuadratureRule gauss_legendre(int count) {
  assert(count >= 1);
  const auto size = static_cast<std::size_t>(count);
  QuadratureRule rule{std::vector<double>(size), std::vector<double>(size)};
  for (int i = 0; i < count; ++i) {
    long double x = -std::cos(std::numbers::pi_v<long double> * (i + 0.75L) /
                              (count + 0.5L));
    for (int step = 0; step < 10; ++step) {
      const Legendre p = legendre(count, x);
      x -= p.value / p.slope;
    }
    const long double slope = legendre(count, x).slope;
    const auto index = static_cast<std::size_t>(i);
    rule.points[index] = static_cast<double>(0.5L * (1.0L + x));
    rule.weights[index] =
        static_cast<double>(1.0L / ((1.0L - x * x) * slope * slope));
  }
  return rule;
}

QuadratureRule radau_right(int count) {
  assert(count >= 1);
  const auto size = static_cast<std::size_t>(count);
  QuadratureRule rule{std::vector<double>(size, 1.0),
                      std::vector<double>(size, 1.0 / (1.0 * count * count))};
  // The zeros of P_n − P_{n−1}, 1 among them.
  for (int i = 1; i < count; ++i) {
    long double x = std::cos(2.0L * std::numbers::pi_v<long double> * i /
                             (2.0L * count - 1.0L));
    for (int step = 0; step < 20; ++step) {
      const Legendre p = legendre(count, x);
      const Legendre q = legendre(count - 1, x);
      x -= (p.value - q.value) / (p.slope - q.slope);
    }
    const long double below = count > 1 ? legendre(count - 1, x).value : 1.0L;
    const std::size_t index = size - 1 - static_cast<std::size_t>(i);
    rule.points[index] = static_cast<double>(0.5L * (1.0L + x));
    rule.weights[index] = static_cast<double>(
        0.5L * (1.0L + x) / (1.0L * count * count * below * below));
  }
  return rule;
}

std::vector<double> gauss_lobatto_points(int count) {
  assert(count >= 2);
  // The inner points are the extrema of P_{count−1}.
  const int n = count - 1;
  std::vector<double> points(static_cast<std::size_t>(count));
  points.front() = 0.0;
  points.back() = 1.0;
  for (int i = 1; i < n; ++i) {
    long double x = -std::cos(std::numbers::pi_v<long double> * i / n);
    for (int step = 0; step < 20; ++step) {
      const Legendre p = legendre(n, x);
      x -= p.slope / p.curvature;
    }
    points[static_cast<std::size_t>(i)] =
        static_cast<double>(0.5L * (1.0L + x));
  }
  return points;
}

}  // namespace brachisto::math
