// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Solutions of the paper's discrete system by the three solvers.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "brachisto/study/solution.hpp"
#include "support/observed_order.hpp"
#include "support/reference_values.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using testing::off_centred_scene;
using Datum = DiscreteReading::Datum;

/// τ as computed elsewhere, in Python with SciPy's fsolve for ε = 10⁻³ and a
/// damped Newton method for the limit ε → 0: four digits behind the point.
struct Elsewhere {
  Datum datum;
  int nodes;
  double tau, tau_limit;
};

constexpr std::array kElsewhere{
    Elsewhere{Datum::Rest, 25, 5.2984, 5.2984},
    Elsewhere{Datum::Rest, 50, 5.1808, 5.1808},
    Elsewhere{Datum::Rest, 100, 5.1273, 5.1274},
    Elsewhere{Datum::Rest, 200, 5.1062, 5.1065},
    Elsewhere{Datum::Release, 25, 5.0751, 5.0751},
    Elsewhere{Datum::Release, 50, 5.0823, 5.0824},
    Elsewhere{Datum::Release, 100, 5.0802, 5.0803},
    Elsewhere{Datum::Release, 200, 5.0796, 5.0799},
};

/// Half a digit, and as much for iterations that end at ‖F‖ = 10⁻⁶.
constexpr double kAgree = 1e-4;

/// What rounding makes of the same iteration: 1e-16 times the condition number
/// of the Jacobian, 6e3 for n = 60, and room for ten times as much.
constexpr double kSameSteps = 1e-11;

DiscreteSystem options_of(int nodes, DiscreteSolver solver, Datum datum) {
  DiscreteSystem options;
  options.nodes = nodes;
  options.solver = solver;
  options.reading.datum = datum;
  return options;
}

TEST(Hybrid, FindsTheSolutionsOfAnIndependentProgram) {
  for (const Elsewhere& row : kElsewhere) {
    if (row.nodes > 100) continue;  // seconds

    const DiscreteAnswer answer = solve_discrete_system(
        off_centred_scene(),
        options_of(row.nodes, DiscreteSolver::Hybrid, row.datum));

    ASSERT_TRUE(answer.solved()) << answer.message;
    EXPECT_NEAR(answer.tau, row.tau, kAgree) << row.nodes;
    EXPECT_LE(answer.residual, DiscreteSystem{}.tolerance);
    EXPECT_EQ(answer.unknowns, 2 * row.nodes + 1);
    EXPECT_EQ(answer.refused_points, 0);
  }
}

TEST(ExactNewton, FindsTheSolutionsOfAnIndependentProgram) {
  for (const auto variant : {DiscreteSolver::Newton, DiscreteSolver::Lifted}) {
    for (const Elsewhere& row : kElsewhere) {
      const DiscreteAnswer answer = solve_discrete_system(
          off_centred_scene(), options_of(row.nodes, variant, row.datum));

      ASSERT_TRUE(answer.solved()) << answer.message;
      EXPECT_NEAR(answer.tau, row.tau_limit, kAgree) << row.nodes;
      EXPECT_EQ(answer.unknowns, variant == DiscreteSolver::Lifted
                                     ? 4 * row.nodes - 1
                                     : 2 * row.nodes + 1);
    }
  }
  EXPECT_NEAR(solve_discrete_system(
                  off_centred_scene(),
                  options_of(400, DiscreteSolver::Lifted, Datum::Rest))
                  .tau,
              5.0985, kAgree);
  EXPECT_NEAR(solve_discrete_system(
                  off_centred_scene(),
                  options_of(400, DiscreteSolver::Lifted, Datum::Release))
                  .tau,
              5.0813, kAgree);
}

TEST(LiftedNewton, GoesTheWayOfTheDenseOne) {
  const DiscreteAnswer dense = solve_discrete_system(
      off_centred_scene(),
      options_of(50, DiscreteSolver::Newton, Datum::Release));
  const DiscreteAnswer lifted = solve_discrete_system(
      off_centred_scene(),
      options_of(50, DiscreteSolver::Lifted, Datum::Release));

  ASSERT_TRUE(dense.solved());
  ASSERT_TRUE(lifted.solved());
  EXPECT_EQ(lifted.iterations, dense.iterations);
  EXPECT_EQ(lifted.evaluations, dense.evaluations);
  EXPECT_NEAR(lifted.tau, dense.tau, kSameSteps);
}

/// Order in 1/n at which τ goes to that of the extremal.
double order_of(Datum datum, const std::array<int, 4>& nodes) {
  const double exact = testing::reference("reference_case").tau;
  std::array<double, 4> h{}, error{};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const DiscreteAnswer answer = solve_discrete_system(
        off_centred_scene(),
        options_of(nodes[i], DiscreteSolver::Lifted, datum));
    EXPECT_TRUE(answer.solved()) << answer.message;
    h[i] = 1.0 / nodes[i];
    error[i] = std::abs(answer.tau - exact);
  }
  return testing::observed_order(h, error);
}

TEST(LiftedNewton, GoesToTheExtremalAtFirstOrderFromRest) {
  // Chords on a smooth path err by 1/n², the singular start adds n^(−3/2) and
  // one-sided end slopes 1/n, which takes over slowly.
  const double order = order_of(Datum::Rest, {200, 400, 800, 1600});

  EXPECT_GE(order, 0.95);
  EXPECT_LE(order, 1.55);
}

