// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/program_solvers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "model/units.hpp"
#include "refinement/mesh_solve.hpp"
#include "solvers/newton_solver.hpp"
#include "solvers/small_problem.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"
#include "transcription/contact_equation.hpp"

namespace brachisto::testing {
namespace {

/// minimise x₀³/3 − x₂ x₀ + x₁ − x₀ subject to x₁ = x₀, x₂ given: λ = −1 and
/// x₀ = ±√x₂, a minimum and a maximum that meet at x₂ = 0.
class TwoBranches final : public SmallProblem {
 public:
  TwoBranches() : SmallProblem(3) { fix(2, 1.0); }

 private:
  [[nodiscard]] double f() const override {
    return x_[0] * x_[0] * x_[0] / 3.0 - x_[2] * x_[0] + x_[1] - x_[0];
  }
  void grad_f(std::span<double> values) const override {
    values[0] = x_[0] * x_[0] - x_[2] - 1.0;
    values[1] = 1.0;
    values[2] = -x_[0];
  }
  [[nodiscard]] double g() const override { return x_[1] - x_[0]; }
  void grad_g(std::span<double> values) const override {
    values[0] = -1.0;
    values[1] = 1.0;
    values[2] = 0.0;
  }
  void hess_lag(double factor, double /*lambda*/,
                std::span<double> values) const override {
    // Rows 0; 1, 1; 2, 2, 2 of the lower triangle.
    values[0] = factor * 2.0 * x_[0];
    values[1] = values[2] = 0.0;
    values[3] = -factor;
    values[4] = values[5] = 0.0;
  }
};

/// x₂ = φ and φ + x₀ + λ = c: with λ = −1 and x₀ = √φ, φ + √φ = c + 1.
class SumIs final : public nlp::TangencyCondition {
 public:
  SumIs(TwoBranches& problem, double sum) : problem_(problem), sum_(sum) {
    fixed_rates_ = {{2}, {1.0}};
  }

  void set_parameter(double phi) override {
    phi_ = phi;
    problem_.fix(2, phi);
  }
  [[nodiscard]] const Linearisation& linearise(
      std::span<const double> x, std::span<const double> lambda) override {
    at_.residual = phi_ + x[0] + lambda[0] - sum_;
    at_.by_x = {{0}, {1.0}};
    at_.by_lambda = {{0}, {1.0}};
    at_.by_parameter = 1.0;
    return at_;
  }

 private:
  TwoBranches& problem_;
  double sum_;
  double phi_ = 1.0;
};

TEST(NewtonKkt, SolvesForTheParameterToo) {
  TwoBranches problem;
  SumIs tangency(problem, 1.0);

  const NewtonResult result = NewtonSolver(problem, &tangency)
                                  .solve({{1.3, 1.1, 0.7}, {-0.8}}, 0.7, {});

  ASSERT_EQ(result.status, Status::Solved);
  EXPECT_NEAR(result.point.x[0], 1.0, 1e-12);
  EXPECT_NEAR(result.point.x[1], 1.0, 1e-12);
  EXPECT_NEAR(result.point.x[2], 1.0, 1e-12);
  EXPECT_NEAR(result.point.lambda[0], -1.0, 1e-12);
  EXPECT_NEAR(result.phi, 1.0, 1e-12);
  // The problem is left with the values that belong to the result.
  EXPECT_EQ(problem.variable_range(2).lower, result.phi);
}

TEST(NewtonKkt, TellsABranchFromItsNeighbour) {
  // The determinant of the system is −2 x₀ without and, bordered, of either
  // sign; across x₀ = 0 it changes.
  for (const double x_0 : {1.1, -1.1}) {
    TwoBranches problem;

    const NewtonResult result =
        solve_with_newton(problem, {{x_0, x_0, 1.0}, {-1.0}});

    ASSERT_EQ(result.status, Status::Solved);
    EXPECT_NEAR(result.point.x[0], std::copysign(1.0, x_0), 1e-12);
    EXPECT_EQ(result.determinant_sign, x_0 > 0.0 ? -1 : 1);
  }
}

TEST(NewtonKkt, TheSignChangesWhereABranchTurnsBack) {
  // On the branch x₀ = ±√φ, φ ± √φ = c + 1 has a fold in c at x₀ = −1/2: the
  // bordered determinant changes there and not at x₀ = 0, where φ turns.
  const auto sign_at = [](double x_0) {
    TwoBranches problem;
    const double phi = x_0 * x_0;
    SumIs tangency(problem, phi + x_0 - 1.0 + 1e-4);
    return NewtonSolver(problem, &tangency)
        .solve({{x_0, x_0, phi}, {-1.0}}, phi, {})
        .determinant_sign;
  };

  EXPECT_NE(sign_at(0.8), 0);
  EXPECT_EQ(sign_at(0.2), sign_at(0.8));
  EXPECT_EQ(sign_at(-0.2), sign_at(0.8));
  EXPECT_EQ(sign_at(-0.4), sign_at(0.8));
  EXPECT_EQ(sign_at(-0.7), -sign_at(0.8));
  EXPECT_EQ(sign_at(-1.5), -sign_at(0.8));
}

TEST(NewtonKkt, StopsWhereTheSystemIsSingular) {
  TwoBranches problem;

  const NewtonResult result =
      solve_with_newton(problem, {{0.0, 0.0, 1.0}, {-1.0}});

  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_EQ(result.determinant_sign, 0);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.point.x[0], 0.0);
}

/// The base case with p = 3 and N = 10, contact closed.
class OnATrack : public ::testing::Test {
 protected:
  OnATrack() {
    const auto arc = axisymmetric_optimum(problem.scene());
    const MeshSolution solution =
        solve_on_mesh(problem, {cycloid_guess(problem, *arc), 0.0}, {});
    solved = solution.solved();
    point = solution.point;
    phi = solution.tangency.phi;
  }
  void SetUp() override { ASSERT_TRUE(solved); }

