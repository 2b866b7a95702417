// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/extremal_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "support/observed_order.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"

namespace brachisto::testing {
namespace {

using enum StateComponent;

TEST(ExtremalCurve, PassesThroughTheNodes) {
  for (const Scene& scene :
       {natural(uniform_scene()), natural(off_centred_scene(-0.5))}) {
    const SolvedProblem solution =
        solved(scene, {4, {0.0, 0.1, 0.4, 1.0}}, -0.2);
    const VariableLayout& layout = solution.problem.layout();

    const ExtremalCurve curve(solution.problem, solution.point);

    for (int n = 0; n < layout.num_nodes(); ++n) {
      const ExtremalPoint point = curve.at_node(n);
      const auto value = [&](StateComponent component) {
        return solution.point.x[at(layout.state(n, component))];
      };
      // The basis is the unit matrix at the nodes, but for p ε.
      EXPECT_NEAR(point.centre.x, value(X), ulps(4.0, 4.0)) << "node " << n;
      EXPECT_NEAR(point.centre.z, value(Z), ulps(4.0, 4.0)) << "node " << n;
      EXPECT_NEAR(point.w, value(W), ulps(4.0, 4.0)) << "node " << n;
      if (layout.has_theta()) {
        EXPECT_NEAR(point.theta, value(Theta), ulps(4.0, 16.0)) << "node " << n;
      }
    }
  }
}

TEST(ExtremalCurve, HasTheTransitTimeOfTheObjective) {
  SolvedProblem solution =
      solved(natural(off_centred_scene(-0.5)), uniform_mesh(3, 9), -0.2);

  const ExtremalCurve curve(solution.problem, solution.point);

  ASSERT_TRUE(solution.problem.set_point(solution.point.x));
  // Both sum b_j h U √A over 27 points.
  EXPECT_NEAR(curve.transit_time(), solution.problem.eval_f(),
              ulps(27.0, curve.transit_time()));
  EXPECT_EQ(curve.rolling_time(), solution.point.x.back());
}

TEST(ExtremalCurve, RollsByItsArcLength) {
  // Both θ and s collocate U w, θ as an unknown and s by integration.
  const Scene scene = natural(off_centred_scene(-0.5));
  const SolvedProblem solution = solved(scene, uniform_mesh(3, 9), -0.2);

  const ExtremalCurve curve(solution.problem, solution.point);

  // Residuals of 1e-12 in 27 rows, one after the other, over r.
  constexpr double kTolerance = 27.0 * 1e-12 * 3.0;
  for (const double sigma : {0.0, 0.013, 0.5, 0.77, 1.0}) {
    const ExtremalPoint point = curve.at(sigma);
    EXPECT_NEAR(point.theta, scene.body.theta_m + point.s / scene.body.radius,
                kTolerance)
        << "σ " << sigma;
  }
}

TEST(ExtremalCurve, GivesACentredBodyTheAngleItRollsThrough) {
  Scene scene = natural(uniform_scene());
  scene.body.theta_m = 0.4;
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const SolvedProblem solution =
      solved(scene, uniform_mesh(6, 10), arc.slope_angle(arc.psi_end));

  const ExtremalPoint end =
      ExtremalCurve(solution.problem, solution.point).at(1.0);

  // Order 12: 10⁻¹² and below.
  EXPECT_NEAR(end.s, arc.arc_length(arc.psi_end), 1e-11);
  EXPECT_NEAR(end.theta, 0.4 + end.s / scene.body.radius, ulps(4.0, 16.0));
}

TEST(ExtremalCurve, OfACycloidIsItBetweenNodesTooWithOrderDegreePlusOne) {
  const Scene scene = natural(uniform_scene());
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const double phi = arc.slope_angle(arc.psi_end);
  for (const int p : {2, 3}) {
    std::array<double, 4> h{}, error{}, error_beta{};
    for (std::size_t level = 0; level < h.size(); ++level) {
      const int elements = 4 << level;
      const SolvedProblem solution =
          solved(scene, uniform_mesh(p, elements), phi);
      const ExtremalCurve curve(solution.problem, solution.point);
      h[level] = 1.0 / elements;
      for (int i = 1; i < 500; ++i) {
        const double sigma = i / 500.0;
        const ExtremalPoint point = curve.at(sigma);
        const Point exact = arc.at(sigma * arc.psi_end);
        const double beta = arc.slope_angle(sigma * arc.psi_end);
        error[level] =
            std::max({error[level], std::abs(point.centre.x - exact.x),
                      std::abs(point.centre.z - exact.z)});
        error_beta[level] =
            std::max(error_beta[level], std::abs(point.beta - beta));
      }
    }

    EXPECT_NEAR(observed_order(h, error), p + 1.0, 0.5) << "degree " << p;
    // β is the direction of a vector of states and costates; the errors of its
    // components may have that direction themselves, so no upper bound.
    EXPECT_GT(observed_order(h, error_beta), p + 0.5) << "degree " << p;
  }
}

TEST(ExtremalCurve, HasAHamiltonianThatVanishesWithOrderDegreePlusOne) {
  // 𝓗 = 0 along an extremal, since U is free and no rate depends on u.
  const Scene scene = natural(off_centred_scene(-kPi / 6.0));
  for (const int p : {2, 3}) {
    std::array<double, 4> h{}, error{};
    for (std::size_t level = 0; level < h.size(); ++level) {
      const int elements = 8 << level;
      const SolvedProblem solution =
          solved(scene, uniform_mesh(p, elements), -0.1);
      const ExtremalCurve curve(solution.problem, solution.point);
      h[level] = 1.0 / elements;
      for (int i = 1; i < 500; ++i) {
        const ExtremalPoint point = curve.at(i / 500.0);
        error[level] = std::max(
            error[level],
            std::abs(hamiltonian(scene.body, scene.gravity,
                                 {point.theta, point.w}, point.p, point.beta)));
      }
    }

    EXPECT_NEAR(observed_order(h, error), p + 1.0, 0.5)
        << "degree " << p << " errors " << error.front() << " … "
        << error.back();
  }
}

TEST(ExtremalCurve, FindsTheElementOfAnySigma) {
  const SolvedProblem solution =
      solved(natural(off_centred_scene(-0.5)), {3, {0.0, 0.1, 0.4, 1.0}}, -0.2);
  const ExtremalCurve curve(solution.problem, solution.point);
  const auto expect_same = [](const ExtremalPoint& a, const ExtremalPoint& b) {
    EXPECT_NEAR(a.centre.x, b.centre.x, ulps(8.0, 4.0));
    EXPECT_NEAR(a.w, b.w, ulps(8.0, 4.0));
    EXPECT_NEAR(a.t, b.t, ulps(8.0, 8.0));
  };

  expect_same(curve.at(0.0), curve.at_node(0));
  expect_same(curve.at(0.1), curve.at_node(3));
  expect_same(curve.at(0.4), curve.at_node(6));
  expect_same(curve.at(1.0), curve.at_node(9));
  expect_same(curve.at(0.25), curve.at(1, 0.5));
  expect_same(curve.at(0.7), curve.at(2, 0.5));
}

TEST(ExtremalCurve, HasAContinuousSlopeWhateverTurnTheSolverLeft) {
  const SolvedProblem solution =
      solved(natural(off_centred_scene(-0.5)), uniform_mesh(3, 5), -0.2);
  const VariableLayout& layout = solution.problem.layout();
  PrimalDual turned = solution.point;
  turned.x[at(layout.beta(0))] += 2.0 * kPi;
  turned.x[at(layout.beta(7))] -= 4.0 * kPi;

  const ExtremalCurve curve(solution.problem, turned);

  const std::vector<double>& slope = curve.continuous_slope();
  ASSERT_EQ(slope.size(), 15U);
  for (int c = 0; c < layout.num_points(); ++c) {
    EXPECT_NEAR(slope[at(c)], solution.point.x[at(layout.beta(c))],
                ulps(2.0, 4.0 * kPi))
        << "point " << c;
    EXPECT_GT(curve.w_at_points()[at(c)], 0.0) << "point " << c;
  }
}

}  // namespace
}  // namespace brachisto::testing
