// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Smooth curves by cubic splines: of both coordinates of given points, or of
/// the slope angle.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "math/angle.hpp"
#include "model/cubic_spline.hpp"
#include "model/plane_curve.hpp"

namespace brachisto {

namespace {

/// What the value of a spline means for one coordinate.
struct Part {
  double offset, tangent, bend;
};

/// Splines are coordinates as functions of t = q².
struct OfSquare {
  static double parameter(double q) { return q * q; }
  static double place(double t) { return std::sqrt(t); }
  static Part part(const CubicSpline::Value& y, double) {
    return {y.f, y.d1, y.d2};
  }
  /// ds/dq over the length of the tangent, and dβ/dq over its own turning.
  static double pace(double q) { return 2.0 * q; }
  static double turning(double q) { return 2.0 * q; }
};

/// offset = q² y(q), so that d(offset)/dq = q t with t = 2 y + q y', which is
/// not zero at the start; its direction is the slope.
struct FromRest {
  static double parameter(double q) { return q; }
  static double place(double t) { return t; }
  static Part part(const CubicSpline::Value& y, double q) {
    return {q * q * y.f, 2.0 * y.f + q * y.d1, 3.0 * y.d1 + q * y.d2};
  }
  static double pace(double q) { return q; }
  static double turning(double) { return 1.0; }
};

template <class Way>
class SplineCurve final : public PlaneCurve {
 public:
  /// \param t       ascending from 0
  /// \param origin  from which offsets are measured
  SplineCurve(Point start, Point origin, const std::vector<double>& t,
              CubicSpline x, CubicSpline z)
      : start_(start),
        origin_(origin),
        t_(t),
        x_(std::move(x)),
        z_(std::move(z)) {
    // Continuous slope: at each point from the one before it.
    slopes_.push_back(slope(0, 0.0));
    for (int i = 0; i + 1 < static_cast<int>(t_.size()); ++i) {
      slopes_.push_back(
          continued(slopes_.back(), slope(i, t_[at_knot(i + 1)])));
    }
  }

  [[nodiscard]] Point start() const override { return start_; }
  [[nodiscard]] CurvePlace at(double q) const override {
    const auto [piece, x, z] = parts(q);
    const auto [speed, turning] = pace_of(q, x, z);
    return {
        {x.offset - origin_.x, z.offset - origin_.z},
        continued(slopes_[at_knot(piece)], std::atan2(z.tangent, x.tangent)),
        speed,
        turning};
  }
  [[nodiscard]] Pace pace(double q) const override {
    const auto [piece, x, z] = parts(q);
    return pace_of(q, x, z);
  }
  [[nodiscard]] std::vector<double> joints() const override {
    std::vector<double> joints;
    for (std::size_t i = 1; i + 1 < t_.size(); ++i) {
      joints.push_back(Way::place(t_[i]));
    }
    return joints;
  }

 private:
  struct Parts {
    int piece;
    Part x, z;
  };

  static std::size_t at_knot(int i) { return brachisto::at(i); }
  /// The angle next to `near` of the same direction.
  static double continued(double near, double angle) {
    return near + std::remainder(angle - near, math::kTurn);
  }
  [[nodiscard]] Parts parts(double q) const {
    const double t = Way::parameter(q);
    const int piece = x_.piece_of(t);
    return {piece, Way::part(x_.at(piece, t), q),
            Way::part(z_.at(piece, t), q)};
  }
  [[nodiscard]] static Pace pace_of(double q, const Part& x, const Part& z) {
    // std::hypot guards against squares that overflow, and costs more for it.
    const double square = x.tangent * x.tangent + z.tangent * z.tangent;
    return {
        Way::pace(q) * std::sqrt(square),
        Way::turning(q) * (x.tangent * z.bend - z.tangent * x.bend) / square};
  }
  [[nodiscard]] double slope(int piece, double t) const {
    return std::atan2(Way::part(z_.at(piece, t), t).tangent,
                      Way::part(x_.at(piece, t), t).tangent);
  }

