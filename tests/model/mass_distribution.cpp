// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "support/numbers.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"

namespace brachisto {
namespace {

using testing::kPi;
using testing::Random;
using testing::ulps;
using testing::Wide;

Point polar(double distance, double angle) {
  return {distance * std::cos(angle), distance * std::sin(angle)};
}

MassProperties of(const std::vector<MassPart>& parts, double radius = 1.0) {
  return mass_properties(parts, radius);
}

/// A part of any kind within the cylinder of radius 1.
MassPart random_part(Random& random) {
  const double mass = std::exp(random.uniform(-6.0, 6.0));
  const double far = random.uniform(0.0, 1.0);
  const Point at = polar(far, random.uniform(-kPi, kPi));
  const double room = (1.0 - far) * random.uniform(0.05, 1.0);
  switch (static_cast<int>(random.uniform(0.0, 4.0))) {
    case 0:
      return MassPart::point(mass, at);
    case 1:
      return MassPart::ring(mass, at, room);
    case 2:
      return MassPart::disc(mass, at, room, random.uniform(0.0, 0.99) * room);
    default:
      return MassPart::rod(
          mass, at, polar(random.uniform(0.0, 1.0), random.uniform(-kPi, kPi)));
  }
}

std::vector<MassPart> random_parts(Random& random) {
  std::vector<MassPart> parts;
  const int count = static_cast<int>(random.uniform(1.0, 8.0));
  for (int i = 0; i < count; ++i) parts.push_back(random_part(random));
  return parts;
}

// Closed forms. A handful of roundings each, none larger than 1.
const double kClosedFormRounding = ulps(8.0);

TEST(MassProperties, OfADiscARingAndARodAreThoseOfTextbooks) {
  const double r = 0.077;
  EXPECT_NEAR(of({MassPart::disc(3.0, {}, r)}, r).k, 0.5, kClosedFormRounding);
  EXPECT_NEAR(of({MassPart::ring(3.0, {}, r)}, r).k, 1.0, kClosedFormRounding);
  EXPECT_NEAR(of({MassPart::rod(3.0, {-r, 0}, {r, 0})}, r).k, 1.0 / 3.0,
              kClosedFormRounding);
  EXPECT_NEAR(of({MassPart::disc(1.0, {}, r, 0.5 * r)}, r).k, 0.625,
              kClosedFormRounding);
}

TEST(MassProperties, OfARingWithAMassOnTheRimReachTheLargestK) {
  const double angle = -kPi / 6.0;

  const MassProperties found = of(
      {MassPart::ring(2.0, {}, 1.0), MassPart::point(1.0, polar(1.0, angle))});

  EXPECT_EQ(found.mass, 3.0);
  EXPECT_NEAR(found.eta_m, 1.0 / 3.0, kClosedFormRounding);
  EXPECT_NEAR(found.theta_m, angle, kClosedFormRounding);
  EXPECT_NEAR(found.k, 8.0 / 9.0, kClosedFormRounding);
  EXPECT_LE(found.k, found.largest_k());
}

TEST(MassProperties, OfPointsOnAHalfRingApproachThoseOfTheHalfRing) {
  // n points in the middles of n arcs: by the sum of a geometric series
  // η = 1/(n sin(π/2n)), which is 2/π + O(1/n²), and k = 1 − η².
  for (const int n : {2, 10, 1000}) {
    std::vector<MassPart> parts;
    for (int i = 0; i < n; ++i) {
      parts.push_back(MassPart::point(1.0, polar(1.0, (i + 0.5) * kPi / n)));
    }

    const MassProperties found = of(parts);

    const double eta = 1.0 / (n * std::sin(0.5 * kPi / n));
    EXPECT_NEAR(found.eta_m, eta, kClosedFormRounding);
    EXPECT_NEAR(found.theta_m, 0.5 * kPi, kClosedFormRounding);
    EXPECT_NEAR(found.k, 1.0 - eta * eta, 2.0 * kClosedFormRounding);
    EXPECT_NEAR(found.eta_m, 2.0 / kPi, 1.0 / (n * n));
  }
}

TEST(MassProperties, MeasureTheAngleDownwards) {
  EXPECT_NEAR(of({MassPart::point(1.0, {0.0, 0.5})}).theta_m, 0.5 * kPi,
              kClosedFormRounding);
}

TEST(MassProperties, OfOpposedMassesHaveNoOffset) {
  for (const double angle : {0.1, 0.7, 2.0, -3.0}) {
    const MassProperties found =
        of({MassPart::point(1.0, polar(1.0, angle)),
            MassPart::point(1.0, polar(1.0, angle + kPi))});

    EXPECT_EQ(found.eta_m, 0.0);
    EXPECT_EQ(found.theta_m, 0.0);
    EXPECT_EQ(found.k, 1.0);
  }
}

TEST(MassProperties, OfARodThroughTheAxisHaveNoOffset) {
  const double angle = 0.3;
  EXPECT_EQ(of({MassPart::rod(1.0, polar(1.0, angle), polar(1.0, angle + kPi)),
                MassPart::disc(3.0, {}, 1.0)})
                .eta_m,
            0.0);
}

TEST(MassProperties, KeepTheBoundOnK) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const MassProperties found = of(random_parts(random));
    EXPECT_GE(found.k, 0.0);
    EXPECT_LE(found.k, found.largest_k());
    EXPECT_LE(found.eta_m, 1.0);
  }
}

