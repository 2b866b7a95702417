// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/cubic_spline.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace brachisto {

namespace {

/// Second derivative at t[0] of the cubic through the four points t[0], t[s],
/// t[2 s], t[3 s]; of the parabola if there are three, of the line if two.
double bend_at_end(const double* t, const double* y, std::ptrdiff_t s,
                   std::size_t count) {
  if (count < 3) return 0.0;
  const auto slope = [&](std::ptrdiff_t i) {
    return (y[(i + 1) * s] - y[i * s]) / (t[(i + 1) * s] - t[i * s]);
  };
  const auto second = [&](std::ptrdiff_t i) {
    return (slope(i + 1) - slope(i)) / (t[(i + 2) * s] - t[i * s]);
  };
  if (count < 4) return 2.0 * second(0);
  const double third = (second(1) - second(0)) / (t[3 * s] - t[0]);
  return 2.0 * (second(0) + third * (2.0 * t[0] - t[s] - t[2 * s]));
}

/// Second derivatives of one cubic spline through (t_i, y_i): the tridiagonal
/// system, which is diagonally dominant, by elimination.
std::vector<double> second_derivatives(std::span<const double> t,
                                       std::span<const double> y,
                                       std::optional<double> at_end) {
  const std::size_t n = t.size();
  std::vector<double> m(n, 0.0), upper(n, 0.0);
  m.front() = bend_at_end(t.data(), y.data(), 1, n);
  m.back() = bend_at_end(t.data() + n - 1, y.data() + n - 1, -1, n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = t[i] - t[i - 1];
    const double after = t[i + 1] - t[i];
    const double pivot = 2.0 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    const double bend =
        6.0 * ((y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before);
    m[i] = (bend - before * m[i - 1]) / pivot;
  }
  if (at_end) {
    const double h = t[n - 1] - t[n - 2];
    const double bend = 6.0 * (*at_end - (y[n - 1] - y[n - 2]) / h);
    m[n - 1] = (bend / h - m[n - 2]) / (2.0 - upper[n - 2]);
  }
  for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
  return m;
}

/// Of all splines that follow each other.
std::vector<double> all_second_derivatives(std::span<const double> t,
                                           std::span<const double> y,
                                           std::optional<double> at_end) {
  std::vector<double> all;
  while (!t.empty()) {
    const auto twice = std::ranges::adjacent_find(t);
    const bool last = twice == t.end();
    const std::size_t count =
        last ? t.size() : static_cast<std::size_t>(twice - t.begin()) + 1;
    const std::vector<double> m =
        second_derivatives(t.first(count), y.first(count),
                           last ? at_end : std::optional<double>());
    all.insert(all.end(), m.begin(), m.end());
    t = t.subspan(count);
    y = y.subspan(count);
  }
  return all;
}

}  // namespace

CubicSpline::CubicSpline(std::vector<double> t, std::vector<double> y,
                         std::optional<double> at_end)
    : t_(std::move(t)),
      y_(std::move(y)),
      m_(all_second_derivatives(t_, y_, at_end)) {}

int CubicSpline::piece_of(double t) const {
  const auto next = std::upper_bound(t_.begin() + 1, t_.end() - 1, t);
  return static_cast<int>(next - t_.begin()) - 1;
}

CubicSpline::Value CubicSpline::at(int piece, double t) const {
  const auto i = static_cast<std::size_t>(piece);
  const double h = t_[i + 1] - t_[i];
  const double a = (t_[i + 1] - t) / h;
  const double b = (t - t_[i]) / h;
  const double h2 = h * h / 6.0;
  return {a * y_[i] + b * y_[i + 1] +
              h2 * (a * (a * a - 1.0) * m_[i] + b * (b * b - 1.0) * m_[i + 1]),
          (y_[i + 1] - y_[i]) / h + h / 6.0 *
                                        ((1.0 - 3.0 * a * a) * m_[i] +
                                         (3.0 * b * b - 1.0) * m_[i + 1]),
          a * m_[i] + b * m_[i + 1]};
}

}  // namespace brachisto
