// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Optimal-control problems that are no rolling body: closed forms, derivatives,
// and what is said of mistakes.

#include "brachisto/ocp/least_cost.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "derivatives/taylor_remainders.hpp"
#include "support/observed_order.hpp"
#include "support/random_points.hpp"

namespace brachisto::ocp {
namespace {

using brachisto::testing::kSlack;
using brachisto::testing::kSteps;
using brachisto::testing::observed_order;
using brachisto::testing::Random;
using brachisto::testing::TaylorRemainders;

constexpr double kTolerance = 1e-10;

template <class Problem>
PrimalDual solved(Problem& problem, double duration = 1.0) {
  IpoptOptions options;
  options.tolerance = kTolerance;
  const SolverResult result =
      solve_with_ipopt(problem, problem.straight_guess(duration), options);
  EXPECT_EQ(result.status, Status::Solved) << result.message;
  EXPECT_EQ(result.linear_solver, LinearSolver::Chain);
  EXPECT_LE(nlp::kkt_residual(problem, result.point).max(), 1e-8);
  return result.point;
}

/// s' = v, v' = u.
struct Cart {
  bool least_effort;

  static constexpr std::size_t kStates = 2;
  template <class Scalar>
  [[nodiscard]] Rates<Scalar, 2> rates(const std::array<Scalar, 3>& yu) const {
    const auto& [s, v, u] = yu;
    return {least_effort ? u * u * 0.5 : Scalar(1.0), {v, u}};
  }
  [[nodiscard]] std::size_t num_limits() const { return least_effort ? 0 : 1; }
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t /*number*/,
                             const std::array<Scalar, 3>& yu) const {
    return yu[2];
  }
  [[nodiscard]] Bounds bounds(std::size_t /*number*/) const {
    return {-1.0, 1.0};
  }
  [[nodiscard]] const char* limit_name(std::size_t /*number*/) const {
    return "push";
  }
  [[nodiscard]] const char* state_name(std::size_t i) const {
    return i == 0 ? "s" : "v";
  }
};

constexpr Ends<2> kFromRestToRest{
    .start = {0.0, 0.0}, .end = {1.0, 0.0}, .duration = {}};

/// Half of the way with u = 1, half with u = −1: 1 = (U/2)², and by one more
/// unit of way U grows by dU/ds = 1/√s = 1.
TEST(LeastCost, OfACartInTheLeastTimeIsTwo) {
  LeastCost problem(Cart{.least_effort = false}, uniform_mesh(3, 8),
                    kFromRestToRest);

  const PrimalDual point = solved(problem);

  // To first order the time is longer by Σ z · slack, of which each of the two
  // bounds at a point has at most the tolerance. A multiplier is z = U h b
  // |p_v| with b ≥ 1/9, and p_v = s − 1; at the switch, where that vanishes,
  // the discrete one is free between those of the points beside it, 0.039 at
  // the nearer one, and is taken not to be below kLeast. The way misses Σ U h b
  // · slack at most.
  constexpr double kPoints = 24, kLeast = 0.03;
  const double gap = 2.0 * kPoints * kTolerance;
  const double slack = kTolerance / (2.0 * 0.125 / 9.0 * kLeast);
  const double missed = kPoints * kTolerance / kLeast;
  ASSERT_TRUE(problem.set_point(point.x));
  EXPECT_NEAR(problem.eval_f(), 2.0, gap);
  const auto path = problem.path(point);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& place = path[i];
    // The last point of an element belongs to it.
    const bool first_half = 2 * i < path.size();
    const double way = first_half ? 0.5 * place.s * place.s
                                  : 1.0 - 0.5 * std::pow(2.0 - place.s, 2);
    EXPECT_NEAR(place.states[0], way, missed);
    EXPECT_NEAR(place.control, first_half ? 1.0 : -1.0, slack);
    // dU/ds, of the time and of what it is longer by.
    EXPECT_NEAR(place.costates[0], -1.0, gap);
  }
}

/// u = 6 − 12 t; ∫ u²/2 = 6, p_s = −12, p_v = −u.
TEST(LeastCost, OfACartWithTheLeastEffortIsSix) {
  Ends<2> ends = kFromRestToRest;
  ends.duration = 1.0;
  LeastCost problem(Cart{.least_effort = true}, uniform_mesh(3, 4), ends);

  const PrimalDual point = solved(problem);

  // A quadratic program with polynomials for answers: rounding is left.
  ASSERT_TRUE(problem.set_point(point.x));
  EXPECT_NEAR(problem.eval_f(), 6.0, 1e-12);
  for (const auto& place : problem.path(point)) {
    EXPECT_NEAR(place.control, 6.0 - 12.0 * place.s, 1e-10);
    EXPECT_NEAR(place.costates[0], -12.0, 1e-10);
    EXPECT_NEAR(place.costates[1], -place.control, 1e-10);
  }
}

