// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/plane_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "model/contact.hpp"
#include "model/cycloid.hpp"

namespace brachisto {

namespace {

constexpr double kVertical = 0.5 * std::numbers::pi;

/// A curve given by a polynomial in a parameter p = q², which starts from rest.
class Parabola final : public PlaneCurve {
 public:
  /// point(p) = start + p first + p² second
  Parabola(Point start, Point first, Point second, double start_angle)
      : start_(start),
        first_(first),
        second_(second),
        start_angle_(start_angle) {}

  [[nodiscard]] Point start() const override { return start_; }
  [[nodiscard]] CurvePlace at(double q) const override {
    const double p = q * q;
    const double dx = first_.x + 2.0 * p * second_.x;
    const double dz = first_.z + 2.0 * p * second_.z;
    const double speed = std::hypot(dx, dz);
    // Of the first tangent and this one; a parabola turns by less than π.
    const double cross = first_.x * dz - first_.z * dx;
    const double dot = first_.x * dx + first_.z * dz;
    const double bend = 2.0 * (dx * second_.z - dz * second_.x);
    return {{p * (first_.x + p * second_.x), p * (first_.z + p * second_.z)},
            start_angle_ + std::atan2(cross, dot),
            2.0 * q * speed,
            2.0 * q * bend / (speed * speed)};
  }

 private:
  Point start_, first_, second_;
  double start_angle_;
};

/// An arc whose slope angle changes from start to start + turn.
class CircularArc final : public PlaneCurve {
 public:
  CircularArc(Point start, double start_angle, double length, double turn)
      : start_(start),
        start_angle_(start_angle),
        length_(length),
        turn_(turn) {}

  [[nodiscard]] Point start() const override { return start_; }
  [[nodiscard]] CurvePlace at(double q) const override {
    const double p = q * q;
    const double half = 0.5 * turn_ * p;
    // The chord of an arc has the mean of the slopes at its ends.
    const double chord =
        length_ * p * (half == 0.0 ? 1.0 : std::sin(half) / half);
    return {{chord * std::cos(start_angle_ + half),
             chord * std::sin(start_angle_ + half)},
            start_angle_ + 2.0 * half,
            2.0 * q * length_,
            2.0 * q * turn_};
  }

 private:
  Point start_;
  double start_angle_, length_, turn_;
};

/// ψ is proportional to time as it is, so that nothing has to be substituted.
class Cycloid final : public PlaneCurve {
 public:
  explicit Cycloid(const CycloidArc& arc) : arc_(arc) {}

  [[nodiscard]] Point start() const override { return arc_.start; }

  [[nodiscard]] CurvePlace at(double q) const override {
    const double psi = q * arc_.psi_end;
    const double half = std::sin(0.5 * psi);
    return {{arc_.a * (psi - std::sin(psi)), 2.0 * arc_.a * half * half},
            arc_.slope_angle(psi),
            2.0 * arc_.a * half * arc_.psi_end,
            -0.5 * arc_.psi_end};
  }

 private:
  CycloidArc arc_;
};

class CentrePath final : public PlaneCurve {
 public:
  CentrePath(PlaneCurvePtr track, double radius)
      : track_(std::move(track)),
        radius_(radius),
        start_beta_(track_->at(0.0).beta) {}

  [[nodiscard]] Point start() const override {
    return centre_above(track_->start(), radius_, start_beta_);
  }

  [[nodiscard]] CurvePlace at(double q) const override {
    CurvePlace place = track_->at(q);
    // r (sin β − sin β₀, cos β₀ − cos β) as products.
    const double half = 0.5 * (place.beta - start_beta_);
    const double mean = start_beta_ + half;
    const double chord = 2.0 * radius_ * std::sin(half);
    place.offset.x += chord * std::cos(mean);
    place.offset.z += chord * std::sin(mean);
    place.speed += radius_ * place.turning;  // ds_c = (1 + r κ_b) ds_b
    return place;
  }
  [[nodiscard]] Pace pace(double q) const override {
    Pace pace = track_->pace(q);
    pace.speed += radius_ * pace.turning;
    return pace;
  }
  [[nodiscard]] std::vector<double> joints() const override {
    return track_->joints();
  }

