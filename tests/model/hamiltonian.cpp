// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/hamiltonian.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "brachisto/math/jet.hpp"
#include "model/cycloid.hpp"
#include "support/observed_order.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

using SlopeJet = math::Jet2<double, 1>;

/// 𝓗 written out as √A + p·f, A as in the paper.
template <class Scalar>
Scalar literal_hamiltonian(const Body& body, double gravity,
                           const RollingState& state, const Costates& p,
                           const Scalar& beta) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const double eta = body.eta_m;
  const Scalar A =
      1.0 + eta * eta + body.k - 2.0 * eta * sin(state.theta - beta);
  Scalar h = sqrt(A) + p.p_x * state.w * cos(beta) +
             p.p_z * state.w * sin(beta) +
             p.p_w * gravity * (sin(beta) + eta * std::cos(state.theta));
  if (body.rolls()) h += p.p_theta * state.w / body.radius;
  return h;
}

/// A moving body somewhere, with costates of order one; k ≥ 0.05 keeps A away
/// from zero, so that derivatives of √A are below 20.
struct CostateSample {
  Body body;
  double gravity;
  RollingState state;
  Costates p;
};

CostateSample random_costate_sample(Random& random) {
  CostateSample sample;
  sample.body = random_cylinder(random, 0.9);
  sample.body.k = std::max(sample.body.k, 0.05);
  sample.gravity = random.uniform(0.5, 2.0);
  sample.state = {random.uniform(-2.0, 6.0), random.uniform(0.1, 2.0)};
  sample.p = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
              random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  return sample;
}