/// y' = u, ∫ (y² + u²)/2 over [0, 1] from y = 1: the cost to go is
/// ½ tanh(1 − t) y².
struct Regulator {
  static constexpr std::size_t kStates = 1;
  template <class Scalar>
  [[nodiscard]] Rates<Scalar, 1> rates(const std::array<Scalar, 2>& yu) const {
    return {(yu[0] * yu[0] + yu[1] * yu[1]) * 0.5, {yu[1]}};
  }
  [[nodiscard]] std::size_t num_limits() const { return 0; }
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t /*number*/,
                             const std::array<Scalar, 2>& yu) const {
    return yu[1];
  }
  [[nodiscard]] Bounds bounds(std::size_t /*number*/) const {
    return {0.0, 0.0};
  }
  [[nodiscard]] const char* limit_name(std::size_t /*number*/) const {
    return "";
  }
  [[nodiscard]] const char* state_name(std::size_t /*i*/) const { return "y"; }
};

TEST(LeastCost, OfARegulatorFallsAsRadausOrder) {
  const Ends<1> ends{.start = {1.0}, .end = {}, .duration = 1.0};
  std::vector<double> errors, costate_errors;
  const std::vector<double> lengths{0.125, 0.0625, 0.03125};
  for (const double length : lengths) {
    LeastCost problem(Regulator{},
                      uniform_mesh(2, static_cast<int>(1.0 / length)), ends);
    const PrimalDual point = solved(problem);
    ASSERT_TRUE(problem.set_point(point.x));
    errors.push_back(std::abs(problem.eval_f() - 0.5 * std::tanh(1.0)));
    costate_errors.push_back(
        std::abs(problem.path(point).front().costates[0] - std::tanh(1.0)));
  }

  // 2p − 1 = 3 at the ends. The next term changes log(error) by h or less, and
  // so the slope between neighbouring lengths by (0.125 − 0.0625)/ln 2 = 0.09.
  constexpr double kBend = 0.09;
  EXPECT_NEAR(observed_order(lengths, errors), 3.0, kBend);
  EXPECT_NEAR(observed_order(lengths, costate_errors), 3.0, kBend);
}

/// Everything is bent: a pendulum that is driven at its pivot.
struct Pendulum {
  static constexpr std::size_t kStates = 2;
  template <class Scalar>
  [[nodiscard]] Rates<Scalar, 2> rates(const std::array<Scalar, 3>& yu) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto& [angle, speed, u] = yu;
    return {sqrt(u * u + 1.0) - (-(speed * speed)),
            {speed / (u * u + 2.0), u * cos(angle) - sin(angle) * speed}};
  }
  [[nodiscard]] std::size_t num_limits() const { return 2; }
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t number,
                             const std::array<Scalar, 3>& yu) const {
    using std::cos;
    return number == 0 ? yu[1] * yu[2] + cos(yu[0]) : yu[1] * yu[0];
  }
  [[nodiscard]] Bounds bounds(std::size_t number) const {
    return {-1.0, number == 0 ? 1.0 : 2.0};
  }
  [[nodiscard]] const char* limit_name(std::size_t number) const {
    return number == 0 ? "force" : "corner";
  }
  [[nodiscard]] const char* state_name(std::size_t i) const {
    return i == 0 ? "angle" : "speed";
  }
};

TEST(LeastCost, HasDerivativesThatLeaveSquareAndCube) {
  const Mesh mesh{3, {0.0, 0.2, 0.5, 0.9, 1.0}};
  TaylorRemainders remainder;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    LeastCost problem(Pendulum{}, mesh, Ends<2>{});
    std::vector<double> x = random.vector(problem.num_variables(), -1.0, 1.0);
    x.back() = 2.0;
    remainder.add(problem, x,
                  random.vector(problem.num_constraints(), -1.0, 1.0),
                  random.vector(problem.num_variables(), -0.1, 0.1));
  }
  EXPECT_NEAR(observed_order(kSteps, remainder.g()), 2.0, kSlack);
  EXPECT_NEAR(observed_order(kSteps, remainder.lagrangian()), 3.0, kSlack);
}

