// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The discrete system against eqs. (1), (7) and (13)–(19) written out plainly.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/cycloid.hpp"
#include "paper/discrete_paths.hpp"

namespace brachisto {
namespace {

using testing::discrete_cases;
using testing::DiscreteCase;
using testing::kDiscreteNodes;
using Path = std::vector<double>;

constexpr double kRounding = std::numeric_limits<double>::epsilon();

/// T of (x_j, z_j) in units of H with 2 g = 1, every chord anew.
double plain_time(const Body& body, const DiscreteReading& reading,
                  const Path& x, const Path& z) {
  using Datum = DiscreteReading::Datum;
  using Quadrature = DiscreteReading::Quadrature;
  const double eta = body.eta_m;
  const double r = body.radius;
  const double z_0 = reading.datum == Datum::Release ? z[0] : 0.0;
  const auto E = [&](double height, double theta) {
    return height - z_0 + r * eta * (std::sin(theta) - std::sin(body.theta_m));
  };
  double theta = body.theta_m;
  double T = 0.0;
  for (std::size_t j = 1; j < x.size(); ++j) {
    const double l = std::hypot(x[j] - x[j - 1], z[j] - z[j - 1]);
    const double beta = std::atan2(z[j] - z[j - 1], x[j] - x[j - 1]);
    const double theta_j = body.rolls() ? theta + l / r : theta;
    const auto v = [&](double height, double angle) {
      return std::sqrt(E(height, angle) / (1.0 + eta * eta + body.k -
                                           2.0 * eta * std::sin(angle - beta)));
    };
    const bool rests = j == 1 && reading.datum != Datum::Printed;
    const double left = rests ? 0.0 : v(z[j - 1], theta);
    const double right = v(z[j], theta_j);
    const double middle = v(0.5 * (z[j - 1] + z[j]), 0.5 * (theta + theta_j));
    switch (reading.quadrature) {
      case Quadrature::MeanSpeed:
        T += 2.0 * l / (left + right);
        break;
      case Quadrature::Midpoint:
        T += l / middle;
        break;
      case Quadrature::Trapezoid:
        T += rests ? 2.0 * l / right : 0.5 * (l / left + l / right);
        break;
    }
    theta = theta_j;
  }
  return T;
}

struct Plain {
  Body body;
  double r, L;
  Path x, z;
  double S;
};

/// Everything in units of H.
Plain plain(const DiscreteCase& one, const std::vector<double>& u) {
  const double H = one.scene.H;
  Plain p{one.scene.body, 0.0, one.scene.L / H, {}, {}, u.back()};
  p.body.radius /= H;
  if (one.scene.contact == Contact::Smooth) p.r = p.body.radius;
  p.x.assign(u.begin(), u.begin() + kDiscreteNodes);
  p.z.assign(u.begin() + kDiscreteNodes, u.begin() + 2 * kDiscreteNodes);
  return p;
}

TEST(DiscreteSystem, IsThatOfThePaper) {
  for (const DiscreteCase& one : discrete_cases()) {
    const DiscreteVariations system(one.scene, kDiscreteNodes, one.reading);
    const std::vector<double> u = testing::shaken(system, 1);
    std::vector<double> F(u.size());

    ASSERT_TRUE(system.residual(u, F)) << one.name << ": " << system.refusal(u);

    Plain p = plain(one, u);
    const std::size_t n = kDiscreteNodes;
    const double T = plain_time(p.body, one.reading, p.x, p.z);
    // Some ten roundings per chord.
    const double rounding = 10.0 * n * kRounding;
    EXPECT_NEAR(system.tau(u), T, rounding * T) << one.name;
    const double z_A = (p.z[1] - p.z[0]) / (p.x[1] - p.x[0]);
    const double z_B = (p.z[n - 1] - p.z[n - 2]) / (p.x[n - 1] - p.x[n - 2]);
    const auto sine = [](double slope) {
      return slope / std::sqrt(1.0 + slope * slope);
    };
    // The slope of the nearly vertical first chord is a quotient with a small
    // denominator, whose relative error is that of Δx.
    const double steep = kRounding * std::abs(z_A) * 10.0;
    ASSERT_GT(p.x[1], p.x[0]) << "else smooth and literal slopes differ";
    EXPECT_NEAR(F[0], p.x[0] - p.r * sine(z_A), steep) << one.name;
    EXPECT_NEAR(F[n], p.z[0] + p.r / std::sqrt(1.0 + z_A * z_A), steep)
        << one.name;
    EXPECT_NEAR(F[2 * n], p.x[n - 1] - p.r * sine(z_B) - p.L, rounding)
        << one.name;
    EXPECT_NEAR(F[2 * n - 1],
                p.z[n - 1] + p.r / std::sqrt(1.0 + z_B * z_B) - 1.0, rounding)
        << one.name;
    for (std::size_t j = 1; j < n; ++j) {
      EXPECT_NEAR(F[j],
                  std::hypot(p.x[j] - p.x[j - 1], p.z[j] - p.z[j - 1]) -
                      p.S / (kDiscreteNodes - 1),
                  rounding)
          << one.name << " chord " << j;
    }
    const double epsilon = one.reading.epsilon;
    for (std::size_t j = 1; j + 1 < n; ++j) {
      Path above = p.z;
      Path below = p.z;
      above[j] -= epsilon;
      below[j] += epsilon;
      const double difference = (plain_time(p.body, one.reading, p.x, below) -
                                 plain_time(p.body, one.reading, p.x, above)) /
                                (2.0 * epsilon);
      EXPECT_NEAR(F[n + j], difference, rounding * T / epsilon)
          << one.name << " node " << j;
    }
  }
}

TEST(DiscreteSystem, BackwardsStartsAreWhereReadingsOfSlopesDiffer) {
  // z' = Δz/Δx as printed turns round with Δx.
  const Scene scene = testing::off_centred_scene();
  DiscreteReading literal;
  DiscreteReading smooth;
  smooth.slopes = DiscreteReading::Slopes::Smooth;
  const DiscreteVariations printed(scene, kDiscreteNodes, literal);
  const DiscreteVariations continuous(scene, kDiscreteNodes, smooth);
  std::vector<double> u = printed.cycloid_guess().value();
  const double r = scene.body.radius;
  u[1] = u[0] - 1e-9;
  std::vector<double> F(u.size()), G(u.size());

  ASSERT_TRUE(printed.residual(u, F));
  ASSERT_TRUE(continuous.residual(u, G));

  // sin β ≈ 1 against z'/√(1 + z'²) ≈ −1.
  EXPECT_NEAR(F[0] - G[0], 2.0 * r, 1e-6);
}

TEST(DiscreteSystem, StartsFromTheCycloidAtEqualArcLengths) {
  constexpr int kFine = 400;
  const Scene scene = testing::uniform_scene();
  const DiscreteVariations system(scene, kFine, DiscreteReading{});

  const std::vector<double> u = system.cycloid_guess().value();

  std::vector<double> F(u.size());
  ASSERT_TRUE(system.residual(u, F));
  // A chord is shorter than its arc, of curvature radius ρ = √(8 a s) next to
  // the cusp, by l³/24 ρ²: most for the first arc, for which expansion about
  // the cusp gives l²/72 a. The next term is smaller by l/a.
  const double l = u.back() / (kFine - 1);
  const double a = axisymmetric_optimum(scene).value().a;
  for (std::size_t j = 1; j < kFine; ++j) {
    EXPECT_LE(F[j], 1e-15) << j;
    EXPECT_GE(F[j], -l * l / (72.0 * a) * (1.0 + l / a)) << j;
  }
}

TEST(DiscreteSystem, RefusesWhatIsNoSystem) {
  const Scene scene = testing::off_centred_scene();
  DiscreteReading backwards;
  backwards.epsilon = -1.0;

  EXPECT_THROW(DiscreteVariations(scene, 2, {}), std::invalid_argument);
  EXPECT_THROW(DiscreteVariations(scene, 10, backwards), std::invalid_argument);
}

}  // namespace
}  // namespace brachisto
