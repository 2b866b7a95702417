// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <cstddef>

#include "brachisto/model/plane_curve.hpp"
#include "model/cubic_spline.hpp"

namespace brachisto {

namespace {

std::vector<double> over_square(const std::vector<double>& q,
                                const std::vector<Point>& offsets,
                                double Point::*which) {
  std::vector<double> values;
  values.reserve(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    values.push_back(offsets[i].*which / (q[i] * q[i]));
  }
  return values;
}

/// offset = q² y(q), so that d(offset)/dq = q t with t = 2 y + q y', which is
/// not zero at the start; its direction is the slope.
class CurveFromRest final : public PlaneCurve {
 public:
  CurveFromRest(Point start, const std::vector<double>& q,
                const std::vector<Point>& offsets)
      : start_(start),
        q_(q),
        x_(q, over_square(q, offsets, &Point::x)),
        z_(q, over_square(q, offsets, &Point::z)) {
    // Continuous slope: at each point from the one before it.
    slopes_.push_back(slope(0, 0.0));
    for (int i = 0; i + 1 < static_cast<int>(q_.size()); ++i) {
      const double end = q_[static_cast<std::size_t>(i) + 1];
      slopes_.push_back(slopes_.back() +
                        std::remainder(slope(i, end) - slopes_.back(), kTurn));
    }
  }

  [[nodiscard]] Point start() const override { return start_; }
  [[nodiscard]] CurvePlace at(double q) const override {
    const int piece = x_.piece_of(q);
    const CubicSpline::Value x = x_.at(piece, q);
    const CubicSpline::Value z = z_.at(piece, q);
    const double t_x = tangent(x, q);
    const double t_z = tangent(z, q);
    const double near = slopes_[static_cast<std::size_t>(piece)];
    const auto [speed, turning] = pace_of(q, x, z);
    return {{q * q * x.f, q * q * z.f},
            near + std::remainder(std::atan2(t_z, t_x) - near, kTurn),
            speed,
            turning};
  }
  [[nodiscard]] Pace pace(double q) const override {
    const int piece = x_.piece_of(q);
    return pace_of(q, x_.at(piece, q), z_.at(piece, q));
  }
  [[nodiscard]] std::vector<double> joints() const override {
    // The first piece reaches back to the start.
    return {q_.begin() + 1, q_.end() - 1};
  }

 private:
  static constexpr double kTurn = 6.283185307179586;

  [[nodiscard]] static Pace pace_of(double q, const CubicSpline::Value& x,
                                    const CubicSpline::Value& z) {
    const double t_x = tangent(x, q);
    const double t_z = tangent(z, q);
    const double bend_x = 3.0 * x.d1 + q * x.d2;
    const double bend_z = 3.0 * z.d1 + q * z.d2;
    // std::hypot guards against squares that overflow, and costs more for it.
    const double square = t_x * t_x + t_z * t_z;
    return {q * std::sqrt(square), (t_x * bend_z - t_z * bend_x) / square};
  }
  /// A component of t, of which ds/dq is q times the length.
  [[nodiscard]] static double tangent(const CubicSpline::Value& y, double q) {
    return 2.0 * y.f + q * y.d1;
  }
  [[nodiscard]] double slope(int piece, double q) const {
    const CubicSpline::Value x = x_.at(piece, q);
    const CubicSpline::Value z = z_.at(piece, q);
    return std::atan2(tangent(z, q), tangent(x, q));
  }

  Point start_;
  std::vector<double> q_;
  CubicSpline x_, z_;
  std::vector<double> slopes_;
};

}  // namespace

PlaneCurvePtr curve_from_rest(Point start, const std::vector<double>& q,
                              const std::vector<Point>& offsets) {
  return std::make_shared<CurveFromRest>(start, q, offsets);
}

}  // namespace brachisto