  /// The solution with every number changed by up to `size`, but for those
  /// that are fixed.
  [[nodiscard]] PrimalDual shaken(double size, std::uint32_t seed) const {
    Random random(seed);
    PrimalDual out = point;
    for (std::size_t i = 0; i < out.x.size(); ++i) {
      if (problem.variable_range(static_cast<int>(i)).single()) continue;
      out.x[i] += random.uniform(-size, size);
    }
    for (double& value : out.lambda) value += random.uniform(-size, size);
    return out;
  }

  RollingTime problem{in_natural_units(off_centred_scene()),
                      uniform_mesh(3, 10), 0.0};
  PrimalDual point;
  double phi = 0.0;
  bool solved = false;
};

using NewtonKktFor = OnATrack;

TEST_F(NewtonKktFor, ATrackConvergesQuadratically) {
  ContactEquation contact(problem);
  const PrimalDual start = shaken(1e-2, 1);
  std::vector<double> residuals;
  for (int steps = 0; steps <= 5; ++steps) {
    NewtonOptions options;
    options.max_iterations = steps;

    const NewtonResult result =
        NewtonSolver(problem, &contact).solve(start, phi + 1e-2, options);

    // As long as rounding, of numbers of order one, does not show.
    if (result.residual < 1e-13) break;
    residuals.push_back(result.residual);
  }

  // Each residual is at most C times the square of the one before, with one and
  // the same C, of order 10: curvatures of order one times the square of the
  // inverse's norm, as far as the right-hand sides see it.
  constexpr double kConstant = 30.0;
  ASSERT_GE(residuals.size(), 3u);
  for (std::size_t i = 1; i < residuals.size(); ++i) {
    EXPECT_LE(residuals[i], kConstant * residuals[i - 1] * residuals[i - 1])
        << "step " << i;
  }
}

TEST_F(NewtonKktFor, ATrackFindsItsWayBackToTheSolution) {
  ContactEquation contact(problem);
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const NewtonResult result = NewtonSolver(problem, &contact)
                                    .solve(shaken(1e-3, seed), phi - 1e-3, {});

    ASSERT_EQ(result.status, Status::Solved) << "seed " << seed;
    // The residual, below 1e-12, times the norm of the inverse, of order 10².
    EXPECT_NEAR(result.phi, phi, 1e-10) << "seed " << seed;
    EXPECT_LE(result.iterations, 5) << "seed " << seed;
  }
}

