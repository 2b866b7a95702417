// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/inertia.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/math/jet.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

/// A as the paper has it, 1 + η² + k − 2 η sin(θ − β), exact.
Wide exact_inertia_factor(const Body& body, double theta, double beta) {
  const Wide eta = body.eta_m;
  return 1 + eta * eta + body.k - 2 * eta * sin(Wide(theta) - beta);
}

/// Bound on the error of (1 − η)² + k + 2 η d², d = cos δ/2 − sin δ/2: the
/// rounding of δ, of its sine and cosine and of their difference moves d by no
/// more than ε (2 + |δ|), which A sees as 4 η |d| ε (2 + |δ|); sums, squares
/// and products of positive terms add 4 ε A.
double rounding_bound(const Body& body, double theta, double beta) {
  const double delta = theta - beta;
  const double d = std::cos(0.5 * delta) - std::sin(0.5 * delta);
  return ulps(1.0, 4.0 * body.eta_m * std::abs(d) * (2.0 + std::abs(delta))) +
         ulps(4.0, inertia_factor(body, theta, beta));
}

void expect_accurate(const Body& body, double theta, double beta) {
  const Wide exact = exact_inertia_factor(body, theta, beta);

  const double error =
      abs(inertia_factor(body, theta, beta) - exact).convert_to<double>();

  EXPECT_LE(error, rounding_bound(body, theta, beta))
      << "η " << body.eta_m << " k " << body.k << " θ " << theta << " β "
      << beta;
}

TEST(InertiaFactor, IsThePapersFormulaToRounding) {
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int sample = 0; sample < 2000; ++sample) {
    SCOPED_TRACE(::testing::Message()
                 << "seed " << kSeed << " sample " << sample);
    const Body body = random_cylinder(random, 1.0);

    expect_accurate(body, random.uniform(-7.0, 7.0), random.uniform(-3.0, 3.0));
  }
}

TEST(InertiaFactor, KeepsRelativeAccuracyWhereItNearlyVanishes) {
  // The mass close to the rim and next to the track, which it touches at
  // δ = π/2.
  for (const auto& [eta, k] :
       {std::pair{0.99, 0.01}, {0.9999, 1e-4}, {0.9999, 0.0}}) {
    const Body body = Body::cylinder(0.5, eta, 0.0, k);
    for (double gap = 1e-16; gap < 0.2; gap *= 3.0) {
      for (const double beta : {0.0, 0.3, -1.2}) {
        expect_accurate(body, beta + 0.5 * kPi + gap, beta);
        expect_accurate(body, beta + 0.5 * kPi - gap, beta);
      }
    }
    const double at_the_track = inertia_factor(body, 0.5 * kPi, 0.0);
    const Wide exact = exact_inertia_factor(body, 0.5 * kPi, 0.0);
    // There d vanishes, and only the 4 ε A of the bound are left.
    EXPECT_LE(abs(at_the_track / exact - 1), ulps(4.0)) << "η " << eta;
  }
}

TEST(InertiaFactor, IsTwiceTheKineticEnergyAtUnitSpeedOfTheCentre) {
  constexpr std::uint32_t kSeed = 2;
  Random random(kSeed);
  for (int sample = 0; sample < 100; ++sample) {
    const Body body = random_cylinder(random);
    const double theta = random.uniform(-4.0, 4.0);
    const double beta = random.uniform(-3.0, 3.0);
    // With v_c = 1 the body turns at ω = 1/r, and the centre of mass, at
    // r η (cos θ, sin θ) from the centre, moves with v_c t + ω r η (−sin θ,
    // cos θ); the energies are v_cm²/2 and k r² ω²/2 per mass.
    const double v_x = std::cos(beta) - body.eta_m * std::sin(theta);
    const double v_z = std::sin(beta) + body.eta_m * std::cos(theta);
    const double twice_energy = v_x * v_x + v_z * v_z + body.k;

    EXPECT_NEAR(inertia_factor(body, theta, beta), twice_energy, ulps(32.0))
        << "seed " << kSeed << " sample " << sample;
  }
}

TEST(InertiaFactor, IsOnePlusKForACentredBody) {
  const Body uniform = Body::cylinder(0.5, 0.0, 1.0, 0.5);

  EXPECT_EQ(inertia_factor(uniform, 0.3, -0.7), 1.5);
  EXPECT_EQ(axisymmetric_inertia_factor(uniform), 1.5);
  EXPECT_EQ(axisymmetric_inertia_factor(Body::bead()), 1.0);
}

TEST(InertiaFactor, FollowsFromTheSineToo) {
  // A ≥ (1 − η)² + k = 0.36 here: no cancellation to speak of.
  const Body body = Body::cylinder(0.5, 0.6, 0.0, 0.2);
  for (const double delta : {-2.0, 0.0, 0.5 * kPi, 3.0}) {
    EXPECT_NEAR(inertia_factor(body, std::sin(delta)),
                inertia_factor(body, delta, 0.0), ulps(16.0))
        << delta;
  }
}

TEST(InertiaFactor, CarriesJets) {
  using Jet = math::Jet2<double, 2>;
  const Body body = Body::cylinder(0.5, 0.6, 0.0, 0.4);
  const double theta = 0.4, beta = -0.9;

  const Jet A =
      inertia_factor(body, Jet::variable(theta, 0), Jet::variable(beta, 1));

  // Derivatives of the paper's formula.
  const double cosine = 1.2 * std::cos(theta - beta);
  const double sine = 1.2 * std::sin(theta - beta);
  EXPECT_NEAR(A.gradient[0], -cosine, ulps(16.0));
  EXPECT_NEAR(A.gradient[1], cosine, ulps(16.0));
  EXPECT_NEAR(A.hessian[Jet::pair(0, 0)], sine, ulps(16.0));
  EXPECT_NEAR(A.hessian[Jet::pair(1, 0)], -sine, ulps(16.0));
  EXPECT_NEAR(A.hessian[Jet::pair(1, 1)], sine, ulps(16.0));
}

}  // namespace
}  // namespace brachisto::testing
