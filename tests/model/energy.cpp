// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/energy.hpp"

#include <gtest/gtest.h>

#include "brachisto/math/jet.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

/// How far the centre of mass has come down: z + r η sin θ, now minus at the
/// start, exact.
Wide exact_drop(const Body& body, double drop, double theta) {
  const Wide lever = Wide(body.radius) * body.eta_m;
  return drop + lever * (sin(Wide(theta)) - sin(Wide(body.theta_m)));
}

TEST(EnergyHeight, IsTheDropOfTheCentreOfMass) {
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int sample = 0; sample < 1000; ++sample) {
    const Body body = random_cylinder(random);
    const double drop = random.uniform(-2.0, 2.0);
    const double theta = random.uniform(-4.0, 8.0);

    const double E = energy_height(body, drop, theta);

    // Half angles of up to 6 rad, rounded, on a lever r η below 2 and doubled.
    EXPECT_NEAR(E, exact_drop(body, drop, theta).convert_to<double>(),
                ulps(1.0, 2.0 * body.radius * body.eta_m * 8.0) +
                    ulps(1.0, std::abs(E)))
        << "seed " << kSeed << " sample " << sample;
  }
}

TEST(EnergyHeight, KeepsRelativeAccuracyNextToTheStart) {
  // Both terms positive: E loses nothing but the roundings of cos((θ + θ_m)/2)
  // and of six operations.
  for (const double theta_m : {-kPi / 6.0, 0.0, kPi / 6.0, 1.0}) {
    const Body body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, theta_m, 0.5);
    for (double s = 1e-15; s < 0.1; s *= 7.0) {
      const double theta = theta_m + s / body.radius;
      const double drop = 0.9 * s;
      const Wide exact = exact_drop(body, drop, theta);

      const double E = energy_height(body, drop, theta);

      EXPECT_LE(abs(E / exact - 1), ulps(8.0))
          << "θ_m " << theta_m << " s " << s;
    }
  }
}

TEST(EnergyHeight, VanishesAtTheStart) {
  const Body body = Body::cylinder(0.4, 0.7, -1.3, 0.2);

  EXPECT_EQ(energy_height(body, 0.0, body.theta_m), 0.0);
}

TEST(EnergyHeight, FollowsFromTheSinesToo) {
  const Body body = Body::cylinder(0.4, 0.7, -1.3, 0.2);
  for (const double theta : {-1.3, 0.0, 2.0, 40.0}) {
    EXPECT_NEAR(energy_height_from_sines(body, 0.25, std::sin(theta),
                                         std::sin(body.theta_m)),
                energy_height(body, 0.25, theta), ulps(8.0))
        << theta;
  }
}

TEST(EnergySlope, IsTheSlopeOfTheEnergyHeightAlongThePath) {
  using Jet = math::Jet2<double, 1>;
  const Body body = Body::cylinder(0.4, 0.7, -1.3, 0.2);
  const double beta = 0.8, s = 0.35;

  // On a straight path with slope angle β: z − z_0 = s sin β, θ = θ_m + s/r.
  const Jet along = Jet::variable(s, 0);
  const Jet theta = along * (1.0 / body.radius) + body.theta_m;
  const Jet E = energy_height(body, along * std::sin(beta), theta);

  EXPECT_NEAR(energy_slope(body, theta.value, beta), E.gradient[0], ulps(8.0));
}

TEST(FallSpeed, IsThatOfFreeFall) {
  // From 4.905 m at 9.81 m/s²: after one second, at 9.81 m/s.
  EXPECT_DOUBLE_EQ(fall_speed(9.81, 4.905), 9.81);
}

}  // namespace
}  // namespace brachisto::testing
