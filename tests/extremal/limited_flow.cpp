// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Hamilton's equations under limits against the formulas that the free motion
// is computed with, against differences, and against what arcs conserve.

#include "extremal/limited_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "extremal/limited_boundary.hpp"
#include "extremal/limited_integration.hpp"
#include "extremal/scenes.hpp"
#include "model/hamiltonian.hpp"
#include "model/units.hpp"
#include "support/random_points.hpp"

namespace brachisto::limited {
namespace {

using testing::Random;

constexpr unsigned kSeed = 20260301;

Scene natural_scene() {
  return in_natural_units(brachisto::testing::base_scene(-0.4));
}

/// Somewhere on the way, with costates such as extremals have.
State random_state(Random& random) {
  return {random.uniform(0.1, 0.9),   random.uniform(0.1, 0.3),
          random.uniform(-1.0, 6.0),  random.uniform(0.3, 0.6),
          random.uniform(-0.5, 1.2),  random.uniform(-2.0, -1.0),
          random.uniform(-0.5, 0.5),  random.uniform(-0.05, 0.05),
          random.uniform(-3.0, -2.0), random.uniform(-0.05, 0.05)};
}

Costates costates_of(const State& y) {
  return {y[kPX], y[kPZ], y[kPTheta], y[kPW]};
}

/// The state moved to the slope that makes 𝓗 minimal, with p_β = 0.
State made_singular(const Scene& scene, State y) {
  y[kBeta] = minimising_slope(scene.body, scene.gravity, {y[kTheta], y[kW]},
                              costates_of(y), y[kBeta]);
  y[kPBeta] = 0.0;
  return y;
}

std::vector<HeldLimit> limits_of_control() {
  PathLimits limits;
  limits.friction = 0.7;
  limits.normal_min = 0.3;
  limits.normal_max = 2.0;
  limits.curvature = {4.0, 3.0, CurvatureLimit::Of::Centre};
  std::vector<HeldLimit> out;
  for (const PathInequality& limit :
       inequalities(natural_scene().body, limits)) {
    out.push_back({limit, limit.lower});
    if (std::isfinite(limit.upper)) out.push_back({limit, limit.upper});
  }
  return out;
}

TEST(LimitedFlow, IsOnFreeArcsThatOfTheFreeMotion) {
  // Both are exact; products of numbers up to 10 lose a few digits.
  constexpr double kRounding = 1e-12;
  const Scene scene = natural_scene();
  const LimitedFlow flow(scene, std::nullopt);
  Random random(kSeed);
  for (int i = 0; i < 50; ++i) {
    const State y = made_singular(scene, random_state(random));
    const RollingState motion{y[kTheta], y[kW]};
    const Costates p = costates_of(y);
    const SlopeHamiltonian h =
        slope_hamiltonian(scene.body, scene.gravity, motion, p, y[kBeta]);

    EXPECT_NEAR(flow.hamiltonian(y),
                hamiltonian(scene.body, scene.gravity, motion, p, y[kBeta]),
                kRounding);
    EXPECT_NEAR(flow.slope_condition(y), h.d_beta, kRounding);
    EXPECT_NEAR(flow.legendre(y), h.d2_beta, kRounding);
    const double rate =
        slope_rate(scene.body, scene.gravity, motion, p, y[kBeta]);
    EXPECT_NEAR(flow.control(y), rate,
                kRounding * (1.0 + std::abs(rate)) / std::abs(h.d2_beta));
  }
}

/// With q, the function of the state that the limit makes of it, put into
/// 𝓗 + p_β q, the multiplier's terms are those of ∂q/∂y: along the limit the
/// motion and its costates are canonical.
TEST(LimitedFlow, IsCanonicalAlongALimitOfTheControl) {
  // h² times third derivatives, which 1/w³ makes a few hundred.
  constexpr double h = 1e-5, kDifferences = 1e-7;
  const Scene scene = natural_scene();
  Random random(kSeed);
  for (const HeldLimit& held : limits_of_control()) {
    const LimitedFlow flow(scene, held);
    const State y = random_state(random);
    const auto by = [&](std::size_t component) {
      State up = y, down = y;
      up[component] += h;
      down[component] -= h;
      return (flow.hamiltonian(up) - flow.hamiltonian(down)) / (2.0 * h);
    };

    const State rates = flow.rates(y).y;

    for (std::size_t i = 0; i < kStates; ++i) {
      const std::size_t p = kStates + i;
      EXPECT_NEAR(rates[i], by(p), kDifferences * (1.0 + std::abs(rates[i])))
          << name(held.limit.kind) << ", state " << i;
      EXPECT_NEAR(rates[p], -by(i), kDifferences * (1.0 + std::abs(rates[p])))
          << name(held.limit.kind) << ", costate " << i;
    }
  }
}

/// What the flow is at the end of a short arc less what it was.
template <class Function>
double change_along(const LimitedFlow& flow, const State& start, double span,
                    const Function& of) {
  State end = start;
  EXPECT_TRUE(follow_piece(flow, start, span, Judged::StatesAndCostates, {},
                           [&](double, const State& y) { end = y; }));
  return of(end) - of(start);
}

// Every step errs by 1e-13 of numbers of order one, some hundred steps do.
constexpr double kConserved = 1e-11;
constexpr double kSpan = 0.1;

TEST(LimitedFlow, KeepsWhatAFreeArcConserves) {
  const Scene scene = natural_scene();
  const LimitedFlow flow(scene, std::nullopt);
  Random random(kSeed);
  for (int i = 0; i < 5; ++i) {
    const State y = made_singular(scene, random_state(random));
    const auto slope = [&](const State& at) {
      return flow.slope_condition(at);
    };
    const auto energy = [&](const State& at) { return flow.hamiltonian(at); };

    EXPECT_NEAR(change_along(flow, y, kSpan, slope), 0.0, kConserved);
    EXPECT_NEAR(change_along(flow, y, kSpan, energy), 0.0, kConserved);
  }
}

TEST(LimitedFlow, KeepsALimitOfTheControlAndItsHamiltonian) {
  const Scene scene = natural_scene();
  Random random(kSeed);
  for (const HeldLimit& held : limits_of_control()) {
    const LimitedFlow flow(scene, held);
    const State y = random_state(random);

    EXPECT_NEAR(flow.value(held.limit, y), held.bound, kConserved);
    EXPECT_NEAR(
        change_along(flow, y, 0.2 * kSpan,
                     [&](const State& at) { return flow.hamiltonian(at); }),
        0.0, kConserved)
        << name(held.limit.kind);
  }
}

TEST(LimitedFlow, FollowsTheBoundaryOfADiscAndKeepsTheSlopeCondition) {
  const Scene scene = natural_scene();
  PathLimits limits;
  limits.discs = {{{0.5, 0.6}, 0.1}};
  const PathInequality disc = inequalities(scene.body, limits).front();
  const LimitedFlow flow(scene, HeldLimit{disc, 0.0});
  Random random(kSeed);
  State y = random_state(random);
  // Above the disc, along it, and with the p_z that makes ∂𝓗/∂β vanish.
  const double angle = -1.3;
  y[kX] = disc.place.x + disc.number * std::cos(angle);
  y[kZ] = disc.place.z + disc.number * std::sin(angle);
  y[kBeta] = angle + 0.5 * std::numbers::pi;
  y[kPBeta] = 0.0;
  y[kPZ] -= flow.slope_condition(y) / (y[kW] * std::cos(y[kBeta]));
  ASSERT_NEAR(flow.value(disc, y), 0.0, 1e-15);
  ASSERT_NEAR(flow.slope_condition(y), 0.0, 1e-15);

  const auto along = [&](auto of) { return change_along(flow, y, kSpan, of); };

  EXPECT_NEAR(along([&](const State& at) { return flow.value(disc, at); }), 0.0,
              kConserved);
  EXPECT_NEAR(along([&](const State& at) { return flow.rate_of(disc, at); }),
              0.0, kConserved);
  EXPECT_NEAR(along([&](const State& at) { return flow.slope_condition(at); }),
              0.0, kConserved);
  EXPECT_NEAR(along([&](const State& at) { return flow.hamiltonian(at); }), 0.0,
              kConserved);
  // A circle of this radius.
  EXPECT_NEAR(flow.control(y), y[kW] / disc.number, 1e-14);
}

/// The remainder of the Taylor expansion falls with the square of the step.
TEST(LimitedIntegration, HasTheExactDerivativesOfItsEnd) {
  const Scene scene = natural_scene();
  Random random(kSeed);
  std::vector<HeldLimit> some = limits_of_control();
  for (int i = -1; i < static_cast<int>(some.size()); ++i) {
    const LimitedFlow flow(
        scene, i < 0 ? std::nullopt
                     : std::optional(some[static_cast<std::size_t>(i)]));
    const State y = i < 0 ? made_singular(scene, random_state(random))
                          : random_state(random);
    State direction;
    for (double& component : direction) component = random.uniform(-1.0, 1.0);
    const auto end_of = [&](const State& start, PieceEnd& end) {
      double step = 0.0;
      return integrate_piece(flow, start, 0.2 * kSpan,
                             Judged::StatesAndCostates, {}, step, end);
    };
    PieceEnd end;
    ASSERT_TRUE(end_of(y, end));
    const auto remainder = [&](double by) {
      State moved = y;
      for (std::size_t c = 0; c < kSize; ++c) moved[c] += by * direction[c];
      PieceEnd there;
      EXPECT_TRUE(end_of(moved, there));
      double largest = 0.0;
      for (std::size_t c = 0; c < kSize; ++c) {
        double expected = end.y[c];
        for (std::size_t j = 0; j < kSize; ++j) {
          expected += by * direction[j] *
                      end.by_start(static_cast<Eigen::Index>(c),
                                   static_cast<Eigen::Index>(j));
        }
        largest = std::max(largest, std::abs(there.y[c] - expected));
      }
      return largest;
    };

    const double order = std::log10(remainder(1e-3) / remainder(1e-4));

    EXPECT_NEAR(order, 2.0, 0.1) << "limit " << i;
  }
}

/// A uniform cylinder that friction holds.
Scene uniform_under(double mu) {
  Scene scene = natural_scene();
  scene.body = Body::cylinder(scene.body.radius, 0.0, 0.0, 0.5);
  scene.limits.friction = mu;
  return scene;
}

/// On a slope R_t < 0: of the two it is friction backwards that binds.
HeldLimit friction_on(const Scene& scene) {
  return {inequalities(scene.body, scene.limits).back(), 0.0};
}

/// From rest along the incline of the slope β*, tan β* = μ (1 + k)/k, w = g u
/// sin β*. Next to it the limit turns the path by
///
///     β' = (A g/w) sin(β* − β)/sin β*,
///
/// back to it: with P = A/sin² β* a change of β at u₀ has fallen by (u₀/u)^P at
/// u, and changes w by g cos β* u₀ (1 − (u₀/u)^(P − 1))/(P − 1). The gentler
/// the slope, the greater P, up to 12 here; the path itself stays straight,
/// whatever the step.
TEST(LimitedIntegration, HasTheDerivativesOfAnInclineFromRest) {
  // The error of derivatives that a step may have, for a hundred steps.
  constexpr double kOfSteps = 1e-6;
  constexpr double kLength = 0.5;
  for (const double mu : {0.14, 0.2, 0.4, 1.0}) {
    const Scene scene = uniform_under(mu);
    const HeldLimit held = friction_on(scene);
    const double steepest = std::atan(3.0 * mu), A = 1.5;
    const double P = A / std::pow(std::sin(steepest), 2);
    const State rest = LimitedStart(scene, held, 0.7).left_rest();
    const double u_0 = LimitedStart::kLeftRest, u_1 = u_0 + kLength;
    PieceEnd end;
    double step = 0.0;

    ASSERT_TRUE(integrate_piece(LimitedFlow(scene, held), rest, kLength,
                                Judged::StatesAlone, {}, step, end));

    const double g = scene.gravity;
    EXPECT_NEAR(end.y[kBeta], steepest, 1e-12);
    EXPECT_NEAR(end.y[kW], g * u_1 * std::sin(steepest), 1e-12);
    const auto by = [&](Component of, Component start) {
      return end.by_start(static_cast<Eigen::Index>(of),
                          static_cast<Eigen::Index>(start));
    };
    EXPECT_NEAR(by(kBeta, kBeta), std::pow(u_0 / u_1, P), kOfSteps) << mu;
    EXPECT_NEAR(by(kW, kBeta),
                g * std::cos(steepest) * u_0 / (P - 1.0) *
                    (1.0 - std::pow(u_0 / u_1, P - 1.0)),
                kOfSteps)
        << mu;
    EXPECT_NEAR(by(kW, kW), 1.0, kOfSteps) << mu;
    EXPECT_NEAR(by(kX, kW), kLength * std::cos(steepest), kOfSteps) << mu;
  }
}

/// The static cone of a uniform cylinder: tan β₀ = μ (1 + k)/k.
TEST(LimitedStart, LeavesRestOnTheBorderOfTheStaticCone) {
  constexpr double mu = 0.4;
  const Scene scene = uniform_under(mu);
  const HeldLimit held = friction_on(scene);
  ASSERT_EQ(held.limit.kind, PathInequality::Kind::FrictionBackward);

  const LimitedStart start(scene, held, 0.7);

  EXPECT_EQ(start.kind(), LimitedStart::Kind::Forced);
  EXPECT_NEAR(start.left_rest()[kBeta], std::atan(3.0 * mu), 1e-14);
}

/// With β right to the second order what the limit is off is of the third.
TEST(LimitedStart, KeepsTheLimitNextToRest) {
  constexpr double h = 1e-6;
  const Scene scene = natural_scene();
  for (const HeldLimit& held : limits_of_control()) {
    if (held.limit.kind != PathInequality::Kind::FrictionBackward) continue;
    const LimitedStart start(scene, held, 1.2);
    ASSERT_EQ(start.kind(), LimitedStart::Kind::Forced);
    const auto off = [&](double u) {
      const State y = start.left_rest(u);
      const double q =
          (start.left_rest(u + h)[kBeta] - start.left_rest(u - h)[kBeta]) /
          (2.0 * h);
      return std::abs(value_of(held.limit, scene.body, scene.gravity,
                               TurningPoint<double>{y[kX], y[kZ], y[kTheta],
                                                    y[kW], y[kBeta], q}) -
                      held.bound);
    };

    EXPECT_GE(std::log10(off(1e-1) / off(1e-2)), 2.9);
  }
}

}  // namespace
}  // namespace brachisto::limited
