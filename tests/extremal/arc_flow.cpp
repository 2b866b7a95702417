// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Hamilton's equations on arcs against the formulas that the free motion is
// computed with, against differences, and against what arcs conserve.

#include "extremal/arc_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "extremal/arc_boundary.hpp"
#include "extremal/scenes.hpp"
#include "model/hamiltonian.hpp"
#include "model/units.hpp"
#include "support/random_points.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::arcs {
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

/// All at a node.
ArcPoint point_at(const ArcFlow& flow, const Node& y, double near) {
  ArcPoint out;
  EXPECT_TRUE(flow.find(y, near, out));
  return out;
}

double hamiltonian_at(const ArcFlow& flow, const Node& y, double near) {
  LinearPoint out;
  EXPECT_TRUE(flow.find(y, near, out));
  return out.hamiltonian.value;
}

TEST(ArcFlow, IsOnFreeArcsThatOfTheFreeMotion) {
  // Both are exact; products of numbers up to 10 lose a few digits.
  constexpr double kRounding = 1e-12;
  const Scene scene = natural_scene();
  const ArcFlow flow(scene, std::nullopt);
  Random random(kSeed);
  for (int i = 0; i < 50; ++i) {
    const State y = made_singular(scene, random_state(random));
    const RollingState motion{y[kTheta], y[kW]};
    const Costates p = costates_of(y);
    const SlopeHamiltonian h =
        slope_hamiltonian(scene.body, scene.gravity, motion, p, y[kBeta]);
    const Node node = flow.node_of(y);

    const ArcPoint at = point_at(flow, node, y[kBeta]);

    EXPECT_NEAR(hamiltonian_at(flow, node, y[kBeta]),
                hamiltonian(scene.body, scene.gravity, motion, p, y[kBeta]),
                kRounding);
    EXPECT_NEAR(at.y[kBeta], y[kBeta], kRounding / h.d2_beta);
    EXPECT_NEAR(at.legendre, h.d2_beta, kRounding);
    const double rate =
        slope_rate(scene.body, scene.gravity, motion, p, y[kBeta]);
    EXPECT_NEAR(at.q, rate, kRounding * (1.0 + std::abs(rate)) / h.d2_beta);
  }
}

/// A short way, and where it leads.
PieceEnd end_of(const ArcFlow& flow, const Node& start, double near,
                double span) {
  PieceEnd end;
  double step = 0.0;
  EXPECT_TRUE(flow.integrate(start, near, span, {}, step, end));
  return end;
}

constexpr double kSpan = 0.1;
// Every step errs by 1e-13 of numbers of order one, some hundred steps do.
constexpr double kConserved = 1e-11;

/// With q, the function of the state that the limit makes of it, put into
/// 𝓗 + p_β q, the multiplier's terms are those of ∂q/∂y: along the limit the
/// motion and its costates are canonical.
TEST(ArcFlow, IsCanonicalAlongALimitOfTheControl) {
  // h² times third derivatives, which 1/w³ makes a few hundred.
  constexpr double h = 1e-5, kDifferences = 1e-7;
  const Scene scene = natural_scene();
  Random random(kSeed);
  for (const HeldLimit& held : limits_of_control()) {
    const ArcFlow flow(scene, held);
    const PieceEnd end =
        end_of(flow, flow.node_of(random_state(random)), 0.0, 1e-6);
    const auto by = [&](Eigen::Index component) {
      Node up = end.y, down = end.y;
      up(component) += h;
      down(component) -= h;
      return (hamiltonian_at(flow, up, 0.0) - hamiltonian_at(flow, down, 0.0)) /
             (2.0 * h);
    };

    for (Eigen::Index i = 0; i < 5; ++i) {
      const double rate = end.rates(i), costate_rate = end.rates(5 + i);
      EXPECT_NEAR(rate, by(5 + i), kDifferences * (1.0 + std::abs(rate)))
          << name(held.limit.kind) << ", state " << i;
      EXPECT_NEAR(costate_rate, -by(i),
                  kDifferences * (1.0 + std::abs(costate_rate)))
          << name(held.limit.kind) << ", costate " << i;
    }
  }
}

TEST(ArcFlow, KeepsTheHamiltonianOfAFreeArcInAllOfTheWorld) {
  const Scene scene = in_natural_units(testing::in_air(
      testing::with_push(testing::about_sphere(testing::off_centred_scene(0.4),
                                               testing::around()),
                         0.7),
      0.1, 0.05));
  for (const Scene& there : {natural_scene(), scene}) {
    const ArcFlow flow(there, std::nullopt);
    Random random(kSeed);
    for (int i = 0; i < 5; ++i) {
      const State y = made_singular(there, random_state(random));
      const Node start = flow.node_of(y);

      const PieceEnd end = end_of(flow, start, y[kBeta], kSpan);

      EXPECT_NEAR(hamiltonian_at(flow, end.y, end.control),
                  hamiltonian_at(flow, start, y[kBeta]), kConserved);
    }
  }
}

