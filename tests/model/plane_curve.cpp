// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/plane_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace brachisto {
namespace {

constexpr double kVertical = 0.5 * std::numbers::pi;

std::vector<std::pair<std::string, PlaneCurvePtr>> all_curves() {
  const Point a{0.5, -0.25}, b{3.0, 1.0};
  const PlaneCurvePtr arc = circular_arc(a, b, 1.2);
  return {
      {"straight", straight_line(a, b)},
      {"parabola, vertical start", parabola(a, b, kVertical)},
      {"parabola", parabola(a, b, 0.9)},
      {"arc", arc},
      {"arc, vertical start", circular_arc(a, b, kVertical)},
      {"arc that bends down", circular_arc(a, b, 0.1)},
      {"cycloid", cycloid_curve(a, b)},
      {"centre over an arc", centre_path_over(arc, 0.3)},
      {"spline", spline_through({a, {1.0, 0.6}, {2.0, 0.7}, b})},
      {"through places from rest",
       curve_from_rest(a, {{0.1, 1.0}, {}}, {0.3, 0.5, 0.8, 1.0},
                       {{0.01, 0.1}, {0.1, 0.3}, {1.1, 0.9}, {2.5, 1.25}})}};
}

/// Places away from the start, where central differences may be taken.
// None of them a knot, where the rate of turning has a kink.
const std::vector<double> kPlaces{0.05, 0.27, 0.52, 0.7, 0.95};

TEST(CurveFromRest, IsExactForCubicsOverSquares) {
  // Cubic splines with the end conditions of cubics reproduce them: offsets q²
  // (1 + q, 2 − q³), also before the first place. So they do where the way is
  // (5, −1) at the end, as the derivative tells.
  const auto offset = [](double q) {
    return Point{q * q * (1.0 + q), q * q * (2.0 - q * q * q)};
  };
  const std::vector<double> places{0.2, 0.4, 0.5, 0.8, 1.0};
  std::vector<Point> offsets;
  for (const double q : places) offsets.push_back(offset(q));

  constexpr double kRounding = 1e-14;
  for (const CurveEnds& ends :
       {CurveEnds{{1.0, 2.0}, {}}, {{1.0, 2.0}, Point{5.0, -1.0}}}) {
    const PlaneCurvePtr curve =
        curve_from_rest({3.0, 4.0}, ends, places, offsets);
    for (const double q : {0.0, 1e-6, 0.1, 0.3, 0.45, 0.7, 0.99, 1.0}) {
      const CurvePlace at = curve->at(q);
      EXPECT_NEAR(at.offset.x, offset(q).x, kRounding) << q;
      EXPECT_NEAR(at.offset.z, offset(q).z, kRounding) << q;
      // d(offset)/dq = q (2 + 3 q, 4 − 5 q³), and its turning.
      const double x = 2.0 + 3.0 * q, z = 4.0 - 5.0 * q * q * q;
      EXPECT_NEAR(at.beta, std::atan2(z, x), 10.0 * kRounding) << q;
      EXPECT_NEAR(at.speed, q * std::hypot(x, z), 10.0 * kRounding) << q;
      EXPECT_NEAR(at.turning, (x * (-15.0 * q * q) - z * 3.0) / (x * x + z * z),
                  100.0 * kRounding)
          << q;
    }
  }
}

TEST(CurveFromRest, EndsWithTheSlopeThatIsGiven) {
  // Few places on the arc s = q² π/2 of a circle of radius 1.
  const std::vector<double> places{0.4, 0.7, 1.0};
  std::vector<Point> offsets;
  for (const double q : places) {
    const double s = kVertical * q * q;
    offsets.push_back({std::sin(s), 1.0 - std::cos(s)});
  }

  const double S = kVertical;
  const PlaneCurvePtr curve =
      curve_from_rest({}, {{S, 0.0}, Point{0.0, 2.0 * S}}, places, offsets);

  const CurvePlace end = curve->at(1.0);
  EXPECT_NEAR(end.beta, kVertical, 1e-15);
  EXPECT_NEAR(end.speed, 2.0 * kVertical, 1e-14);
  EXPECT_NEAR(end.offset.x, 1.0, 1e-15);
}

TEST(CurveOfSlopes, IsExactWhereSlopesAreCubics) {
  // β = q², s = q² π/2: an arc of 1 rad of a circle of radius π/2. Its places
  // are integrals by a rule of order 8, with 10 pieces to 2e-14.
  const double R = kVertical;
  const auto on_arc = [&](double beta) {
    return Point{R * std::sin(beta), R * (1.0 - std::cos(beta))};
  };
  SlopesAlong slopes{R, {}, {}};
  for (int i = 0; i <= 10; ++i) {
    slopes.q.push_back(0.1 * i);
    slopes.beta.push_back(0.01 * i * i);
  }
  slopes.q.back() = 1.0;
  const PlaneCurvePtr curve = curve_of_slopes({}, slopes);

  for (const double q : {0.0, 1e-6, 0.05, 0.33, 0.7, 1.0}) {
    const CurvePlace at = curve->at(q);
    EXPECT_NEAR(at.beta, q * q, 1e-15) << q;
    EXPECT_NEAR(at.turning, 2.0 * q, 1e-13) << q;
    EXPECT_NEAR(at.speed, 2.0 * R * q, 1e-15) << q;
    EXPECT_NEAR(at.offset.x, on_arc(q * q).x, 1e-12) << q;
    EXPECT_NEAR(at.offset.z, on_arc(q * q).z, 1e-12) << q;
  }
}

TEST(CurveOfSlopes, TurnsSharplyWhereAPlaceIsGivenTwice) {
  // Half a metre down at 45°, then half of an arc of the radius 1 m: to each
  // side of the joint, where an ulp decides, the curvature is that of its own.
  constexpr double kHalf = 0.5, kSlope = 0.25 * std::numbers::pi;
  const double joint = std::sqrt(kHalf);
  SlopesAlong slopes{1.0, {}, {}, true};
  for (const auto& [from, to] : {std::pair{0.0, kHalf}, {kHalf, 1.0}}) {
    for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const double s = from + share * (to - from);
      slopes.q.push_back(s == kHalf ? joint : std::sqrt(s));
      slopes.beta.push_back(kSlope - std::max(0.0, s - kHalf));
    }
  }
  const PlaneCurvePtr curve = curve_of_slopes({}, slopes);

