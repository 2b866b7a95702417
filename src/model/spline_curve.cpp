// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// spline_through(): a smooth curve through given points.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "brachisto/model/plane_curve.hpp"
#include "model/cubic_spline.hpp"

namespace brachisto {

namespace {

std::size_t at_index(int i) {
  return static_cast<std::size_t>(i);
}

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
    const int piece = x_.piece_of(t);
    const CubicSpline::Value x = x_.at(piece, t);
    const CubicSpline::Value z = z_.at(piece, t);
    const double near = slopes_[at_index(piece)];
    const double beta =
        near + std::remainder(std::atan2(z.d1, x.d1) - near, kTurn);
    const auto [speed, turning] = pace_of(q, x, z);
    return {{x.f - start_.x, z.f - start_.z}, beta, speed, turning};
  }
  [[nodiscard]] Pace pace(double q) const override {
    const double t = q * q;
    const int piece = x_.piece_of(t);
    return pace_of(q, x_.at(piece, t), z_.at(piece, t));
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

  // std::hypot guards against squares that overflow, and costs more for it.
  [[nodiscard]] static Pace pace_of(double q, const CubicSpline::Value& x,
                                    const CubicSpline::Value& z) {
    const double square = x.d1 * x.d1 + z.d1 * z.d1;
    return {2.0 * q * std::sqrt(square),
            2.0 * q * (x.d1 * z.d2 - z.d1 * x.d2) / square};
  }
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
  const std::vector<double> t = chord_lengths(points);
  const auto next = std::adjacent_find(t.begin(), t.end(), std::equal_to<>());
  if (next != t.end()) {
    throw std::invalid_argument(fmt::format(
        "the points {} and {} of the curve lie closer together than rounding "
        "of its length can tell",
        next - t.begin() + 1, next - t.begin() + 2));
  }
  return std::make_shared<Spline>(points);
}

}  // namespace brachisto