TEST(ArcFlow, KeepsALimitOfTheControlAndItsHamiltonian) {
  const Scene scene = natural_scene();
  Random random(kSeed);
  for (const HeldLimit& held : limits_of_control()) {
    const ArcFlow flow(scene, held);
    const Node start = flow.node_of(random_state(random));

    const PieceEnd end = end_of(flow, start, 0.0, 0.2 * kSpan);

    EXPECT_NEAR(flow.value(held.limit, point_at(flow, start, 0.0)), held.bound,
                kConserved);
    EXPECT_NEAR(flow.value(held.limit, point_at(flow, end.y, 0.0)), held.bound,
                kConserved);
    EXPECT_NEAR(hamiltonian_at(flow, end.y, 0.0),
                hamiltonian_at(flow, start, 0.0), kConserved)
        << name(held.limit.kind);
  }
}

/// Above a disc, on its border and along it.
struct OnDisc {
  Scene scene = natural_scene();
  PathInequality disc;
  State y;

  OnDisc() {
    PathLimits limits;
    limits.discs = {{{0.5, 0.6}, 0.1}};
    disc = inequalities(scene.body, limits).front();
    Random random(kSeed);
    y = random_state(random);
    const double angle = -1.3;
    y[kX] = disc.place.x + disc.number * std::cos(angle);
    y[kZ] = disc.place.z + disc.number * std::sin(angle);
    y[kBeta] = angle + 0.5 * std::numbers::pi;
    y[kPBeta] = 0.0;
  }
  [[nodiscard]] double distance(const Node& node) const {
    return std::hypot(node(0) - disc.place.x, node(1) - disc.place.z) -
           disc.number;
  }
};

/// Whatever the costates at its start: their part along the normal is that of
/// μ, which makes up for it.
TEST(ArcFlow, FollowsTheBoundaryOfADisc) {
  const OnDisc on;
  const ArcFlow flow(on.scene, HeldLimit{on.disc, 0.0});
  const Node start = flow.node_of(on.y);

  const PieceEnd end = end_of(flow, start, on.y[kBeta], kSpan);

  EXPECT_NEAR(on.distance(end.y), 0.0, kConserved);
  EXPECT_NEAR(hamiltonian_at(flow, end.y, end.control),
              hamiltonian_at(flow, start, on.y[kBeta]), kConserved);
  for (const Node& node : {start, end.y}) {
    const ArcPoint at = point_at(flow, node, on.y[kBeta]);
    EXPECT_NEAR(std::cos(at.y[kBeta]) * (at.y[kX] - on.disc.place.x) +
                    std::sin(at.y[kBeta]) * (at.y[kZ] - on.disc.place.z),
                0.0, kConserved);
    // A circle of this radius.
    EXPECT_NEAR(at.q, at.y[kW] / on.disc.number, kConserved);
    EXPECT_NEAR(slope_hamiltonian(on.scene.body, on.scene.gravity,
                                  {at.y[kTheta], at.y[kW]}, costates_of(at.y),
                                  at.y[kBeta])
                    .d_beta,
                0.0, kConserved);
  }
}

/// The costates of the limit itself: (p_x, p_z)' = ν ∂c/∂(x, z), for nothing
/// else depends on the place.
TEST(ArcFlow, TellsTheMultiplierOfABoundary) {
  constexpr double h = 1e-4, kDifferences = 1e-6;
  const OnDisc on;
  const ArcFlow flow(on.scene, HeldLimit{on.disc, 0.0});
  const Node start = flow.node_of(on.y);
  const auto at_u = [&](double u) {
    return point_at(flow, end_of(flow, start, on.y[kBeta], u).y, on.y[kBeta]);
  };
  const ArcPoint before = at_u(0.01 - h), here = at_u(0.01),
                 after = at_u(0.01 + h);

  const auto rate = [&](Component p) {
    return (after.y[p] - before.y[p]) / (2.0 * h);
  };

  const double n_x = (here.y[kX] - on.disc.place.x) / on.disc.number;
  const double n_z = (here.y[kZ] - on.disc.place.z) / on.disc.number;
  EXPECT_NEAR(rate(kPX), here.nu * n_x, kDifferences * std::abs(here.nu));
  EXPECT_NEAR(rate(kPZ), here.nu * n_z, kDifferences * std::abs(here.nu));
}