TEST(LeastCost, NamesStatesLimitsAndPlaces) {
  const LeastCost problem(Pendulum{}, uniform_mesh(2, 3), Ends<2>{});

  // Groups of two states and the control; of two defects and two limits.
  EXPECT_EQ(problem.variable_name(0), "angle[0]");
  EXPECT_EQ(problem.variable_name(4), "speed[1]");
  EXPECT_EQ(problem.variable_name(5), "h u[1]");
  EXPECT_EQ(problem.variable_name(problem.num_variables() - 1), "U");
  EXPECT_EQ(problem.constraint_name(1), "defect of speed[0]");
  EXPECT_EQ(problem.constraint_name(7), "corner[1]");
}

TEST(LeastCost, SaysWhereAPointIsRefused) {
  LeastCost problem(Pendulum{}, uniform_mesh(2, 3), Ends<2>{});
  PrimalDual guess = problem.straight_guess();
  guess.x[7] = std::numeric_limits<double>::quiet_NaN();  // speed at node 2
  EXPECT_FALSE(problem.set_point(guess.x));
  EXPECT_EQ(problem.refusal(),
            "the cost or a rate is not finite at collocation point 1 of 6");
  guess = problem.straight_guess();
  guess.x.back() = 0.0;
  EXPECT_FALSE(problem.set_point(guess.x));
  EXPECT_EQ(problem.refusal(), "the duration is not positive");
}

/// The coarsest meshes: no interior node, one element. Of degree 1 Radau's
/// scheme is implicit Euler's; the cost to go P y²/2 then is, step by step from
/// the end, P = Q/(1 + h Q) with Q = h + P of the step before.
TEST(LeastCost, IsSolvedOnAnyMesh) {
  const Ends<1> ends{.start = {1.0}, .end = {}, .duration = 2.0};
  const auto cost_on = [&](const Mesh& mesh) {
    LeastCost problem(Regulator{}, mesh, ends);
    EXPECT_EQ(problem.straight_guess().x.back(), 2.0);
    const PrimalDual point = solved(problem);
    EXPECT_TRUE(problem.set_point(point.x));
    return problem.eval_f();
  };
  for (const int elements : {1, 8}) {
    const double h = 2.0 / elements;
    double P = 0.0;
    for (int i = 0; i < elements; ++i) P = (h + P) / (1.0 + h * (h + P));
    EXPECT_NEAR(cost_on(uniform_mesh(1, elements)), 0.5 * P, 1e-10);
  }
  // y = cosh(U − t)/cosh U, to the order 2p − 1 = 9 with Radau's constant
  // p! (p − 1)!/((2p)! (2p − 1)!) · U²ᵖ = 2.2e-6 for p = 5, times derivatives
  // of the order of one.
  EXPECT_NEAR(cost_on(uniform_mesh(5, 1)), 0.5 * std::tanh(2.0), 2.2e-6);
}

TEST(LeastCost, ShowsAGuessWithoutCostates) {
  const LeastCost problem(Pendulum{}, uniform_mesh(2, 3), Ends<2>{});
  const auto path = problem.path(problem.straight_guess());
  EXPECT_EQ(path.size(), 7u);
  EXPECT_TRUE(std::isnan(path.back().costates[0]));
  EXPECT_EQ(path.back().s, 1.0);
  EXPECT_THROW((void)problem.path({{1.0, 2.0}, {}}), std::invalid_argument);
}

TEST(LeastCost, RefusesWhatIsNoMeshAndNoDuration) {
  const auto make = [](const Mesh& mesh, std::optional<double> duration) {
    return LeastCost(Pendulum{}, mesh,
                     {.start = {}, .end = {}, .duration = duration});
  };
  EXPECT_THROW(make({0, {0.0, 1.0}}, {}), std::invalid_argument);
  EXPECT_THROW(make({kLargestDegree + 1, {0.0, 1.0}}, {}),
               std::invalid_argument);
  EXPECT_THROW(make({2, {0.0, 0.5, 0.5, 1.0}}, {}), std::invalid_argument);
  EXPECT_THROW(make({2, {0.0, 2.0}}, {}), std::invalid_argument);
  EXPECT_THROW(make({2, {}}, {}), std::invalid_argument);
  EXPECT_THROW(make({2, {0.0, 1.0}}, -1.0), std::invalid_argument);
  EXPECT_NO_THROW(make({2, {0.0, 1.0}}, 1.0));
  Ends<2> nowhere;
  nowhere.end[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(LeastCost(Pendulum{}, uniform_mesh(2, 1), nowhere),
               std::invalid_argument);
}

}  // namespace
}  // namespace brachisto::ocp