  Point start_, origin_;
  std::vector<double> t_;
  CubicSpline x_, z_;
  std::vector<double> slopes_;
};

/// The direction by a spline, and places as its integrals.
class CurveOfSlopes final : public PlaneCurve {
 public:
  CurveOfSlopes(Point start, const SlopesAlong& slopes)
      : start_(start),
        length_(slopes.length),
        over_length_(slopes.smooth_over_length),
        q_(slopes.q),
        beta_(parameters(), slopes.beta) {
    for (int i = 0; i + 1 < static_cast<int>(q_.size()); ++i) {
      offsets_.push_back(integral(i, q_[brachisto::at(i + 1)]));
    }
  }

  [[nodiscard]] Point start() const override { return start_; }
  [[nodiscard]] CurvePlace at(double q) const override {
    const int piece = beta_.piece_of(parameter(q));
    const auto [speed, turning] = pace_on(piece, q);
    return {integral(piece, q), beta_.at(piece, parameter(q)).f, speed,
            turning};
  }
  [[nodiscard]] Pace pace(double q) const override {
    return pace_on(beta_.piece_of(parameter(q)), q);
  }
  [[nodiscard]] std::vector<double> joints() const override {
    std::vector<double> joints(q_.begin() + 1, q_.end() - 1);
    joints.erase(std::ranges::unique(joints).begin(), joints.end());
    return joints;
  }

 private:
  [[nodiscard]] double parameter(double q) const {
    return over_length_ ? q * q : q;
  }
  [[nodiscard]] std::vector<double> parameters() const {
    std::vector<double> out = q_;
    for (double& q : out) q = parameter(q);
    return out;
  }
  [[nodiscard]] Pace pace_on(int piece, double q) const {
    const double rate = over_length_ ? 2.0 * q : 1.0;
    return {2.0 * length_ * q, rate * beta_.at(piece, parameter(q)).d1};
  }
  /// ∫ (cos β, sin β) ds from the start, by a rule of order 8 on each piece.
  [[nodiscard]] Point integral(int piece, double q) const {
    static const math::QuadratureRule rule = math::gauss_legendre(4);
    const double from = q_[brachisto::at(piece)];
    Point sum = offsets_[brachisto::at(piece)];
    if (q == from) return sum;  // so that none is of no width
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double there = from + (q - from) * rule.points[i];
      const double beta = beta_.at(piece, parameter(there)).f;
      const double ds = rule.weights[i] * (q - from) * 2.0 * length_ * there;
      sum.x += std::cos(beta) * ds;
      sum.z += std::sin(beta) * ds;
    }
    return sum;
  }

  Point start_;
  double length_;
  bool over_length_;
  std::vector<double> q_;
  CubicSpline beta_;
  std::vector<Point> offsets_{{}};  ///< at each q
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

/// offset/q² of one coordinate over 0 and q.
CubicSpline over_square(const CurveEnds& ends, const std::vector<double>& knots,
                        const std::vector<Point>& offsets,
                        double Point::*which) {
  std::vector<double> values{ends.at_start.*which};
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    values.push_back(offsets[i].*which / (knots[i + 1] * knots[i + 1]));
  }
  if (!ends.at_end) return {knots, values};
  return {knots, values, (*ends.at_end).*which - 2.0 * offsets.back().*which};
}

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
  return std::make_shared<SplineCurve<OfSquare>>(
      points.front(), points.front(), t,
      CubicSpline(t, coordinate(points, &Point::x)),
      CubicSpline(t, coordinate(points, &Point::z)));
}

PlaneCurvePtr curve_from_rest(Point start, const CurveEnds& ends,
                              const std::vector<double>& q,
                              const std::vector<Point>& offsets) {
  std::vector<double> knots{0.0};
  knots.insert(knots.end(), q.begin(), q.end());
  return std::make_shared<SplineCurve<FromRest>>(
      start, Point{}, knots, over_square(ends, knots, offsets, &Point::x),
      over_square(ends, knots, offsets, &Point::z));
}

PlaneCurvePtr curve_of_slopes(Point start, const SlopesAlong& slopes) {
  return std::make_shared<CurveOfSlopes>(start, slopes);
}

}  // namespace brachisto
