// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Whether standard errors are what they are called: of a thousand sets of times
// with normal noise, two of them hold the true value in 95.4 %, give or take
// 0.66 %, the standard deviation of a thousand such draws.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "fit/synthetic.hpp"

namespace brachisto {
namespace {

using namespace testing;
using fit::TimedPlace;
using fit::Wanted;
using Shape = GivenPath::Shape;

constexpr double kNoise = 1e-3;  // [s]
constexpr int kSets = 1000;

/// Of each estimate the share of sets in which the truth lies within two
/// standard errors; every set starts from the scene.
template <class Time>
void expect_coverage(const Scene& truth, const Wanted& wanted, int rows,
                     double offset, const Time& time) {
  const std::vector<TimedPlace> exact = timed(truth, rows, kNoise, time);
  const PlaneCurvePtr centre = centre_curve(truth);
  std::vector<double> values;
  Scene scene = truth;
  for (const fit::Parameter* parameter : wanted.parameters) {
    values.push_back(parameter->of(scene));
    parameter->of(scene) *= 0.8;  // where the fit starts
  }
  if (wanted.offset) values.push_back(offset);
  std::vector<int> held(values.size(), 0);
  Normal noise(20261126);
  for (int set = 0; set < kSets; ++set) {
    std::vector<TimedPlace> times = exact;
    for (TimedPlace& row : times) row.t += offset + kNoise * noise();
    const fit::Fit found = fit::fit_times(scene, centre, times, wanted);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const fit::Estimate& estimate = found.estimates[i];
      const double miss = std::abs(estimate.value - values[i]);
      held[i] += miss <= 2.0 * estimate.error ? 1 : 0;
    }
  }
  for (const int count : held) {
    const double share = 100.0 * count / kSets;
    std::printf("two-sigma coverage: %.1f %%\n", share);
    EXPECT_GE(share, 93.0);
    EXPECT_LE(share, 97.5);
  }
}

Wanted wanted(std::initializer_list<const char*> keys, bool offset) {
  Wanted out{{}, offset, true};
  for (const char* key : keys) {
    out.parameters.push_back(fit::find_parameter(key));
  }
  return out;
}

TEST(Coverage, OfFrictionOnAnIncline) {
  Scene scene = led_along(bead_scene(), Shape::Straight);
  scene.world.losses.sliding = 0.1;
  expect_coverage(scene, wanted({"scene.losses.sliding"}, false), 8, 0.0,
                  time_on_incline);
}

TEST(Coverage, OfRollingResistanceAndTheOffsetOnAnIncline) {
  Scene scene = led_along(uniform_scene(), Shape::Straight);
  scene.world.losses.rolling = 0.02;
  expect_coverage(scene, wanted({"scene.losses.rolling"}, true), 8, 0.015,
                  time_on_incline);
}

TEST(Coverage, OfRollingResistanceAndInertiaOnAnArc) {
  Scene scene = led_along(uniform_scene(), Shape::CircularArc);
  scene.world.losses.rolling = 0.02;
  expect_coverage(scene,
                  wanted({"scene.losses.rolling", "scene.body.k"}, false), 12,
                  0.0, time_on_arc);
}

}  // namespace
}  // namespace brachisto
