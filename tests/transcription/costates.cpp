// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/costates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "support/observed_order.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"

namespace brachisto::testing {
namespace {

/// Ipopt's tolerance on the KKT residual, and what multipliers make of it: the
/// problems here are in natural units and well conditioned, and a costate is a
/// multiplier divided by a weight b_j > 1/20.
constexpr double kSolverTolerance = 1e-12;
constexpr double kCostateTolerance = 100.0 * kSolverTolerance;

TEST(Costates, OfACycloidConvergeWithTwiceTheDegree) {
  // With 𝓗 = ∂𝓗/∂β = 0 at the end, where p_w = 0: (p_x, p_z) =
  // −√A (cos β, sin β)/w there.
  const Scene scene = natural(uniform_scene());
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const double phi = arc.slope_angle(arc.psi_end);
  const double size = std::sqrt(1.5) / arc.fall_speed(0.5, arc.psi_end);
  for (const int p : {1, 2}) {
    std::array<double, 4> h{}, error_x{}, error_z{}, error_phi{};
    for (std::size_t level = 0; level < h.size(); ++level) {
      const int elements = 4 << level;
      SolvedProblem solution = solved(scene, uniform_mesh(p, elements), phi);

      const CostateSolution p_end =
          costates(solution.problem, solution.point.x, solution.point.lambda);
      const double slope =
          solution.problem.end_slope(solution.point.x, solution.point.lambda);

      h[level] = 1.0 / elements;
      error_x[level] = std::abs(p_end.p_x + size * std::cos(phi));
      error_z[level] = std::abs(p_end.p_z + size * std::sin(phi));
      error_phi[level] = std::abs(slope - phi);
    }

    // Half an order for the next terms of the series on coarse meshes.
    EXPECT_NEAR(observed_order(h, error_x), 2.0 * p, 0.5) << "degree " << p;
    EXPECT_NEAR(observed_order(h, error_z), 2.0 * p, 0.5) << "degree " << p;
    EXPECT_NEAR(observed_order(h, error_phi), 2.0 * p, 0.5) << "degree " << p;
  }
}

/// Least T to an end moved by (dx, dz), found from the path to where it was
/// before.
double transit_time(const SolvedProblem& near, double dx, double dz) {
  Scene scene = near.problem.scene();
  scene.L += dx;
  scene.H += dz;
  RollingTime problem(scene, near.problem.mesh(), 0.0);
  const SolverResult result = solve_with_ipopt(problem, near.point, {});
  if (result.status != Status::Solved) return std::nan("");
  return problem.set_point(result.point.x) ? problem.eval_f() : std::nan("");
}

TEST(Costates, AreMinusTheSlopeOfTheTransitTime) {
  // T is the objective of the discrete problem and p_x its exact sensitivity,
  // so this holds on any mesh; what is left is the error of the difference,
  // which falls as the square of its step.
  Scene scene = natural(off_centred_scene(-kPi / 6.0));
  scene.contact = Contact::Centre;
  const SolvedProblem solution = solved(scene, uniform_mesh(4, 8), 0.0);

  const CostateSolution p =
      costates(solution.problem, solution.point.x, solution.point.lambda);

  std::array<double, 4> steps{}, error_x{}, error_z{};
  for (std::size_t level = 0; level < steps.size(); ++level) {
    const double d = std::ldexp(0.02, -static_cast<int>(level));
    const auto difference = [&](double dx, double dz) {
      return transit_time(solution, dx, dz) - transit_time(solution, -dx, -dz);
    };
    steps[level] = d;
    error_x[level] = std::abs(p.p_x + difference(d, 0.0) / (2.0 * d));
    error_z[level] = std::abs(p.p_z + difference(0.0, d) / (2.0 * d));
  }
  EXPECT_NEAR(observed_order(steps, error_x), 2.0, 0.1)
      << "errors " << error_x.front() << " … " << error_x.back();
  EXPECT_NEAR(observed_order(steps, error_z), 2.0, 0.1)
      << "errors " << error_z.front() << " … " << error_z.back();
}

TEST(Costates, VanishAtTheEndWhereTheStateIsFree) {
  const SolvedProblem solution =
      solved(natural(off_centred_scene()), uniform_mesh(3, 6), -0.1);

  const CostateSolution p =
      costates(solution.problem, solution.point.x, solution.point.lambda);

  ASSERT_EQ(p.p_theta_nodes.size(), 19U);
  ASSERT_EQ(p.p_w_nodes.size(), 19U);
  ASSERT_EQ(p.p_theta_points.size(), 18U);
  ASSERT_EQ(p.p_w_points.size(), 18U);
  EXPECT_EQ(p.p_theta_nodes.back(), 0.0);
  EXPECT_EQ(p.p_w_nodes.back(), 0.0);
}

TEST(Costates, OfACentredBodyHaveNoTheta) {
  const SolvedProblem solution =
      solved(natural(uniform_scene()), uniform_mesh(3, 6), -0.5);

  const CostateSolution p =
      costates(solution.problem, solution.point.x, solution.point.lambda);

  EXPECT_TRUE(p.p_theta_nodes.empty());
  EXPECT_TRUE(p.p_theta_points.empty());
  EXPECT_EQ(p.p_w_nodes.size(), 19U);
}

TEST(Costates, OfXAndZAreConstantAlongThePath) {
  const SolvedProblem solution =
      solved(natural(off_centred_scene()), uniform_mesh(3, 6), -0.1);
  const VariableLayout& layout = solution.problem.layout();
  const auto& weights = solution.problem.scheme().rule.weights;

  const CostateSolution p =
      costates(solution.problem, solution.point.x, solution.point.lambda);

  for (int c = 0; c < layout.num_points(); ++c) {
    const auto costate = [&](StateComponent component) {
      return -solution.point.lambda[at(layout.defect(c, component))] /
             weights[at(c % 3)];
    };
    EXPECT_NEAR(costate(StateComponent::X), p.p_x, kCostateTolerance)
        << "point " << c;
    EXPECT_NEAR(costate(StateComponent::Z), p.p_z, kCostateTolerance)
        << "point " << c;
  }
}

TEST(Costates, AtNodesAndPointsLieOnOnePolynomialPerElement) {
  // Gauss collocation is its own adjoint: the polynomials integrated backwards
  // to the nodes pass through the multipliers.
  for (const int degree : {1, 2, 3, 5}) {
    const SolvedProblem solution =
        solved(natural(off_centred_scene(-0.4)), uniform_mesh(degree, 6), -0.1);
    const auto& interpolation = solution.problem.scheme().interpolation;

    const CostateSolution p =
        costates(solution.problem, solution.point.x, solution.point.lambda);

    for (int c = 0; c < 6 * degree; ++c) {
      double p_theta = 0.0, p_w = 0.0;
      for (int n = 0; n <= degree; ++n) {
        const std::size_t node = at(c / degree * degree + n);
        p_theta += interpolation(c % degree, n) * p.p_theta_nodes[node];
        p_w += interpolation(c % degree, n) * p.p_w_nodes[node];
      }
      EXPECT_NEAR(p_theta, p.p_theta_points[at(c)], kCostateTolerance)
          << "degree " << degree << " point " << c;
      EXPECT_NEAR(p_w, p.p_w_points[at(c)], kCostateTolerance)
          << "degree " << degree << " point " << c;
    }
  }
}

TEST(EndSlope, IsNotANumberWhereTheHamiltonianHasNoMinimum) {
  SolvedProblem solution =
      solved(natural(uniform_scene()), uniform_mesh(2, 4), -0.5);
  const std::vector<double> no_costates(solution.point.lambda.size());

  EXPECT_TRUE(
      std::isnan(solution.problem.end_slope(solution.point.x, no_costates)));
}

}  // namespace
}  // namespace brachisto::testing
