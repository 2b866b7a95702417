// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Limits at a point of the path, against the kinematics and by their
// definitions.

#include "model/path_inequality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "brachisto/math/jet.hpp"
#include "brachisto/model/kinematics.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

using Kind = PathInequality::Kind;

TurningPoint<double> random_place(Random& random) {
  return {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0),
          random.uniform(-9.0, 9.0), random.uniform(0.0, 3.0),
          random.uniform(-3.0, 3.0), random.uniform(-5.0, 5.0)};
}

Kinematics motion_at(const Body& body, double gravity,
                     const TurningPoint<double>& place) {
  return kinematics(
      body, gravity,
      {{place.x, place.z}, place.theta, place.beta, place.w, place.q});
}

Scene scene_with_gravity(const Body& body, double gravity) {
  Scene scene;
  scene.body = body;
  scene.gravity = gravity;
  return scene;
}

/// Terms of the forces: some dozen of the size of w²/(A r g), divided by A once
/// more.
double rounding(const Body& body, double gravity,
                const TurningPoint<double>& place) {
  const double A = inertia_factor(body, place.theta, place.beta);
  const double turn = place.w * (std::abs(place.q) + place.w / body.radius);
  return ulps(64.0, (1.0 + turn / (gravity * A)) * (1.0 + 4.0 / A));
}

TEST(ContactForceOfATurningPoint, IsThatOfTheKinematics) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Body body = random_cylinder(random);
    const double g = random.uniform(0.5, 10.0);
    const TurningPoint<double> place = random_place(random);

    const auto force = contact_force(scene_with_gravity(body, g), place);
    const Kinematics expected = motion_at(body, g, place);

    const double allowed = rounding(body, g, place);
    EXPECT_NEAR(force.normal, expected.R_n, allowed) << i;
    EXPECT_NEAR(force.tangential, expected.R_t, allowed) << i;
  }
}

TEST(ContactForceOfATurningPoint, OfABeadAndAUniformCylinderIsThatToo) {
  Random random(2);
  for (const Body& body : {Body::bead(), Body::cylinder(0.25, 0.0, 0.0, 0.5)}) {
    for (int i = 0; i < 200; ++i) {
      const double g = random.uniform(0.5, 10.0);
      const TurningPoint<double> place = random_place(random);

      const auto force = contact_force(scene_with_gravity(body, g), place);
      const Kinematics expected = motion_at(body, g, place);

      const double allowed = ulps(16.0, 1.0 + place.w * std::abs(place.q) / g);
      EXPECT_NEAR(force.normal, expected.R_n, allowed);
      EXPECT_NEAR(force.tangential, expected.R_t, allowed);
    }
  }
}

/// R(q) = R(0) + q ∂R/∂q with ∂R_n/∂q = −w (q̂² + k)/(A² g) and ∂R_t/∂q = −w q̂ η
/// cos δ/(A² g).
TEST(ContactForceOfATurningPoint, IsAffineInTheControl) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Body body = random_cylinder(random);
    const double g = random.uniform(0.5, 10.0);
    TurningPoint<double> place = random_place(random);
    const double q = place.q;
    const double delta = place.theta - place.beta;
    const double q_hat = 1.0 - body.eta_m * std::sin(delta);
    const double A = inertia_factor(body, place.theta, place.beta);
    const double per = -place.w / (A * A * g);

    const auto there = contact_force(scene_with_gravity(body, g), place);
    const double allowed = 2.0 * rounding(body, g, place);
    place.q = 0.0;
    const auto here = contact_force(scene_with_gravity(body, g), place);

    EXPECT_NEAR(there.normal - here.normal, q * per * (q_hat * q_hat + body.k),
                allowed);
    EXPECT_NEAR(there.tangential - here.tangential,
                q * per * q_hat * body.eta_m * std::cos(delta), allowed);
  }
}

const Body body = Body::cylinder(0.25, 0.5, 0.3, 0.4);