TEST(SlopeHamiltonian, HasTheDerivativesThatJetsHave) {
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const CostateSample s = random_costate_sample(random);
    const double beta = random.uniform(-kPi, kPi);

    const SlopeHamiltonian h =
        slope_hamiltonian(s.body, s.gravity, s.state, s.p, beta);

    const SlopeJet exact = literal_hamiltonian(s.body, s.gravity, s.state, s.p,
                                               SlopeJet::variable(beta, 0));
    // Terms below 20, a rounding of A enters the second derivative as
    // 3/(4 A^{5/2}) η² < 20 at worst where A is smallest, 0.06.
    EXPECT_NEAR(h.d_beta, exact.gradient[0], ulps(32.0, 20.0))
        << "seed " << kSeed << " sample " << i;
    EXPECT_NEAR(h.d2_beta, exact.hessian[0], ulps(32.0, 400.0))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(Hamiltonian, IsTheRootOfAPlusTheCostatesTimesTheRates) {
  constexpr std::uint32_t kSeed = 2;
  Random random(kSeed);
  for (int i = 0; i < 500; ++i) {
    CostateSample s = random_costate_sample(random);
    if (i % 5 == 0) s.body = Body::bead();
    const double beta = random.uniform(-kPi, kPi);

    const double h = hamiltonian(s.body, s.gravity, s.state, s.p, beta);

    // Six terms, the largest w p_θ/r below 20.
    EXPECT_NEAR(h, literal_hamiltonian(s.body, s.gravity, s.state, s.p, beta),
                ulps(16.0, 20.0))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(MinimisingSlope, OfACentredBodyPointsAgainstThePullOfTheCostates) {
  // h = √A + P cos β + Q sin β is least at atan2(−Q, −P), and there is one
  // minimum per turn.
  constexpr std::uint32_t kSeed = 3;
  Random random(kSeed);
  for (int i = 0; i < 200; ++i) {
    CostateSample s = random_costate_sample(random);
    s.body.eta_m = 0.0;
    const double P = s.state.w * s.p.p_x;
    const double Q = s.state.w * s.p.p_z + s.gravity * s.p.p_w;
    const double minimum = std::atan2(-Q, -P);
    for (const double away : {-3.1, -1.5, -0.01, 0.0, 0.4, 2.0, 3.1}) {
      const double beta =
          minimising_slope(s.body, s.gravity, s.state, s.p, minimum + away);

      // The pulls round like their terms, and turn the direction by that over
      // the length of (P, Q).
      EXPECT_NEAR(beta, minimum, ulps(16.0, 1.0 + 4.0 / std::hypot(P, Q)))
          << "seed " << kSeed << " sample " << i << " started " << away
          << " away";
    }
  }
}

TEST(MinimisingSlope, FindsTheMinimumOfTheValleyItStartsIn) {
  constexpr std::uint32_t kSeed = 4;
  constexpr int kDirections = 2000;
  Random random(kSeed);
  for (int i = 0; i < 100; ++i) {
    const CostateSample s = random_costate_sample(random);
    const auto h = [&](double beta) {
      return literal_hamiltonian(s.body, s.gravity, s.state, s.p, beta);
    };
    double best = 0.0;
    for (int d = 0; d < kDirections; ++d) {
      const double beta = 2.0 * kPi * d / kDirections;
      if (h(beta) < h(best)) best = beta;
    }

    const double beta = minimising_slope(s.body, s.gravity, s.state, s.p, best);

    EXPECT_NEAR(beta, best, 2.0 * kPi / kDirections)
        << "seed " << kSeed << " sample " << i;
    EXPECT_LE(h(beta), h(best) + ulps(16.0, 20.0));
    EXPECT_GT(slope_hamiltonian(s.body, s.gravity, s.state, s.p, beta).d2_beta,
              0.0);
  }
}

TEST(MinimisingSlope, IsNotANumberWithoutOne) {
  const Body body = Body::cylinder(0.5, 0.0, 0.0, 0.5);
  const double nan = std::nan("");

  // Without any pull 𝓗 does not depend on β at all.
  EXPECT_TRUE(std::isnan(minimising_slope(body, 1.0, {0.0, 1.0}, {}, 0.3)));
  EXPECT_TRUE(
      std::isnan(minimising_slope(body, 1.0, {0.0, 1.0}, {.p_x = nan}, 0.3)));
}

/// 𝓗 over directions: 64 of them and a thousand between each pair.
struct BruteForce {
  double minimum, minimiser;
  /// By how much the least of 64 directions may exceed the minimum, by Taylor
  /// from there: half the distance of two, squared, times half of 𝓗''.
  double resolution;
};

BruteForce brute_force(const CostateSample& s) {
  constexpr int kDirections = 64 * 1000;
  BruteForce out{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  double steepest = 0.0;
  for (int d = 0; d < kDirections; ++d) {
    const double beta = 2.0 * kPi * d / kDirections;
    const SlopeJet h = literal_hamiltonian(s.body, s.gravity, s.state, s.p,
                                           SlopeJet::variable(beta, 0));
    if (h.value < out.minimum) {
      out.minimum = h.value;
      out.minimiser = beta;
    }
    steepest = std::max(steepest, std::abs(h.hessian[0]));
  }
  const double off = kPi / 64.0;
  out.resolution = 0.5 * steepest * off * off;
  return out;
}

double root_of_A(const CostateSample& s, double beta) {
  const double eta = s.body.eta_m;
  return std::sqrt(1.0 + eta * eta + s.body.k -
                   2.0 * eta * std::sin(s.state.theta - beta));
}

TEST(GainOfOtherDirections, IsNoneAtTheGlobalMinimum) {
  constexpr std::uint32_t kSeed = 7;
  Random random(kSeed);
  for (int i = 0; i < 30; ++i) {
    const CostateSample s = random_costate_sample(random);
    const BruteForce best = brute_force(s);

    const double gain = gain_of_other_directions(s.body, s.gravity, s.state,
                                                 s.p, best.minimiser);

    EXPECT_GE(gain, 0.0) << "seed " << kSeed << " sample " << i;
    // The 64 are among those tried; h is below 20.
    EXPECT_LE(gain, ulps(16.0, 20.0) / root_of_A(s, best.minimiser))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(GainOfOtherDirections, IsWhatTheBestOfThemSaves) {
  constexpr std::uint32_t kSeed = 8;
  Random random(kSeed);
  int positive = 0;
  int beyond_a_local_minimum = 0;
  for (int i = 0; i < 60; ++i) {
    const CostateSample s = random_costate_sample(random);
    const BruteForce best = brute_force(s);
    const auto h = [&](double beta) {
      return literal_hamiltonian(s.body, s.gravity, s.state, s.p, beta);
    };
    for (int d = 0; d < 12; ++d) {
      double beta = random.uniform(-7.0, 7.0);
      if (d == 0) {
        // A minimum, if not the global one, is as wrong as any other slope.
        beta = minimising_slope(s.body, s.gravity, s.state, s.p, beta);
        if (std::isnan(beta)) continue;
        if (h(beta) > best.minimum + best.resolution) ++beyond_a_local_minimum;
      }
      const double root = root_of_A(s, beta);
      const double expected = (h(beta) - best.minimum) / root;

      const double gain =
          gain_of_other_directions(s.body, s.gravity, s.state, s.p, beta);

      EXPECT_GE(gain, expected - best.resolution / root)
          << "seed " << kSeed << " sample " << i << " β " << beta;
      // No more than all directions; the finest of them are 1e-4 rad apart,
      // 1e-6 of the resolution of 64.
      EXPECT_LE(gain, std::max(0.0, expected) +
                          (1e-6 * best.resolution + ulps(16.0, 20.0)) / root)
          << "seed " << kSeed << " sample " << i << " β " << beta;
      if (expected > best.resolution / root) {
        EXPECT_GT(gain, 0.0);
        ++positive;
      }
    }
  }
  EXPECT_GE(positive, 300);
  EXPECT_GE(beyond_a_local_minimum, 1);
}

TEST(GainOfOtherDirections, IsNotANumberIfAnythingInItIsNone) {
  const double nan = std::nan("");
  const Body body = Body::cylinder(0.5, 0.3, 0.0, 0.5);
  const RollingState state{0.4, 1.0};
  const Costates p{.p_x = -1.0, .p_z = 0.2, .p_theta = 0.1, .p_w = 0.3};
  const auto gain = [&](const RollingState& at, const Costates& costates,
                        double beta) {
    return gain_of_other_directions(body, 1.0, at, costates, beta);
  };
  ASSERT_FALSE(std::isnan(gain(state, p, 0.1)));

  EXPECT_TRUE(std::isnan(gain({nan, 1.0}, p, 0.1)));
  EXPECT_TRUE(std::isnan(gain({0.4, nan}, p, 0.1)));
  EXPECT_TRUE(std::isnan(gain(state, p, nan)));
  EXPECT_TRUE(std::isnan(gain(state, {nan, 0.2, 0.1, 0.3}, 0.1)));
  EXPECT_TRUE(std::isnan(gain(state, {-1.0, nan, 0.1, 0.3}, 0.1)));
  EXPECT_TRUE(std::isnan(gain(state, {-1.0, 0.2, 0.1, nan}, 0.1)));
}

TEST(SlopeRate, OfACycloidIsConstant) {
  // From ∂𝓗/∂β = 𝓗 = 0 at η = 0: (w p_x, w p_z + g p_w) = −√A (cos β, sin β),
  // with p_x and p_z constant and p_w = 0 at the end.
  const double g = 9.81;
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    const CycloidArc arc = *axisymmetric_optimum(scene);
    const double root = std::sqrt(1.0 + scene.body.k);
    const double w_end = arc.fall_speed(g, arc.psi_end);
    Costates p;
    p.p_x = -root * std::cos(arc.slope_angle(arc.psi_end)) / w_end;
    p.p_z = -root * std::sin(arc.slope_angle(arc.psi_end)) / w_end;
    const double rate = -arc.psi_end / (2.0 * arc.rolling_time(g));
    for (const double part : {0.0, 1e-6, 0.1, 0.5, 0.9, 1.0}) {
      const double psi = part * arc.psi_end;
      const double beta = arc.slope_angle(psi);
      const RollingState state{0.0, arc.fall_speed(g, psi)};
      p.p_w = (-root * std::sin(beta) - state.w * p.p_z) / g;

      // Three terms below 2 |β'|, divided by √A.
      EXPECT_NEAR(slope_rate(scene.body, g, state, p, beta), rate,
                  ulps(16.0, 2.0 * std::abs(rate)))
          << "ψ " << psi;
    }
  }
}

TEST(SlopeRate, IsThatOfTheMinimisingSlopeAlongTheCanonicalFlow) {
  constexpr std::uint32_t kSeed = 6;
  Random random(kSeed);
  int measured = 0;
  for (int i = 0; i < 50; ++i) {
    const CostateSample s = random_costate_sample(random);
    const double g = s.gravity;
    const double r = s.body.radius;
    // The costates of an extremal make 𝓗 pull hard: a deep valley.
    Costates p = s.p;
    p.p_x -= 3.0;
    const double beta =
        minimising_slope(s.body, g, s.state, p, random.uniform(-1.0, 1.0));
    ASSERT_FALSE(std::isnan(beta));
    // θ' = w/r, w' = g (sin β + η cos θ), p' = −∂𝓗/∂(θ, w).
    const double A = inertia_factor(s.body, s.state.theta, beta);
    const double theta_rate = s.state.w / r;
    const double w_rate =
        g * (std::sin(beta) + s.body.eta_m * std::cos(s.state.theta));
    const double p_theta_rate =
        s.body.eta_m * std::cos(s.state.theta - beta) / std::sqrt(A) +
        p.p_w * g * s.body.eta_m * std::sin(s.state.theta);
    const double p_w_rate =
        -(p.p_x * std::cos(beta) + p.p_z * std::sin(beta) + p.p_theta / r);
    const auto moved = [&](double du) {
      const RollingState state{s.state.theta + du * theta_rate,
                               s.state.w + du * w_rate};
      const Costates q{p.p_x, p.p_z, p.p_theta + du * p_theta_rate,
                       p.p_w + du * p_w_rate};
      return minimising_slope(s.body, g, state, q, beta);
    };

    const double rate = slope_rate(s.body, g, s.state, p, beta);

    // A central difference: its error falls as the square of the step.
    std::array<double, 4> steps{}, errors{};
    for (std::size_t level = 0; level < steps.size(); ++level) {
      const double du = std::ldexp(4e-3, -static_cast<int>(level));
      steps[level] = du;
      errors[level] = std::abs((moved(du) - moved(-du)) / (2.0 * du) - rate);
    }
    // … until rounding of β, over the step, hides it.
    if (errors.back() < ulps(64.0) / steps.back()) continue;
    ++measured;
    EXPECT_NEAR(observed_order(steps, errors), 2.0, 0.1)
        << "seed " << kSeed << " sample " << i << " errors " << errors.front()
        << " … " << errors.back();
  }
  EXPECT_GE(measured, 40) << "too few samples left above rounding";
}

}  // namespace
}  // namespace brachisto::testing
