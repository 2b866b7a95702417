// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Whether limits let an off-centred body come down, beside motions that keep
// them by Newton's law.

#include "model/loaded_fall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "math/interval.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {
namespace {

using Limits = std::vector<PathInequality>;

double in(std::mt19937& random, double from, double to) {
  return std::uniform_real_distribution<>(from, to)(random);
}

/// A body that rolls on a track which is made as it goes.
struct Roller {
  const Scene& scene;
  const Limits& limits;
  double theta, beta, E = 0.0;

  struct Bends {
    double least, most;
  };
  /// The curvatures that keep all limits here, by Newton's law, which is affine
  /// in them.
  [[nodiscard]] Bends bends() const {
    constexpr double kSharpest = 1e3;
    const double w = fall_speed(scene.gravity, E);
    const TurningPoint<double> here{0.0, 0.0, theta, w, beta, 0.0};
    Bends out{-kSharpest, kSharpest};
    const auto keep = [&](double room, double by_bend) {
      if (by_bend > 0.0) out.least = std::max(out.least, -room / by_bend);
      if (by_bend < 0.0) out.most = std::min(out.most, -room / by_bend);
    };
    for (const PathInequality& limit : limits) {
      TurningPoint<double> bent = here;
      const double value = value_of(limit, scene, here);
      bent.q = w;
      const double by_bend = value_of(limit, scene, bent) - value;
      keep(value - limit.lower, by_bend);
      if (std::isfinite(limit.upper)) keep(limit.upper - value, -by_bend);
    }
    return out;
  }
  void roll(double bend, double turn) {
    const double length = scene.body.radius * turn;
    const double slope = beta + 0.5 * bend * length;
    E += length * energy_slope(scene.body, theta + 0.5 * turn, slope);
    theta += turn;
    beta += bend * length;
  }
  /// E less that of a body that touches B here.
  [[nodiscard]] double over_B(double beta_0, double E_0) const {
    const double r = scene.body.radius;
    const double drop = scene.H + r * (std::cos(beta_0) - std::cos(beta));
    return E - E_0 - energy_height(scene.body, drop, theta);
  }
};

/// How much deeper than B random motions within the limits come, which steer
/// for one slope after the other; negative if they do not come to its height.
double deepest(const Scene& scene) {
  constexpr double kTurn = 4e-3;
  constexpr int kMotions = 200, kSteps = 5000, kHeldFor = 75;
  const Limits limits = inequalities(scene.body, scene.limits);
  std::mt19937 random(3);
  double deepest = -std::numeric_limits<double>::infinity();
  const auto start = known_start_slope(scene, limits);
  for (int i = 0; i < kMotions; ++i) {
    const double beta_0 = start ? *start : in(random, -1.5, 1.5);
    const double v_0 = scene.world.start_speed;
    const double A = inertia_factor(scene.body, scene.body.theta_m, beta_0);
    const double E_0 = A * v_0 * v_0 / (2.0 * scene.gravity);
    Roller body{scene, limits, scene.body.theta_m, beta_0, E_0};
    if (v_0 == 0.0 && !(energy_slope(scene.body, body.theta, beta_0) > 0.0)) {
      continue;
    }
    double wanted = beta_0;
    for (int step = 0; step < kSteps; ++step) {
      if (step % kHeldFor == 0) wanted = in(random, -0.5, std::numbers::pi);
      const Roller::Bends bends = body.bends();
      if (bends.least > bends.most) break;
      const double to = (wanted - body.beta) / (scene.body.radius * kTurn);
      body.roll(std::clamp(to, bends.least, bends.most), kTurn);
      if (body.E < 0.0 || std::abs(body.beta) > std::numbers::pi) break;
      deepest = std::max(deepest, body.over_B(beta_0, E_0));
    }
  }
  return deepest;
}

bool falls(const Scene& scene) {
  return comes_down(scene, inequalities(scene.body, scene.limits));
}

Scene of(double H, Body body, PathLimits limits,
         Contact contact = Contact::Smooth) {
  Scene scene;
  scene.L = 2.0;
  scene.H = H;
  scene.body = body;
  scene.limits = std::move(limits);
  scene.limits.curvature.of = CurvatureLimit::Of::Centre;
  scene.contact = contact;
  return scene;
}
PathLimits lifting(double least, double valley) {
  PathLimits limits;
  limits.normal_min = least;
  limits.curvature.valley = valley;
  return limits;
}
PathLimits pressing(double most, double hump) {
  PathLimits limits;
  limits.normal_max = most;
  limits.curvature.hump = hump;
  return limits;
}

TEST(LoadedFall, NoMotionWithinTheLimitsComesDownWhereThatIsDenied) {
  const Body heavy = Body::cylinder(0.0955, 0.791, 0.92, 0.215);
  const Body larger = Body::cylinder(0.16, 0.7, 0.6, 0.21);
  Scene rough = of(1.0, Body::cylinder(0.137, 0.645, -0.868, 0.31), {});
  rough.limits.friction = 0.518;
  rough.limits.curvature.valley = 1.338;
  for (Scene scene : {of(0.9, heavy, pressing(2.042, 1.99), Contact::Optimal),
                      of(0.85, heavy, pressing(3.0, 4.0)),
                      of(1.1, larger, lifting(0.3, 1.5)), rough}) {
    EXPECT_FALSE(falls(scene));
    const double deep = deepest(scene);
    EXPECT_LT(deep, 0.0);
    scene.H += deep - 0.02;  // where they do come
    EXPECT_TRUE(falls(scene));
    EXPECT_GT(deepest(scene), 0.0);
  }
}

/// Also where A is small, and over slopes far from each other.
TEST(LoadedFall, RestsOnForcesThatAreEnclosed) {
  using math::Interval;
  constexpr int kRanges = 4000, kPlaces = 10;
  constexpr double kRounding = 1e-9;
  std::mt19937 random(5);
  Scene scene;
  for (int i = 0; i < kRanges; ++i) {
    const double eta = 1.0 - std::pow(10.0, in(random, -2.0, -0.3));
    scene.body =
        Body::cylinder(0.1, eta, 0.0, (1.0 - eta * eta) * in(random, 0.0, 0.5));
    const auto some = [&](double most) {
      const double from = in(random, -4.0, 4.0);
      return Interval(from, from + std::pow(10.0, in(random, -3.0, most)));
    };
    const Interval theta = some(-1.0), beta = some(0.7);
    const auto forces = [&](auto at_theta, auto at_beta) {
      using Scalar = decltype(at_theta);
      const Pull<Scalar> G = pull_on(scene, Scalar(0.0), Scalar(0.0), at_theta);
      const auto forms = ForceForms<Scalar>::of(scene, G, at_theta, at_beta);
      return std::vector{forms.at_rest.normal, forms.at_rest.tangential,
                         forms.by_ww.normal,   forms.by_ww.tangential,
                         forms.by_wq.normal,   forms.by_wq.tangential};
    };
    const std::vector<Interval> all = forces(theta, beta);
    for (int k = 0; k < kPlaces; ++k) {
      const std::vector<double> here =
          forces(in(random, theta.lower, theta.upper),
                 in(random, beta.lower, beta.upper));
      for (std::size_t f = 0; f < here.size(); ++f) {
        EXPECT_GE(here[f], all[f].lower - kRounding);
        EXPECT_LE(here[f], all[f].upper + kRounding);
      }
    }
  }
}

TEST(LoadedFall, NoneComesDownThatWasPushedWhereThatIsDenied) {
  const Body heavy = Body::cylinder(0.0368, 0.636, 1.117, 0.202);
  Scene slow = of(1.0, heavy, pressing(1.549, 2.9), Contact::Optimal);
  slow.limits.curvature.valley = 0.715;
  Scene small = of(1.0, Body::cylinder(0.0337, 0.333, -0.137, 0.72), {});
  small.limits.friction = 0.535;
  small.limits.curvature.valley = 2.757;
  for (Scene scene : {slow, small}) {
    for (const double v_0 : {0.5, 1.1}) {
      scene.H = 1.0;
      scene.world.start_speed = v_0;
      EXPECT_FALSE(falls(scene));
      const double deep = deepest(scene);
      EXPECT_LT(deep, 0.0);
      scene.H += deep - 0.02;
      EXPECT_TRUE(falls(scene));
      EXPECT_GT(deepest(scene), 0.0);
    }
    scene.H = 1.0;
    scene.world.start_speed = 5.0;  // enough to go on at once
    EXPECT_TRUE(falls(scene));
  }
}

TEST(LoadedFall, OfASmallBodyEndsInItsOwnTurns) {
  Scene scene = of(1.0, Body::cylinder(0.03, 0.66, -0.5, 0.34), {});
  EXPECT_TRUE(falls(scene));
  scene.limits.friction = 0.6;
  EXPECT_TRUE(falls(scene));  // where valleys may press it down
  scene.limits.curvature.valley = 3.0;
  EXPECT_FALSE(falls(scene));
  scene.limits.friction.reset();
  EXPECT_TRUE(falls(scene));  // a track with two sides holds it
  scene.limits.normal_min = 0.0;
  EXPECT_FALSE(falls(scene));
  scene.world.losses.rolling = 0.02;
  EXPECT_TRUE(falls(scene));  // nothing is said where energy is lost
  scene.world.losses.rolling = 0.0;
  scene.body.eta_m = 0.0;
  EXPECT_TRUE(falls(scene));  // nor of a mass on the axis
  scene.body.eta_m = 0.66;
  scene.limits = {};
  scene.limits.normal_max = 3.0;
  EXPECT_TRUE(falls(scene));
  scene.limits.curvature.hump = 3.0;
  EXPECT_FALSE(falls(scene));
}

}  // namespace
}  // namespace brachisto