/// One of each kind.
PathLimits all_limits() {
  PathLimits limits;
  limits.friction = 0.5;
  limits.normal_min = 0.25;
  limits.curvature = {2.0, 3.0, CurvatureLimit::Of::Centre};
  limits.floor = 2.0;
  limits.discs = {{{4.0, 5.0}, 0.5}};
  limits.half_planes = {{{4.0, 1.0}, 2.0}};
  return limits;
}

TEST(ValueOfALimit, IsItsDistanceFromTheBound) {
  const double g = 2.0;
  const TurningPoint<double> place{1.0, 1.0, 0.7, 1.5, -0.4, 0.8};
  const Kinematics motion = motion_at(body, g, place);
  const double expected[] = {
      0.5 * motion.R_n - motion.R_t,
      0.5 * motion.R_n + motion.R_t,
      motion.R_n,
      2.0 * 1.5 - 0.8,
      3.0 * 1.5 + 0.8,
      2.0 - 0.25 - 1.0,
      5.0 - 0.75,
      -3.0 * std::cos(2.0) - 0.25,
  };

  const auto all = inequalities(body, all_limits());

  ASSERT_EQ(all.size(), std::size(expected));
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(value_of(all[i], scene_with_gravity(body, g), place),
                expected[i], ulps(64.0, 8.0))
        << name(all[i].kind) << " " << i;
  }
}

using PlaceJet = math::Jet2<double, 6>;

/// x, z, θ, w, β, q.
std::array<double, 6> random_values(Random& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
          random.uniform(-3.0, 3.0), random.uniform(0.5, 2.0),
          random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
}

TurningPoint<PlaceJet> variables_at(const std::array<double, 6>& x) {
  return {PlaceJet::variable(x[0], 0), PlaceJet::variable(x[1], 1),
          PlaceJet::variable(x[2], 2), PlaceJet::variable(x[3], 3),
          PlaceJet::variable(x[4], 4), PlaceJet::variable(x[5], 5)};
}

/// What first and second derivatives by jets leave at a distance h falls as h³.
TEST(ValueOfALimit, HasTheDerivativesOfItsJets) {
  const double g = 2.0;
  for (const PathInequality& limit : inequalities(body, all_limits())) {
    Random random(4);
    double coarse = 0.0, fine = 0.0;
    for (int i = 0; i < 20; ++i) {
      const std::array<double, 6> x = random_values(random);
      const std::vector<double> d = random.vector(6, -1.0, 1.0);
      const auto at_distance = [&](double h) {
        return value_of(limit, scene_with_gravity(body, g),
                        TurningPoint<double>{x[0] + h * d[0], x[1] + h * d[1],
                                             x[2] + h * d[2], x[3] + h * d[3],
                                             x[4] + h * d[4], x[5] + h * d[5]});
      };
      const PlaceJet jet =
          value_of(limit, scene_with_gravity(body, g), variables_at(x));
      double first = 0.0, second = 0.0;
      for (int a = 0; a < 6; ++a) {
        const auto u = static_cast<std::size_t>(a);
        first += jet.gradient[u] * d[u];
        for (int b = 0; b < 6; ++b) {
          second +=
              jet.hessian[PlaceJet::pair(std::max(a, b), std::min(a, b))] *
              d[u] * d[static_cast<std::size_t>(b)];
        }
      }
      EXPECT_DOUBLE_EQ(jet.value, at_distance(0.0));
      const auto remainder = [&](double h) {
        return std::abs(at_distance(h) - jet.value - h * first -
                        0.5 * h * h * second);
      };
      coarse += remainder(0x1p-6);
      fine += remainder(0x1p-8);
    }
    // 4³ = 64, but for the next term; limits that are bilinear leave rounding.
    EXPECT_LE(fine, coarse / 50.0 + ulps(20.0 * 16.0, 4.0)) << name(limit.kind);
  }
}