/// Flows with a state on each: free ones in two worlds, with each limit of the
/// control, and along a disc.
struct Started {
  ArcFlow flow;
  Node start;
  double near;
};
std::vector<Started> flows_of_all_kinds() {
  const Scene scene = natural_scene();
  const Scene world = in_natural_units(testing::in_air(
      testing::about_sphere(testing::off_centred_scene(0.4), testing::around()),
      0.1, 0.05));
  Random random(kSeed);
  std::vector<Started> out;
  for (const Scene& there : {scene, world}) {
    const ArcFlow free(there, std::nullopt);
    const State y = made_singular(there, random_state(random));
    out.push_back({free, free.node_of(y), y[kBeta]});
  }
  for (const HeldLimit& held : limits_of_control()) {
    const ArcFlow flow(scene, held);
    out.push_back({flow, flow.node_of(random_state(random)), 0.0});
  }
  const OnDisc on;
  const ArcFlow flow(on.scene, HeldLimit{on.disc, 0.0});
  out.push_back({flow, flow.node_of(on.y), on.y[kBeta]});
  return out;
}

/// The remainder of a Taylor expansion falls with the square of the step.
TEST(ArcFlow, HasTheExactDerivativesOfItsEnd) {
  Random random(kSeed);
  for (const auto& [flow, start, near] : flows_of_all_kinds()) {
    Node direction(start.size());
    for (double& component : direction) component = random.uniform(-1.0, 1.0);
    const PieceEnd end = end_of(flow, start, near, 0.2 * kSpan);
    const auto remainder = [&](double by) {
      const PieceEnd there =
          end_of(flow, start + by * direction, near, 0.2 * kSpan);
      const Node off = there.y - end.y - by * end.by_start * direction;
      const double off_time =
          there.t - end.t - by * end.time_by_start.dot(direction);
      return std::max(off.lpNorm<Eigen::Infinity>(), std::abs(off_time));
    };

    const double order = std::log10(remainder(1e-3) / remainder(1e-4));

    EXPECT_NEAR(order, 2.0, 0.1) << "width " << flow.width();
  }
}

/// The costates' rates jump where a surface is passed, and a neighbour passes
/// it sooner or later.
TEST(ArcFlow, HasTheDerivativesOfArcsThroughASurface) {
  Scene scene = in_natural_units(testing::in_air(
      testing::with_push(testing::about_sphere(testing::off_centred_scene(0.4),
                                               testing::around()),
                         0.7),
      0.1, 0.05));
  constexpr double kLong = 0.7, kNear = 0.8, h = 1e-5;
  Node start(8);
  start << 0.1, 0.2, 0.5, 0.6, -0.8, 0.1, 0.02, -0.9;
  const auto height = [&](const Node& y) {
    return height_above_surface(scene,
                                mass_centre(scene.body, {y(0), y(1)}, y(2)));
  };
  // The surface lies half-way between the heights of its ends.
  const Node far = end_of(ArcFlow(scene, std::nullopt), start, kNear, kLong).y;
  scene.world.sphere->radius += 0.5 * (height(start) + height(far));
  const ArcFlow flow(scene, std::nullopt);
  const PieceEnd end = end_of(flow, start, kNear, kLong);
  ASSERT_LT(height(start) * height(end.y), 0.0);

  for (Eigen::Index j = 0; j < start.size(); ++j) {
    const Node by = h * Node::Unit(start.size(), j);
    const PieceEnd more = end_of(flow, start + by, kNear, kLong);
    const PieceEnd less = end_of(flow, start - by, kNear, kLong);
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      const double difference = (more.y(i) - less.y(i)) / (2.0 * h);
      // h² times third derivatives of some hundred.
      EXPECT_NEAR(end.by_start(i, j), difference,
                  1e-7 * (1.0 + std::abs(difference)))
          << i << " by " << j;
    }
    EXPECT_NEAR(end.time_by_start(j), (more.t - less.t) / (2.0 * h), 1e-7);
  }
}

/// The same of what its places say: slopes, multipliers and costates.
TEST(ArcFlow, HasTheExactDerivativesOfItsPlaces) {
  Random random(kSeed);
  for (const auto& [flow, start, near] : flows_of_all_kinds()) {
    Node direction(start.size());
    for (double& component : direction) component = random.uniform(-1.0, 1.0);
    const auto numbers_at = [&, near = near](const Node& y, LinearPoint& at) {
      double control = near;
      EXPECT_TRUE(flow.find(y, control, at));
      std::vector<Jet> out(at.y.begin(), at.y.end());
      out.push_back(at.multiplier);
      out.push_back(at.hamiltonian);
      return out;
    };
    LinearPoint here, there;
    const std::vector<Jet> numbers = numbers_at(start, here);
    const auto remainder = [&](double by) {
      const std::vector<Jet> moved = numbers_at(start + by * direction, there);
      double largest = 0.0;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        double expected = numbers[i].value;
        for (Eigen::Index j = 0; j < start.size(); ++j) {
          expected += by * direction(j) *
                      numbers[i].gradient[static_cast<std::size_t>(j)];
        }
        largest = std::max(largest, std::abs(moved[i].value - expected));
      }
      return largest;
    };

    const double order = std::log10(remainder(1e-3) / remainder(1e-4));

    EXPECT_NEAR(order, 2.0, 0.1) << "width " << flow.width();
  }
}

