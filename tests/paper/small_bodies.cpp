// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// r → 0: the body becomes a medium of its own (docs/numerics.md, section 6).

#include <gtest/gtest.h>

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using testing::reference;
using testing::scene_of;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// min over β of √A(ψ − β) − λ cos β by golden sections around the best of a
/// grid; nothing of the library is used.
double least(double eta, double k, double psi, double lambda) {
  const auto f = [&](double beta) {
    return std::sqrt(1.0 + eta * eta + k - 2.0 * eta * std::sin(psi - beta)) -
           lambda * std::cos(beta);
  };
  constexpr int kGrid = 48;
  int best = 0;
  for (int i = 1; i < kGrid; ++i) {
    if (f(i * kTurn / kGrid) < f(best * kTurn / kGrid)) best = i;
  }
  double low = (best - 1) * kTurn / kGrid;
  double high = (best + 1) * kTurn / kGrid;
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-9) {
    const double a = high - ratio * (high - low);
    const double b = low + ratio * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return f(0.5 * (low + high));
}

/// The root of ⟨min_β [√A − λ cos β]⟩_ψ = 0; the trapezium rule converges like
/// a power of e for periodic functions.
double slowness(double eta, double k) {
  const auto mean = [&](double lambda) {
    constexpr int kPhases = 128;
    double sum = 0.0;
    for (int i = 0; i < kPhases; ++i) {
      sum += least(eta, k, i * kTurn / kPhases, lambda) / kPhases;
    }
    return sum;
  };
  std::uintmax_t iterations = 60;
  // At η = 0, √(1 + k) is the root; 𝓗 falls with λ.
  const auto bracket = boost::math::tools::toms748_solve(
      mean, 0.5, 2.0, boost::math::tools::eps_tolerance<double>(40),
      iterations);
  return 0.5 * (bracket.first + bracket.second);
}

TEST(SmallBodies, HaveTheSlownessOfTheDocumentation) {
  const double bead = reference("bead_L3").tau;

  EXPECT_NEAR(slowness(0.0, 0.5), std::sqrt(1.5), 1e-10);
  EXPECT_NEAR(slowness(2.0 / 3.0, 0.5), 1.2960997, 5e-8);
  EXPECT_NEAR(slowness(2.0 / 3.0, 0.5) * bead, 5.8461395, 5e-8);
}

TEST(SmallBodies, TendToTheLimitLikeTheRootOfTheRadius) {
  // The principal branch of a body whose offset is small keeps the best number
  // of turns. τ_∞ − τ = a r + b √r + …: divided by √r it stays bounded, and
  // falls towards b; divided by r it grows.
  constexpr double kEta = 0.2;
  constexpr double kInertia = 0.5;
  const double limit = slowness(kEta, kInertia) * reference("bead_L3").tau;
  double by_root = 1.0;
  double by_radius = 1.0;
  for (const double r : {0.1, 0.05, 0.025, 0.0125}) {
    const Solution solution =
        solve(scene_of(Body::cylinder(r, kEta, 0.0, kInertia)));
    ASSERT_TRUE(solution.verified()) << r << ": " << solution.message;

    const double missing = limit - solution.motion()->tau();

    EXPECT_GT(missing, 0.0) << r;
    EXPECT_LT(missing / std::sqrt(r), by_root) << r;
    EXPECT_GT(missing / r, by_radius) << r;
    by_root = missing / std::sqrt(r);
    by_radius = missing / r;
  }
  EXPECT_LT(by_root, 0.25);
}

/// Mean of p_θ over the turn of the body around the share `middle` of the path,
/// in units of r, and that of w.
struct Turn {
  double J_per_r = 0.0;
  double w = 0.0;
};

Turn mean_over_a_turn(const ExtremalCurve& curve, double middle) {
  const double r = curve.scene().body.radius;
  const auto sigma_at = [&](double s) {
    std::uintmax_t iterations = 60;
    return boost::math::tools::toms748_solve(
               [&](double sigma) { return curve.at(sigma).s - s; }, 0.0, 1.0,
               boost::math::tools::eps_tolerance<double>(40), iterations)
        .first;
  };
  constexpr int kPhases = 128;
  Turn mean;
  for (int i = 0; i < kPhases; ++i) {
    const double turned = ((i + 0.5) / kPhases - 0.5) * kTurn;
    const ExtremalPoint at =
        curve.at(sigma_at(middle * curve.arc_length() + turned * r));
    mean.J_per_r += at.p.p_theta / r / kPhases;
    mean.w += at.w / kPhases;
  }
  return mean;
}

TEST(SmallBodies, KeepTheActionOfTheirRotation) {
  // ⟨p_θ⟩ over a turn is an adiabatic invariant: constant up to O(r) of itself
  // while w is not.
  constexpr double kRadius = 0.02;
  constexpr double kInertia = 0.5;
  for (const double eta : {0.2, 2.0 / 3.0}) {
    const Solution solution =
        solve(scene_of(Body::cylinder(kRadius, eta, 0.0, kInertia)));
    ASSERT_TRUE(solution.verified()) << solution.message;
    const ExtremalCurve& curve = trajectory_of(solution)->curve();

    const Turn first = mean_over_a_turn(curve, 0.3);

    for (const double middle : {0.5, 0.7, 0.95}) {
      EXPECT_NEAR(mean_over_a_turn(curve, middle).J_per_r, first.J_per_r,
                  2.0 * kRadius * std::abs(first.J_per_r))
          << eta << ", " << middle;
    }
    EXPECT_GT(mean_over_a_turn(curve, 0.7).w, 1.15 * first.w) << eta;
  }
}

TEST(SmallBodies, OfThePrincipalBranchNeedNotHaveTheBestNumberOfTurns) {
  // It would have J = 0, or within O(r) of it. So this branch need not tend to
  // the limit, and does not.
  const Solution solution =
      solve(scene_of(Body::cylinder(0.02, 2.0 / 3.0, 0.0, 0.5)));
  ASSERT_TRUE(solution.verified()) << solution.message;

  EXPECT_GT(mean_over_a_turn(trajectory_of(solution)->curve(), 0.5).J_per_r,
            0.3);
}

}  // namespace
}  // namespace brachisto