math::Dependence<6> on_which_depends(const PathInequality& limit,
                                     const Body& b) {
  using On = math::Dependence<6>;
  return value_of(
      limit, scene_with_gravity(b, 2.0),
      TurningPoint<On>{On::variable(0), On::variable(1), On::variable(2),
                       On::variable(3), On::variable(4), On::variable(5)});
}

/// A derivative that is not zero everywhere is not so at a random point.
TEST(DependenceOfALimit, IsWhatItsJetsHaveDerivativesBy) {
  const std::vector<PathInequality> all = inequalities(body, all_limits());
  for (const Body& b : {body, Body::cylinder(0.25, 0.0, 0.0, 0.4)}) {
    for (const PathInequality& limit : all) {
      Random random(5);
      const PlaceJet jet = value_of(limit, scene_with_gravity(b, 2.0),
                                    variables_at(random_values(random)));
      const math::Dependence<6> on = on_which_depends(limit, b);
      for (int k = 0; k < 6; ++k) {
        const auto u = static_cast<std::size_t>(k);
        EXPECT_EQ(on.any[u], jet.gradient[u] != 0.0)
            << name(limit.kind) << " by " << k;
        for (int l = 0; l <= k; ++l) {
          EXPECT_EQ(on.second[u][static_cast<std::size_t>(l)],
                    jet.hessian[PlaceJet::pair(k, l)] != 0.0)
              << name(limit.kind) << " by " << k << " and " << l;
        }
      }
      EXPECT_EQ(limit.bounds_control(), on.any[5]) << name(limit.kind);
    }
  }
}

TEST(LimitsOfAScene, StateTheirKindsInOrderAndConvertCurvatures) {
  PathLimits limits;
  limits.curvature = {2.0, 3.0, CurvatureLimit::Of::Track};

  // K_h = K/(1 + r K), K_v = K/(1 − r K), none from r K = 1 on.
  EXPECT_NEAR(hump_of_centre(body, limits), 2.0 / 1.5, ulps(4.0));
  EXPECT_NEAR(valley_of_centre(body, limits), 12.0, ulps(32.0));
  limits.fold_margin = 0.75;
  EXPECT_NEAR(hump_of_centre(body, limits), 1.0, ulps(4.0));
  limits.curvature.valley = 4.0;
  EXPECT_TRUE(std::isinf(valley_of_centre(body, limits)));
  EXPECT_EQ(inequalities(body, limits).size(), 1u);
  EXPECT_EQ(inequalities(body, limits).front().kind, Kind::Hump);
}

TEST(WorstExcess, NamesTheLimitAndItsSide) {
  PathLimits limits;
  limits.normal_min = 0.5;
  limits.normal_max = 2.0;
  limits.floor = 3.0;
  const Body bead = Body::bead();
  const auto all = inequalities(bead, limits);
  // Level, R_n = 1 − w q/g.
  const TurningPoint<double> level{0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  TurningPoint<double> heavy = level, light = level, deep = level;
  heavy.q = -4.0;
  light.q = 1.0;
  deep.z = 7.0;

  EXPECT_LE(worst_excess(all, scene_with_gravity(bead, 2.0), level).value, 0.0);
  EXPECT_NEAR(worst_excess(all, scene_with_gravity(bead, 2.0), heavy).value,
              1.0, ulps(4.0, 4.0));
  EXPECT_TRUE(worst_excess(all, scene_with_gravity(bead, 2.0), heavy).above);
  EXPECT_EQ(worst_excess(all, scene_with_gravity(bead, 4.0), light).limit, 0);
  EXPECT_FALSE(worst_excess(all, scene_with_gravity(bead, 4.0), light).above);
  EXPECT_EQ(worst_excess(all, scene_with_gravity(bead, 2.0), deep).limit, 1);
  EXPECT_NEAR(worst_excess(all, scene_with_gravity(bead, 2.0), deep).value, 4.0,
              ulps(4.0, 4.0));
}

}  // namespace
}  // namespace brachisto::testing
