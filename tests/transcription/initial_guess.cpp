// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/initial_guess.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "support/observed_order.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

double largest_defect(RollingTime& problem, const PrimalDual& guess) {
  if (!problem.set_point(guess.x)) return std::nan("");
  std::vector<double> g(at(problem.num_constraints()));
  problem.eval_g(g);
  double largest = 0.0;
  for (const double defect : g) largest = std::max(largest, std::abs(defect));
  return largest;
}

TEST(CycloidGuess, OfItsOwnBodyHasDefectsOfOrderDegreePlusTwo) {
  // The states interpolate the exact motion with an error of order h^{p+1}; of
  // its slope the leading term, the slope of Π (t − t_i) over Lobatto nodes,
  // vanishes at the Gauss points. D X and h U f are then both off by h^{p+2}.
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    const CycloidArc arc = *axisymmetric_optimum(scene);
    const double phi = arc.slope_angle(arc.psi_end);
    for (int p = 1; p <= 5; ++p) {
      std::array<double, 4> h{}, defect{};
      for (std::size_t level = 0; level < h.size(); ++level) {
        const int elements = 4 << level;
        RollingTime problem(scene, uniform_mesh(p, elements), phi);
        h[level] = 1.0 / elements;
        defect[level] = largest_defect(problem, cycloid_guess(problem, arc));
      }

      // Half an order for the next terms of the series on coarse meshes.
      EXPECT_NEAR(observed_order(h, defect), p + 2.0, 0.5)
          << "degree " << p << " defects " << defect.front() << " … "
          << defect.back();
    }
  }
}

TEST(CycloidGuess, HasTheTransitTimeOfTheClosedForm) {
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    const CycloidArc arc = *axisymmetric_optimum(scene);
    RollingTime problem(scene, uniform_mesh(3, 5),
                        arc.slope_angle(arc.psi_end));

    const PrimalDual guess = cycloid_guess(problem, arc);

    ASSERT_TRUE(problem.set_point(guess.x));
    const double T =
        arc.rolling_time(scene.gravity) * std::sqrt(1.0 + scene.body.k);
    EXPECT_NEAR(problem.eval_f(), T, ulps(8.0, T));
  }
}

/// Both guesses respect the fixed variables, whatever arc they are made of.
TEST(Guesses, RunBetweenTheEndPointsAndAreEvaluable) {
  for (const Scene& scene :
       {bead_scene(), uniform_scene(), off_centred_scene(-0.6)}) {
    RollingTime problem(scene, {3, {0.0, 0.04, 0.3, 1.0}}, 0.25);
    const CycloidArc other{{0.5, 0.5}, 0.3, 4.0};
    for (const PrimalDual& guess :
         {cycloid_guess(problem, other), straight_guess(problem)}) {
      EXPECT_TRUE(problem.set_point(guess.x)) << problem.refusal();
      EXPECT_TRUE(guess.lambda.empty());
      for (int i = 0; i < problem.num_variables(); ++i) {
        const nlp::Range range = problem.variable_range(i);
        if (!range.single()) continue;
        // Shifts of points below 8 that are sums of four terms.
        EXPECT_NEAR(guess.x[at(i)], range.lower, ulps(4.0, 8.0))
            << problem.variable_name(i);
      }
    }
  }
}

TEST(Guesses, TurnTheBodyByTheArcLengthOverTheRadius) {
  const Scene scene = off_centred_scene(-0.6);
  RollingTime problem(scene, uniform_mesh(2, 4), 0.0);
  const CycloidArc arc{{0.5, 0.5}, 0.3, 4.0};
  const int theta_end = problem.layout().state(problem.mesh().num_points(),
                                               StateComponent::Theta);

  const PrimalDual cycloid = cycloid_guess(problem, arc);
  const PrimalDual straight = straight_guess(problem);

  const auto given = [&](int i) { return problem.variable_range(i).upper; };
  const double length = std::hypot(given(theta_end - 2) - given(0),
                                   given(theta_end - 1) - given(1));
  EXPECT_NEAR(cycloid.x[at(theta_end)],
              -0.6 + arc.arc_length(4.0) / scene.body.radius, ulps(4.0, 8.0));
  EXPECT_NEAR(straight.x[at(theta_end)], -0.6 + length / scene.body.radius,
              ulps(4.0, 16.0));
}

TEST(RandomGuess, IsDrawnByItsSeedAlone) {
  const Scene scene = off_centred_scene(-0.6);
  const RollingTime problem(scene, uniform_mesh(3, 5), 0.1);
  const CycloidArc arc = *axisymmetric_optimum(scene);

  EXPECT_EQ(random_guess(problem, arc, 7).x, random_guess(problem, arc, 7).x);
  EXPECT_NE(random_guess(problem, arc, 7).x, random_guess(problem, arc, 8).x);
}

TEST(RandomGuess, ShakesTheCycloidWithinItsBounds) {
  const Scene scene = off_centred_scene(-0.6);
  RollingTime problem(scene, uniform_mesh(4, 25), 0.1);
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const VariableLayout& layout = problem.layout();
  const PrimalDual cycloid = cycloid_guess(problem, arc);
  double largest = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PrimalDual guess = random_guess(problem, arc, seed);

    EXPECT_TRUE(guess.lambda.empty());
    for (int c = 0; c < layout.num_points(); ++c) {
      const double moved =
          std::abs(guess.x[at(layout.beta(c))] - cycloid.x[at(layout.beta(c))]);
      EXPECT_LE(moved, 0.5 + ulps(4.0));
      largest = std::max(largest, moved);
    }
    for (int n = 0; n < layout.num_nodes(); ++n) {
      const std::size_t w = at(layout.state(n, StateComponent::W));
      EXPECT_GE(guess.x[w], 0.5 * cycloid.x[w] * (1.0 - ulps(4.0)));
      EXPECT_LE(guess.x[w], 1.5 * cycloid.x[w] * (1.0 + ulps(4.0)));
    }
  }
  // 2000 draws come close to the bound.
  EXPECT_GT(largest, 0.49);
}

TEST(StraightGuess, OfACentredBodyIsAMotion) {
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    for (int p = 1; p <= 8; ++p) {
      RollingTime problem(scene, {p, {0.0, 0.04, 0.3, 1.0}}, 0.25);

      const PrimalDual guess = straight_guess(problem);

      // Quadratic in σ; p + 1 products with entries of D below 6 p².
      EXPECT_LE(largest_defect(problem, guess),
                ulps(p + 1.0, 8.0 * 6.0 * p * p))
          << "degree " << p;
    }
  }
}

TEST(StraightGuess, MovesOnALevelOrRisingLineToo) {
  Scene scene = uniform_scene();
  scene.body.radius = 2.0;  // the centre ends above its start
  RollingTime problem(scene, uniform_mesh(3, 5), 0.0);

  const PrimalDual guess = straight_guess(problem);

  EXPECT_TRUE(problem.set_point(guess.x)) << problem.refusal();
}

}  // namespace
}  // namespace brachisto::testing