TEST_F(NewtonKktFor, ATrackGoesOnToRoundingIfAskedTo) {
  ContactEquation contact(problem);
  NewtonOptions options;
  options.tolerance = 1e-6;
  const NewtonResult soon =
      NewtonSolver(problem, &contact).solve(shaken(1e-4, 1), phi, options);
  options.to_rounding = true;

  const NewtonResult late =
      NewtonSolver(problem, &contact).solve(shaken(1e-4, 1), phi, options);

  ASSERT_EQ(soon.status, Status::Solved);
  ASSERT_EQ(late.status, Status::Solved);
  EXPECT_LT(late.residual, soon.residual);
  // Sums of terms of order one and less.
  EXPECT_LT(late.residual, ulps(100.0));
}

TEST_F(NewtonKktFor, ATrackReportsTheResidualThatThePointHas) {
  ContactEquation contact(problem);
  NewtonOptions options;
  options.max_iterations = 1;

  const NewtonResult result =
      NewtonSolver(problem, &contact).solve(shaken(1e-2, 3), phi, options);

  contact.set_parameter(result.phi);
  const double kkt = nlp::kkt_residual(problem, result.point).max();
  const double tangency =
      std::abs(contact.linearise(result.point.x, result.point.lambda).residual);
  EXPECT_NEAR(result.residual, std::max(kkt, tangency), ulps(100.0));
}

TEST_F(NewtonKktFor, ATrackNeverReturnsAWorsePointThanItsStart) {
  ContactEquation contact(problem);
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    // From a little off to nonsense.
    const double size = std::pow(10.0, 0.1 * seed - 4.0);
    PrimalDual start = shaken(size, seed);
    if (seed > 50) {
      Random random(seed);
      start.x = random_point(problem, random);
    }
    const double phi_start = phi + size;
    contact.set_parameter(phi_start);
    if (!problem.set_point(start.x)) continue;
    const double before =
        std::max(nlp::kkt_residual(problem, start).max(),
                 std::abs(contact.linearise(start.x, start.lambda).residual));

    const NewtonResult result =
        NewtonSolver(problem, &contact).solve(start, phi_start, {});

    ASSERT_TRUE(problem.set_point(result.point.x)) << "seed " << seed;
    const double after = std::max(
        nlp::kkt_residual(problem, result.point).max(),
        std::abs(
            contact.linearise(result.point.x, result.point.lambda).residual));
    EXPECT_NEAR(result.first_residual, before, ulps(1000.0, 1.0 + before));
    EXPECT_LE(after, before * (1.0 + ulps(1000.0))) << "seed " << seed;
    if (result.status == Status::Solved) {
      EXPECT_LE(after, 1.1e-12);
    }
  }
}

TEST_F(NewtonKktFor, ATrackStopsWhenAskedTo) {
  ContactEquation contact(problem);
  const std::atomic<int> flag{2};
  NewtonOptions interrupted;
  interrupted.stop = StopCondition(3600.0, &flag);
  NewtonOptions late;
  late.stop = StopCondition(0.0, nullptr);
  const PrimalDual start = shaken(1e-3, 1);

  const NewtonResult first =
      NewtonSolver(problem, &contact).solve(start, phi, interrupted);
  const NewtonResult second =
      NewtonSolver(problem, &contact).solve(start, phi, late);

  EXPECT_EQ(first.status, Status::Interrupted);
  EXPECT_EQ(second.status, Status::TimeLimit);
  for (const NewtonResult& result : {first, second}) {
    EXPECT_EQ(result.iterations, 0);
    EXPECT_EQ(result.point.x, start.x);
    EXPECT_EQ(result.point.lambda, start.lambda);
    EXPECT_EQ(result.phi, phi);
  }
}

TEST_F(NewtonKktFor, ATrackWithASpeedBelowZeroIsRefused) {
  PrimalDual start = point;
  start.x[static_cast<std::size_t>(
      problem.layout().state(7, StateComponent::W))] = -5.0;

  const NewtonResult result = solve_with_newton(problem, start);

  EXPECT_EQ(result.status, Status::NotEvaluable);
  EXPECT_EQ(result.residual, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.point.x, start.x);
}

TEST_F(NewtonKktFor, ATrackWithANumberThatIsNoneIsNotSolved) {
  for (const bool in_x : {true, false}) {
    PrimalDual start = point;
    (in_x ? start.x : start.lambda)[11] =
        std::numeric_limits<double>::quiet_NaN();

    const NewtonResult result = solve_with_newton(problem, start);

    EXPECT_NE(result.status, Status::Solved) << in_x;
  }
}

}  // namespace
}  // namespace brachisto::testing