  EXPECT_EQ(std::ranges::count(curve->joints(), joint), 1);
  EXPECT_NEAR(curve->at(std::nextafter(joint, 0.0)).turning, 0.0, 1e-12);
  EXPECT_NEAR(curve->at(joint).turning, -2.0 * joint, 1e-12);
  const CurvePlace end = curve->at(1.0);
  const double beta = kSlope - kHalf, half = kHalf * std::sqrt(kHalf);
  EXPECT_NEAR(end.beta, beta, 1e-14);
  EXPECT_NEAR(end.offset.x, half + std::sin(kSlope) - std::sin(beta), 1e-12);
  EXPECT_NEAR(end.offset.z, half + std::cos(beta) - std::cos(kSlope), 1e-12);
}

TEST(PlaneCurve, HasTheTangentOfItsSlopeAngle) {
  constexpr double h = 1e-5;
  for (const auto& [name, curve] : all_curves()) {
    for (const double q : kPlaces) {
      const Point before = curve->at(q - h).offset;
      const Point after = curve->at(q + h).offset;
      const CurvePlace place = curve->at(q);
      EXPECT_NEAR((after.x - before.x) / (2.0 * h),
                  place.speed * std::cos(place.beta), 1e-8)
          << name << " at " << q;
      EXPECT_NEAR((after.z - before.z) / (2.0 * h),
                  place.speed * std::sin(place.beta), 1e-8)
          << name << " at " << q;
    }
  }
}