/// What another limit is and how it changes while one holds the control.
TEST(ArcFlow, HasTheExactDerivativesOfALimitAlongAnArc) {
  const Scene scene = natural_scene();
  const std::vector<HeldLimit> limits = limits_of_control();
  const ArcFlow flow(scene, limits.front());
  Random random(kSeed);
  const Node start = flow.node_of(random_state(random));
  Node direction(start.size());
  for (double& component : direction) component = random.uniform(-1.0, 1.0);
  for (std::size_t other = 1; other < limits.size(); ++other) {
    const PathInequality& limit = limits[other].limit;
    const AlongArc here = flow.along(limit, start);
    const auto remainder = [&](double by) {
      const AlongArc there = flow.along(limit, start + by * direction);
      double largest = 0.0;
      const auto see = [&](const Jet& from, const Jet& to) {
        double expected = from.value;
        for (Eigen::Index j = 0; j < start.size(); ++j) {
          expected +=
              by * direction(j) * from.gradient[static_cast<std::size_t>(j)];
        }
        largest = std::max(largest, std::abs(to.value - expected));
      };
      see(here.value, there.value);
      see(here.rate, there.rate);
      for (std::size_t i = 0; i < kStates; ++i) {
        see(here.by_state[i], there.by_state[i]);
      }
      return largest;
    };
    constexpr double h = 1e-5;
    const PieceEnd after = end_of(flow, start, 0.0, h);

    EXPECT_NEAR(std::log10(remainder(1e-3) / remainder(1e-4)), 2.0, 0.1)
        << name(limit.kind);
    // Its change over a time so short that the square of it is left.
    EXPECT_NEAR((flow.along(limit, after.y).value.value - here.value.value) / h,
                here.rate.value, 1e-3 * (1.0 + std::abs(here.rate.value)))
        << name(limit.kind);
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
TEST(ArcFlow, HasTheDerivativesOfAnInclineFromRest) {
  // The error of derivatives that a step may have, for a hundred steps.
  constexpr double kOfSteps = 1e-6;
  constexpr double kLength = 0.5;
  for (const double mu : {0.14, 0.2, 0.4, 1.0}) {
    const Scene scene = uniform_under(mu);
    const HeldLimit held = friction_on(scene);
    const double steepest = std::atan(3.0 * mu), A = 1.5;
    const double P = A / std::pow(std::sin(steepest), 2);
    ArcFlow flow(scene, held);
    flow.judge_states_alone();
    const Node rest = flow.node_of(Departure(scene, held, 0.7).left_rest());
    const double u_0 = Departure::kLeftRest, u_1 = u_0 + kLength;

    const PieceEnd end = end_of(flow, rest, 0.0, kLength);

    const double g = scene.gravity;
    EXPECT_NEAR(end.y(static_cast<Eigen::Index>(kBeta)), steepest, 1e-12);
    EXPECT_NEAR(end.y(static_cast<Eigen::Index>(kW)),
                g * u_1 * std::sin(steepest), 1e-12);
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
TEST(Departure, LeavesRestOnTheBorderOfTheStaticCone) {
  constexpr double mu = 0.4;
  const Scene scene = uniform_under(mu);
  const HeldLimit held = friction_on(scene);
  ASSERT_EQ(held.limit.kind, PathInequality::Kind::FrictionBackward);

  const Departure start(scene, held, 0.7);

  EXPECT_EQ(start.kind(), Departure::Kind::Forced);
  EXPECT_NEAR(start.left_rest()[kBeta], std::atan(3.0 * mu), 1e-14);
}

/// With β right to the second order what the limit is off is of the third.
TEST(Departure, KeepsTheLimitNextToRest) {
  constexpr double h = 1e-6;
  const Scene scene = natural_scene();
  for (const HeldLimit& held : limits_of_control()) {
    if (held.limit.kind != PathInequality::Kind::FrictionBackward) continue;
    const Departure start(scene, held, 1.2);
    ASSERT_EQ(start.kind(), Departure::Kind::Forced);
    const auto off = [&](double u) {
      const State y = start.left_rest(u);
      const double q =
          (start.left_rest(u + h)[kBeta] - start.left_rest(u - h)[kBeta]) /
          (2.0 * h);
      return std::abs(value_of(held.limit, scene,
                               TurningPoint<double>{y[kX], y[kZ], y[kTheta],
                                                    y[kW], y[kBeta], q}) -
                      held.bound);
    };

    EXPECT_GE(std::log10(off(1e-1) / off(1e-2)), 2.9);
  }
}

}  // namespace
}  // namespace brachisto::arcs
