// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// spline_through(): a smooth curve through given points.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "brachisto/model/plane_curve.hpp"

namespace brachisto {

namespace {

std::size_t at_index(int i) {
  return static_cast<std::size_t>(i);
}

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

/// Second derivatives of the cubic spline through (t_i, y_i), those at the ends
/// from the points nearby: the tridiagonal system, which is diagonally
/// dominant, by elimination.
std::vector<double> second_derivatives(const std::vector<double>& t,
                                       const std::vector<double>& y) {
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
  for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
  return m;
}

/// One coordinate as a function of the parameter.
class CubicSpline {
 public:
  CubicSpline(std::vector<double> t, std::vector<double> y)
      : t_(std::move(t)), y_(std::move(y)), m_(second_derivatives(t_, y_)) {}

  struct Value {
    double f, d1, d2;
  };
  [[nodiscard]] Value at(int piece, double t) const {
    const std::size_t i = at_index(piece);
    const double h = t_[i + 1] - t_[i];
    const double a = (t_[i + 1] - t) / h;
    const double b = (t - t_[i]) / h;
    const double h2 = h * h / 6.0;
    return {
        a * y_[i] + b * y_[i + 1] +
            h2 * (a * (a * a - 1.0) * m_[i] + b * (b * b - 1.0) * m_[i + 1]),
        (y_[i + 1] - y_[i]) / h +
            h / 6.0 *
                ((1.0 - 3.0 * a * a) * m_[i] + (3.0 * b * b - 1.0) * m_[i + 1]),
        a * m_[i] + b * m_[i + 1]};
  }

 private:
  std::vector<double> t_, y_, m_;
};

std::vector<double> chord_lengths(const std::vector<Point>& points) {
  std::vector<double> t{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    t.push_back(t.back() + std::hypot(points[i].x - points[i - 1].x,
                                      points[i].z - points[i - 1].z));
  }
  for (double& value : t) value /= t.back();
  return t;
}

std::vector<double> coordinate(const std::vector<Point>& points,
                               double Point::*which) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Point& point : points) values.push_back(point.*which);
  return values;
}

class Spline final : public PlaneCurve {
 public:
  explicit Spline(const std::vector<Point>& points)
      : start_(points.front()),
        t_(chord_lengths(points)),
        x_(t_, coordinate(points, &Point::x)),
        z_(t_, coordinate(points, &Point::z)) {
    // Continuous slope: at each point from the one before it.
    slopes_.push_back(slope(0, 0.0));
    for (int i = 0; i < num_pieces(); ++i) {
      const double end = t_[at_index(i) + 1];
      slopes_.push_back(slopes_.back() +
                        std::remainder(slope(i, end) - slopes_.back(), kTurn));
    }
  }

  [[nodiscard]] Point start() const override { return start_; }
  [[nodiscard]] CurvePlace at(double q) const override {
    const double t = q * q;
    const auto next = std::upper_bound(t_.begin() + 1, t_.end() - 1, t);
    const int piece = static_cast<int>(next - t_.begin()) - 1;
    const CubicSpline::Value x = x_.at(piece, t);
    const CubicSpline::Value z = z_.at(piece, t);
    const double speed = std::hypot(x.d1, z.d1);
    const double near = slopes_[at_index(piece)];
    const double beta =
        near + std::remainder(std::atan2(z.d1, x.d1) - near, kTurn);
    return {{x.f - start_.x, z.f - start_.z},
            beta,
            2.0 * q * speed,
            2.0 * q * (x.d1 * z.d2 - z.d1 * x.d2) / (speed * speed)};
  }

  [[nodiscard]] std::vector<double> joints() const override {
    std::vector<double> joints;
    for (std::size_t i = 1; i + 1 < t_.size(); ++i) {
      joints.push_back(std::sqrt(t_[i]));
    }
    return joints;
  }

 private:
  static constexpr double kTurn = 6.283185307179586;

  [[nodiscard]] int num_pieces() const {
    return static_cast<int>(t_.size()) - 1;
  }
  [[nodiscard]] double slope(int piece, double t) const {
    return std::atan2(z_.at(piece, t).d1, x_.at(piece, t).d1);
  }

  Point start_;
  std::vector<double> t_;
  CubicSpline x_, z_;
  std::vector<double> slopes_;
};

}  // namespace

PlaneCurvePtr spline_through(const std::vector<Point>& points) {
  if (points.size() < 2) {
    throw std::invalid_argument("a curve needs two points or more");
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].x == points[i - 1].x && points[i].z == points[i - 1].z) {
      throw std::invalid_argument("a point of the curve is repeated");
    }
  }
  return std::make_shared<Spline>(points);
}

}  // namespace brachisto