TEST(PlaneCurve, TurnsAsItsSlopeAngleDoes) {
  constexpr double h = 1e-5;
  for (const auto& [name, curve] : all_curves()) {
    for (const double q : kPlaces) {
      EXPECT_NEAR((curve->at(q + h).beta - curve->at(q - h).beta) / (2.0 * h),
                  curve->at(q).turning, 1e-8)
          << name << " at " << q;
    }
  }
}

TEST(PlaneCurve, StartsFromRestAndEndsWhereItShould) {
  for (const auto& [name, curve] : all_curves()) {
    EXPECT_EQ(curve->at(0.0).speed, 0.0) << name;
    EXPECT_EQ(curve->at(0.0).offset.x, 0.0) << name;
    EXPECT_EQ(curve->at(0.0).offset.z, 0.0) << name;
    if (name == "centre over an arc") continue;
    const Point end = point_of(*curve, curve->at(1.0));
    EXPECT_NEAR(end.x, 3.0, 1e-14) << name;
    EXPECT_NEAR(end.z, 1.0, 1e-14) << name;
  }
}

TEST(PlaneCurve, LeavesItsStartAsWanted) {
  const Point a{0.5, -0.25}, b{3.0, 1.0};
  EXPECT_NEAR(parabola(a, b, 0.9)->at(0.0).beta, 0.9, 1e-15);
  EXPECT_NEAR(parabola(a, b, kVertical)->at(0.0).beta, kVertical, 1e-15);
  EXPECT_NEAR(circular_arc(a, b, 1.2)->at(0.0).beta, 1.2, 1e-15);
  EXPECT_NEAR(cycloid_curve(a, b)->at(0.0).beta, kVertical, 1e-15);
}

TEST(PlaneCurve, ThatCannotBeIsRefused) {
  const Point a{0.0, 0.0};
  EXPECT_THROW((void)parabola(a, {1.0, -1.0}, kVertical),
               std::invalid_argument);
  EXPECT_THROW((void)parabola(a, {1.0, 1.0}, 2.0), std::invalid_argument);
  EXPECT_THROW((void)circular_arc(a, {-1.0, 0.0}, 0.0), std::invalid_argument);
  EXPECT_THROW((void)circular_arc(a, a, 0.0), std::invalid_argument);
  EXPECT_THROW((void)cycloid_curve(a, {1.0, -1.0}), std::invalid_argument);
  EXPECT_THROW((void)spline_through({a}), std::invalid_argument);
  EXPECT_THROW((void)spline_through({a, a}), std::invalid_argument);
}

TEST(Pace, IsThatOfThePlace) {
  const std::vector<Point> points{
      {0.0, 0.0}, {0.5, 0.9}, {1.0, 0.8}, {2.0, 1.0}};
  const std::vector<PlaneCurvePtr> curves{
      spline_through(points), parabola({0.0, 0.0}, {2.0, 1.0}, 1.0),
      centre_path_over(spline_through(points), 0.05),
      curve_from_rest({0.0, 0.0}, {{0.5, 1.5}, {}}, {0.4, 0.7, 1.0},
                      {{0.1, 0.3}, {0.5, 0.7}, {1.0, 1.0}}),
      curve_of_slopes({0.0, 0.0}, {2.0, {0.0, 0.5, 1.0}, {1.5, 0.2, -0.1}})};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const double q : {1e-6, 0.1, 0.5, 0.77, 1.0}) {
      const CurvePlace place = curves[i]->at(q);

      const PlaneCurve::Pace pace = curves[i]->pace(q);

      EXPECT_EQ(pace.speed, place.speed) << i << " " << q;
      EXPECT_EQ(pace.turning, place.turning) << i << " " << q;
    }
  }
}

TEST(Spline, NeedsPointsThatTheLengthTellsApart) {
  EXPECT_THROW(static_cast<void>(spline_through(
                   {{0.0, 0.0}, {1.0, 1.0}, {1.0, 1.0 + 2e-16}, {2.0, 1.0}})),
               std::invalid_argument);
}

}  // namespace
}  // namespace brachisto