TEST(LiftedNewton, GoesToTheExtremalAtOrderOneHalfFromRelease) {
  // The first chord spans the turn of the path from the vertical, an angle like
  // the square root of its length; r cos β of it moves the start.
  const double order = order_of(Datum::Release, {2000, 4000, 8000, 16000});

  EXPECT_GE(order, 0.4);
  EXPECT_LE(order, 0.6);
}

TEST(DiscreteAnswer, DoesNotDependOnUnitsOrGravity) {
  const DiscreteSystem options =
      options_of(60, DiscreteSolver::Lifted, Datum::Release);
  Scene scene = off_centred_scene(-0.3);
  const DiscreteAnswer one = solve_discrete_system(scene, options);
  scene.body.radius *= 7.0;
  scene.L *= 7.0;
  scene.H *= 7.0;
  scene.gravity = 1.6;

  const DiscreteAnswer other = solve_discrete_system(scene, options);

  ASSERT_TRUE(one.solved()) << one.message;
  ASSERT_TRUE(other.solved()) << other.message;
  EXPECT_NEAR(other.tau, one.tau, kSameSteps);
  EXPECT_NEAR(other.centre_path_length, 7.0 * one.centre_path_length,
              7.0 * kSameSteps);
  EXPECT_NEAR(other.transit_time, other.tau * std::sqrt(7.0 / 3.2), 1e-12);
  EXPECT_NEAR(other.centre.back().x, 7.0 * one.centre.back().x,
              7.0 * kSameSteps);
}

TEST(DiscreteAnswer, TouchesBothEnds) {
  const DiscreteAnswer answer = solve_discrete_system(
      off_centred_scene(),
      options_of(80, DiscreteSolver::Lifted, Datum::Release));

  ASSERT_TRUE(answer.solved()) << answer.message;
  ASSERT_EQ(answer.centre.size(), 80u);
  const double r = 1.0 / 3.0;
  const auto distance = [](Point p, double x, double z) {
    return std::hypot(p.x - x, p.z - z);
  };
  EXPECT_NEAR(distance(answer.centre.front(), 0.0, 0.0), r, 1e-6);
  EXPECT_NEAR(distance(answer.centre.back(), 3.0, 1.0), r, 1e-6);
}

TEST(DiscreteAnswer, TellsThatThePrintedDatumHasNoRealTimes) {
  // E_1 = −r cos β_1 < 0 as soon as the first chord leaves the vertical.
  for (const auto variant : {DiscreteSolver::Hybrid, DiscreteSolver::Newton,
                             DiscreteSolver::Lifted}) {
    const DiscreteAnswer answer = solve_discrete_system(
        off_centred_scene(), options_of(50, variant, Datum::Printed));

    EXPECT_EQ(answer.status, Status::NotEvaluable) << answer.message;
    EXPECT_GT(answer.refused_points, 0);
    EXPECT_EQ(answer.tau, 0.0);
    EXPECT_TRUE(answer.centre.empty());
  }
  const DiscreteAnswer hybrid = solve_discrete_system(
      off_centred_scene(),
      options_of(50, DiscreteSolver::Hybrid, Datum::Printed));
  EXPECT_NE(hybrid.message.find("no real number"), std::string::npos)
      << hybrid.message;
  EXPECT_NE(hybrid.message.find("node 1 "), std::string::npos)
      << hybrid.message;
}

TEST(DiscreteAnswer, TellsThatHybridStaysAtTheCycloidOfAShorterScene) {
  Scene scene = off_centred_scene();
  scene.L = 2.0;
  for (const Datum datum : {Datum::Rest, Datum::Release}) {
    const DiscreteAnswer answer = solve_discrete_system(
        scene, options_of(50, DiscreteSolver::Hybrid, datum));

    EXPECT_FALSE(answer.solved());
    EXPECT_EQ(answer.iterations, 0) << answer.message;
    EXPECT_GT(answer.residual, 0.1);
    EXPECT_NE(answer.message.find("progress"), std::string::npos)
        << answer.message;
  }
}

TEST(DiscreteAnswer, StopsAtItsLimits) {
  const DiscreteSystem options =
      options_of(50, DiscreteSolver::Lifted, Datum::Release);
  const Scene scene = off_centred_scene();

  EXPECT_EQ(solve_discrete_system(scene, options, 2).status,
            Status::IterationLimit);
  EXPECT_EQ(
      solve_discrete_system(scene, options, 500, StopCondition(0.0, nullptr))
          .status,
      Status::TimeLimit);
}

TEST(DiscreteAnswer, NeedsACycloidToStartFrom) {
  Scene scene = off_centred_scene();
  scene.body.radius = 1.0;
  scene.L = 1.0;
  scene.H = 0.5;

  const DiscreteAnswer answer = solve_discrete_system(scene, DiscreteSystem{});

  EXPECT_EQ(answer.status, Status::NotReached);
  EXPECT_NE(answer.message.find("cycloid"), std::string::npos);
}

}  // namespace
}  // namespace brachisto
