// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The exact linearisations against differences: the remainder of the Taylor
// expansion must fall with the square of the step.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "extremal/boundary.hpp"
#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"
#include "extremal/shooting_system.hpp"
#include "model/hamiltonian.hpp"
#include "model/units.hpp"

namespace brachisto::shooting {
namespace {

constexpr unsigned kSeed = 20260101;

/// Slope of log(remainder) over log(step) between two steps.
double order_of(const std::function<double(double)>& remainder) {
  constexpr double kLarge = 1e-3;
  constexpr double kSmall = 1e-4;
  return std::log(remainder(kLarge) / remainder(kSmall)) /
         std::log(kLarge / kSmall);
}

Scene natural_scene() {
  return in_natural_units(brachisto::testing::base_scene(-0.4));
}

const State kState{0.2, 0.1, 0.7, 0.4, 0.02, -1.5};
const FlowParameters kParameters{-1.2, -0.4, 0.6};
constexpr double kNear = 1.0;

TEST(CanonicalFlow, RatesAreHamiltonsEquations) {
  // f = ∂𝓗/∂p and −∂𝓗/∂y at fixed β, which the envelope theorem allows.
  constexpr double h = 1e-5;
  const Scene scene = natural_scene();
  Body body = scene.body;
  body.eta_m = kParameters.eta;
  const CanonicalFlow flow(scene.body, scene.gravity, kParameters);
  CanonicalFlow::Slope slope;
  ASSERT_TRUE(flow.find_slope(kState, kNear, slope));

  const State rates = flow.rates(kState, slope);

  const auto by = [&](Component component) {
    State up = kState;
    State down = kState;
    up[component] += h;
    down[component] -= h;
    const auto at = [&](const State& y) {
      return hamiltonian(body, scene.gravity, {y[kTheta], y[kW]},
                         {kParameters.p_x, kParameters.p_z, y[kPTheta], y[kPW]},
                         slope.beta);
    };
    return (at(up) - at(down)) / (2.0 * h);
  };
  // Central differences: h² times third derivatives, and rounding over h.
  constexpr double kTolerance = 1e-9;
  EXPECT_NEAR(rates[kTheta], by(kPTheta), kTolerance);
  EXPECT_NEAR(rates[kW], by(kPW), kTolerance);
  EXPECT_NEAR(rates[kPTheta], -by(kTheta), kTolerance);
  EXPECT_NEAR(rates[kPW], -by(kW), kTolerance);
}

TEST(CanonicalFlow, VariationsAreDerivativesOfTheRates) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Scene scene = natural_scene();
  const CanonicalFlow flow(scene.body, scene.gravity, kParameters);
  State v;
  for (double& entry : v) entry = uniform(random);
  const FlowParameters dp{uniform(random), uniform(random), uniform(random)};
  CanonicalFlow::Slope slope;
  ASSERT_TRUE(flow.find_slope(kState, kNear, slope));
  const State rates = flow.rates(kState, slope);
  const State change = flow.variation_rates(kState, slope, v, dp);
  const double slope_change = flow.slope_variation(kState, slope, v, dp);

  const auto remainder = [&](double h) {
    State moved = kState;
    for (std::size_t i = 0; i < kStates; ++i) moved[i] += h * v[i];
    const CanonicalFlow other(
        scene.body, scene.gravity,
        {kParameters.p_x + h * dp.p_x, kParameters.p_z + h * dp.p_z,
         kParameters.eta + h * dp.eta});
    CanonicalFlow::Slope there;
    EXPECT_TRUE(other.find_slope(moved, kNear, there));
    const State rates_there = other.rates(moved, there);
    double sum = std::abs(there.beta - slope.beta - h * slope_change);
    for (std::size_t i = 0; i < kStates; ++i) {
      sum += std::abs(rates_there[i] - rates[i] - h * change[i]);
    }
    return sum;
  };

  EXPECT_NEAR(order_of(remainder), 2.0, 0.05) << "seed " << kSeed;
}

TEST(StartConditions, DerivativesByTheOffsetAreExact) {
  constexpr double kEtaHere = 0.5;
  const Scene scene = natural_scene();
  const InitialState here = start_conditions(scene, kEtaHere);

  const auto remainder = [&](double h) {
    const InitialState there = start_conditions(scene, kEtaHere + h);
    return std::abs(there.x - here.x - h * here.dx_deta) +
           std::abs(there.z - here.z - h * here.dz_deta) +
           std::abs(there.p_w - here.p_w - h * here.dp_w_deta);
  };

  EXPECT_NEAR(order_of(remainder), 2.0, 0.05);
}

/// All rows of the residual in one vector.
std::vector<double> flat(const ChainRows& rows) {
  std::vector<double> out(rows.start.begin(), rows.start.end());
  for (const Vector6& arc : rows.arcs) {
    out.insert(out.end(), arc.begin(), arc.end());
  }
  out.insert(out.end(), rows.end.begin(), rows.end.end());
  return out;
}

/// Jacobian times a direction, in the order of flat().
std::vector<double> product(const ChainJacobian& jacobian,
                            const ChainVector& v) {
  ChainRows rows;
  rows.start = jacobian.start_states * v.nodes.front() +
               jacobian.start_globals * v.globals;
  for (std::size_t i = 0; i < jacobian.arcs.size(); ++i) {
    rows.arcs.push_back(v.nodes[i + 1] - jacobian.arcs[i].states * v.nodes[i] -
                        jacobian.arcs[i].globals * v.globals);
  }
  rows.end =
      jacobian.end_states * v.nodes.back() + jacobian.end_globals * v.globals;
  return flat(rows);
}

TEST(ShootingSystem, JacobianIsTheDerivativeOfTheResidual) {
  constexpr int kArcs = 3;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Scene si = brachisto::testing::base_scene(-0.4);
  const Units units = natural_units(si);
  const ExtremalGuess guess = cycloid_guess(si);
  const ShootingSystem system(in_natural_units(si), kArcs);
  ChainVector point;
  ChainVector v;
  point.globals << guess.rolling_time / units.time, guess.p_x * units.speed(),
      guess.p_z * units.speed(), guess.phi, 0.3;
  for (double& entry : v.globals) entry = uniform(random);
  for (int i = 0; i <= kArcs; ++i) {
    const ExtremalState s = guess.state(1.0 * i / kArcs);
    Vector6 node;
    node << s.x / units.length, s.z / units.length, s.theta,
        s.w / units.speed(), 0.01, s.p_w * units.speed() / units.time;
    point.nodes.push_back(node);
    v.nodes.emplace_back(Vector6::NullaryExpr([&] { return uniform(random); }));
  }
  const StepControl control{.tolerance = 1e-13, .halve = false};
  Linearisation here;
  ASSERT_TRUE(system.evaluate(point, control, here));
  const std::vector<double> residual = flat(here.residual);
  const std::vector<double> slope = product(here.jacobian, v);

  const auto remainder = [&](double h) {
    Linearisation there;
    EXPECT_TRUE(system.evaluate(moved(point, h, v), control, there));
    const std::vector<double> other = flat(there.residual);
    double sum = 0.0;
    for (std::size_t i = 0; i < other.size(); ++i) {
      sum += std::abs(other[i] - residual[i] - h * slope[i]);
    }
    return sum;
  };

  EXPECT_NEAR(order_of(remainder), 2.0, 0.05) << "seed " << kSeed;
}

}  // namespace
}  // namespace brachisto::shooting