TEST(MassProperties, ReachTheBoundIffAllMassIsOnTheRim) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    std::vector<MassPart> parts{MassPart::ring(1.0, {}, 1.0)};
    for (int p = 0; p < 4; ++p) {
      parts.push_back(MassPart::point(random.uniform(0.1, 3.0),
                                      polar(1.0, random.uniform(-kPi, kPi))));
    }
    const MassProperties rim = of(parts);
    EXPECT_NEAR(rim.k, rim.largest_k(), kClosedFormRounding);

    // A share s of the mass at half the radius lacks s (1 − 1/4).
    const double mass = random.uniform(0.1, 3.0);
    parts.push_back(MassPart::point(mass, polar(0.5, 1.0)));
    const MassProperties inside = of(parts);
    EXPECT_NEAR(inside.largest_k() - inside.k, 0.75 * mass / inside.mass,
                kClosedFormRounding);
  }
}

TEST(MassProperties, OfAPartMadeOfPartsAreThoseOfAllOfThem) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const std::vector<MassPart> a = random_parts(random);
    std::vector<MassPart> all = random_parts(random);
    std::vector<MassPart> nested = all;
    const MassProperties inner = of(a);
    nested.push_back(
        {inner.mass, polar(inner.r_m, inner.theta_m), inner.k, 1.0});
    all.insert(all.end(), a.begin(), a.end());

    const MassProperties one = of(all), other = of(nested);

    EXPECT_NEAR(one.mass, other.mass, ulps(8.0, one.mass));
    EXPECT_NEAR(one.eta_m, other.eta_m, kClosedFormRounding);
    EXPECT_NEAR(one.k, other.k, 2.0 * kClosedFormRounding);
  }
}

TEST(MassProperties, TurnWithTheBodyAndDoNotDependOnUnits) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const std::vector<MassPart> parts = random_parts(random);
    const double turn = random.uniform(-1.0, 1.0);
    const double unit = random.uniform(0.01, 100.0);
    std::vector<MassPart> turned = parts;
    for (MassPart& part : turned) {
      const auto [x, z] = part.centre;
      part.mass *= unit;
      part.centre = {unit * (x * std::cos(turn) - z * std::sin(turn)),
                     unit * (x * std::sin(turn) + z * std::cos(turn))};
      part.own_inertia *= unit * unit;
      part.reach *= unit;
    }

    const MassProperties one = of(parts), other = of(turned, unit);

    EXPECT_NEAR(one.eta_m, other.eta_m, kClosedFormRounding);
    EXPECT_NEAR(one.k, other.k, 2.0 * kClosedFormRounding);
    // Rounding of places turns a direction the more, the shorter the offset.
    EXPECT_NEAR(std::remainder(other.theta_m - one.theta_m - turn, 2.0 * kPi),
                0.0, kClosedFormRounding * (1.0 + 1.0 / one.eta_m));
  }
}

TEST(MassProperties, DoNotCancel) {
  // k is m₁m₂d²/(m²r²), 19 digits smaller than the moments about the axis.
  const double small = 1e-9, apart = 1e-5;
  const Point a{0.875, 0.0}, b{0.875 + apart, 0.0};

  const double k = of({MassPart::point(1.0, a), MassPart::point(small, b)}).k;

  const Wide m1 = 1.0, m2 = small, d = Wide(b.x) - Wide(a.x);
  const double exact =
      static_cast<double>(m1 * m2 * d * d / ((m1 + m2) * (m1 + m2)));
  // About a point that is off the centre of mass by δ the moment is greater by
  // m δ²: an error of a rounding in x_cm enters as its square.
  const double delta = ulps(1.0);
  EXPECT_NEAR(k, exact, exact * ulps(8.0) + delta * delta);
}

TEST(MassParts, AreRefusedIfTheyAreNone) {
  EXPECT_THROW((void)MassPart::point(0.0, {}), std::invalid_argument);
  EXPECT_THROW((void)MassPart::point(1.0, {NAN, 0.0}), std::invalid_argument);
  EXPECT_THROW((void)MassPart::ring(1.0, {}, -1.0), std::invalid_argument);
  EXPECT_THROW((void)MassPart::disc(1.0, {}, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW((void)MassPart::rod(-1.0, {}, {}), std::invalid_argument);
  EXPECT_THROW((void)of({}), std::invalid_argument);
  EXPECT_THROW((void)of({MassPart::point(1.0, {})}, 0.0),
               std::invalid_argument);
}

TEST(MassParts, BeyondTheCylinderAreRefusedByName) {
  MassPart part = MassPart::disc(1.0, {0.6, 0.0}, 0.5);
  part.name = "the disc";
  try {
    (void)of({MassPart::point(1.0, {}), part});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "the disc: it reaches 1.1 from the axis, beyond the cylinder "
                 "of radius 1; a part lies within");
  }
}

}  // namespace
}  // namespace brachisto
