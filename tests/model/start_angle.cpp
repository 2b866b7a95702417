// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/start_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_points.hpp"
#include "support/reference_values.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

double degrees(double radians) {
  return radians * 180.0 / kPi;
}

/// a²/A, twice g times the rate v_c²/s at which a body leaves its rest in the
/// direction β; nothing where it does not (a ≤ 0).
double initial_gain(const Body& body, double beta) {
  const double a = std::sin(beta) + body.eta_m * std::cos(body.theta_m);
  const double A = 1.0 + body.eta_m * body.eta_m + body.k -
                   2.0 * body.eta_m * std::sin(body.theta_m - beta);
  return a > 0.0 ? a * a / A : 0.0;
}

TEST(StartAngle, IsVerticalForCentredBodies) {
  EXPECT_EQ(start_angle(Body::bead()), 0.5 * kPi);
  EXPECT_EQ(start_angle(Body::cylinder(0.5, 0.0, 1.2, 0.5)), 0.5 * kPi);
}

TEST(StartAngle, IsVerticalWhenTheMassStartsLevelWithTheCentre) {
  for (const double eta : {0.1, 0.5, 0.99}) {
    for (const double k : {0.0, 0.01}) {
      EXPECT_EQ(start_angle(Body::cylinder(0.5, eta, 0.0, k)), 0.5 * kPi);
      // Behind the centre it does too, but for the rounding of π: cos θ_m and
      // sin θ_m enter the equation, whose slope −(A + a η) there is of order
      // one for a body that is not all rim.
      EXPECT_NEAR(start_angle(Body::cylinder(0.5, 0.5, kPi, 0.3)), 0.5 * kPi,
                  ulps(8.0));
    }
  }
}

TEST(StartAngle, OfTheBaseCylinderHasItsKnownValues) {
  constexpr double kHalfDigit = 0.0005;  // [deg]

  EXPECT_NEAR(degrees(start_angle(off_centred_scene(-kPi / 6.0).body)), 104.418,
              kHalfDigit);
  EXPECT_NEAR(degrees(start_angle(off_centred_scene(kPi / 6.0).body)), 75.582,
              kHalfDigit);
}

TEST(StartAngle, AgreesWithTheReferenceValues) {
  // Printed with 13 digits, so right to one unit of the last.
  constexpr double kLastDigit = 1e-12;
  for (const ReferenceValue& row : kReferenceValues) {
    EXPECT_NEAR(start_angle(row.scene().body), row.start_angle, kLastDigit)
        << row.name;
  }
}

TEST(StartAngle, MaximisesTheInitialGainOfSpeedOverAllDirections) {
  constexpr std::uint32_t kSeed = 3;
  constexpr int kDirections = 3600;
  Random random(kSeed);
  for (int sample = 0; sample < 300; ++sample) {
    const Body body = random_cylinder(random);
    double best_gain = 0.0;
    double best_beta = 0.0;
    for (int i = 0; i < kDirections; ++i) {
      const double beta = -kPi + 2.0 * kPi * i / kDirections;
      const double gain = initial_gain(body, beta);
      if (gain > best_gain) {
        best_gain = gain;
        best_beta = beta;
      }
    }

    const double beta_0 = start_angle(body);

    EXPECT_GE(initial_gain(body, beta_0), best_gain * (1.0 - ulps(64.0)))
        << "seed " << kSeed << " sample " << sample << " η " << body.eta_m
        << " θ_m " << body.theta_m << " k " << body.k << " best β "
        << best_beta;
  }
}

TEST(StartAngle, IsStationary) {
  constexpr std::uint32_t kSeed = 4;
  Random random(kSeed);
  for (int sample = 0; sample < 300; ++sample) {
    const Body body = random_cylinder(random);

    const Wide beta = start_angle(body);

    // A cos β = a η cos(θ_m − β), both sides sums of terms below 4; the root is
    // found to the last bits of β ≤ 3π/2, times a slope of the equation that
    // is below 8.
    const Wide eta = body.eta_m;
    const Wide A = 1 + eta * eta + body.k - 2 * eta * sin(body.theta_m - beta);
    const Wide a = sin(beta) + eta * cos(Wide(body.theta_m));
    const Wide residual = A * cos(beta) - a * eta * cos(body.theta_m - beta);
    EXPECT_LE(abs(residual), ulps(8.0, 4.0))
        << "seed " << kSeed << " sample " << sample << " η " << body.eta_m
        << " θ_m " << body.theta_m << " k " << body.k;
  }
}

TEST(StartAngle, IsMirroredByTheSignOfThetaM) {
  constexpr std::uint32_t kSeed = 5;
  Random random(kSeed);
  for (int sample = 0; sample < 100; ++sample) {
    // η away from 1, where the maximum is sharp and well conditioned.
    Body body = random_cylinder(random, 0.8);
    const double right = start_angle(body);
    body.theta_m = -body.theta_m;

    const double left = start_angle(body);

    EXPECT_NEAR(left, kPi - right, ulps(64.0))
        << "seed " << kSeed << " sample " << sample;
  }
}

TEST(StartAngle, IsFoundForAllButOneOfAllMassOnTheRim) {
  // As η → 1 and k → 0, a²/A → cos²((β − π/2 + θ_m)/2), largest at
  // β = π/2 − θ_m if a > 0 there, which is where cos θ_m > 0, and otherwise at
  // the end of the arc of a > 0, where the mass point touches the track,
  // β = θ_m − π/2. The next terms are of order 1 − η.
  for (const double missing : {1e-8, 1e-12, std::ldexp(1.0, -53)}) {
    for (const double theta_m : {-2.5, -kPi / 6.0, 0.3, 1.2, 3.0}) {
      const Body body = Body::cylinder(0.5, 1.0 - missing, theta_m, 0.0);

      const double beta = start_angle(body);

      const double limit =
          std::cos(theta_m) > 0.0 ? 0.5 * kPi - theta_m : theta_m - 0.5 * kPi;
      // √ of rounding, for the gain is flat at its maximum and A all but
      // vanishes elsewhere.
      EXPECT_NEAR(std::remainder(beta - limit, 2.0 * kPi), 0.0, 1e-7)
          << missing << " " << theta_m;
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