 private:
  PlaneCurvePtr track_;
  double radius_, start_beta_;
};

/// A curve with ds/dq > 0 at its start, as one that starts from rest: at q² of
/// its own parameter.
class FromRestAlong final : public PlaneCurve {
 public:
  explicit FromRestAlong(PlaneCurvePtr curve) : curve_(std::move(curve)) {}

  [[nodiscard]] Point start() const override { return curve_->start(); }
  [[nodiscard]] CurvePlace at(double q) const override {
    CurvePlace place = curve_->at(q * q);
    place.speed *= 2.0 * q;
    place.turning *= 2.0 * q;
    return place;
  }
  [[nodiscard]] Pace pace(double q) const override {
    const Pace pace = curve_->pace(q * q);
    return {2.0 * q * pace.speed, 2.0 * q * pace.turning};
  }
  [[nodiscard]] std::vector<double> joints() const override {
    std::vector<double> joints = curve_->joints();
    for (double& q : joints) q = std::sqrt(q);
    // Beside a path of little other radius ds/dq is 2 q (v + 2 S q²) with a v
    // that is small: it changes where the second outgrows the first.
    const double most = 0.25 * (joints.empty() ? 1.0 : joints.front());
    for (double q =
             std::sqrt(curve_->pace(0.0).speed / curve_->pace(1.0).speed);
         q < most; q *= 2.0) {
      joints.push_back(q);
    }
    std::ranges::sort(joints);
    return joints;
  }

 private:
  PlaneCurvePtr curve_;
};

}  // namespace

Point point_of(const PlaneCurve& curve, const CurvePlace& place) {
  const Point start = curve.start();
  return {start.x + place.offset.x, start.z + place.offset.z};
}

PlaneCurvePtr straight_line(Point start, Point end) {
  const Point chord{end.x - start.x, end.z - start.z};
  return std::make_shared<Parabola>(start, chord, Point{},
                                    std::atan2(chord.z, chord.x));
}

PlaneCurvePtr parabola(Point start, Point end, double start_angle) {
  const Point chord{end.x - start.x, end.z - start.z};
  if (start_angle == kVertical) {
    if (!(chord.z > 0.0)) {
      throw std::invalid_argument(
          "a parabola with a vertical start has to end below it");
    }
    return std::make_shared<Parabola>(start, Point{0.0, chord.z},
                                      Point{chord.x, 0.0}, kVertical);
  }
  if (!(std::abs(start_angle) < kVertical) || !(chord.x > 0.0)) {
    throw std::invalid_argument(
        "a parabola with a vertical axis needs a start angle between -90 and "
        "90 degrees and an end to the right");
  }
  const double drop = chord.x * std::tan(start_angle);
  return std::make_shared<Parabola>(start, Point{chord.x, drop},
                                    Point{0.0, chord.z - drop}, start_angle);
}

PlaneCurvePtr circular_arc(Point start, Point end, double start_angle) {
  const double dx = end.x - start.x;
  const double dz = end.z - start.z;
  const double distance = std::hypot(dx, dz);
  // Half the turn is the angle from the tangent to the chord.
  const double along =
      (dx * std::cos(start_angle) + dz * std::sin(start_angle)) / distance;
  const double across =
      (dz * std::cos(start_angle) - dx * std::sin(start_angle)) / distance;
  const double half = std::atan2(across, along);
  constexpr double kStraightBack = 1e-9;
  if (!(distance > 0.0) || std::numbers::pi - std::abs(half) < kStraightBack) {
    throw std::invalid_argument(
        "no circular arc leads straight back from its start");
  }
  const double length = distance * (half == 0.0 ? 1.0 : half / std::sin(half));
  return std::make_shared<CircularArc>(start, start_angle, length, 2.0 * half);
}

PlaneCurvePtr cycloid_curve(Point start, Point end) {
  const std::optional<CycloidArc> arc = cycloid_between(start, end);
  if (!arc) {
    throw std::invalid_argument(
        "a cycloid has to end to the right of and below its cusp");
  }
  return std::make_shared<Cycloid>(*arc);
}

PlaneCurvePtr centre_path_over(PlaneCurvePtr track, double radius) {
  auto path = std::make_shared<CentrePath>(std::move(track), radius);
  // Beside a path whose curvature has no bound at the start there is one.
  if (path->pace(0.0).speed > 0.0) {
    return std::make_shared<FromRestAlong>(std::move(path));
  }
  return path;
}

}  // namespace brachisto
