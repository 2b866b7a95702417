// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "model/cycloid.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;
using testing::ReferenceValue;

// Solves agree to ten times the default tolerance of the mesh.
constexpr double kTolerance = 1e-9;

TEST(StraightGuess, LeadsToTheSameAnswer) {
  SolveOptions options;
  options.use<Collocation>().guess = Guess::Straight;
  for (const auto* row : {&reference("reference_case"), &reference("theta_-30"),
                          &reference("uniform_L3"), &reference("bead_L2")}) {
    const Solution solution = solve(row->scene(), options);

    ASSERT_TRUE(solution.verified()) << row->name << ": " << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), row->tau, kTolerance * row->tau)
        << row->name;
  }
}

TEST(BetweenCentres, ABeadTakesTheTimeOfTheCycloid) {
  // ψ − sin ψ over 1 − cos ψ is L/H: T = ψ √(a/g), for a cylinder √(1 + k)
  // times as much, whatever its radius.
  const double L = 3.0;
  const double H = 1.0;
  double low = 1e-3;
  double high = 2.0 * std::acos(-1.0) - 1e-3;
  for (int i = 0; i < 100; ++i) {
    const double psi = 0.5 * (low + high);
    const bool beyond = (psi - std::sin(psi)) * H > (1.0 - std::cos(psi)) * L;
    (beyond ? high : low) = psi;
  }
  const double a = H / (1.0 - std::cos(low));
  for (const double r : {0.0, 0.1, 2.0}) {
    Scene scene;
    scene.body = r == 0.0 ? Body::bead() : Body::cylinder(r, 0.0, 0.0, 0.5);
    scene.L = L;
    scene.H = H;
    scene.contact = Contact::Centre;
    const double expected =
        low * std::sqrt(a / scene.gravity) * std::sqrt(r == 0.0 ? 1.0 : 1.5);

    const Solution solution = solve(scene);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_NEAR(solution.motion()->transit_time(), expected, 1e-11) << r;
    EXPECT_EQ(solution.effort.final_mesh().passes, 1);
  }
}

TEST(BetweenCentres, AnOffCentredCylinderIsSolvedFromPointToPoint) {
  Scene scene = reference("reference_case").scene();
  scene.contact = Contact::Centre;

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const TrajectoryPoint start = solution.motion()->at(0.0);
  const TrajectoryPoint end = solution.motion()->at(1.0);
  // The end points of the centre are fixed variables: exact but for units.
  EXPECT_NEAR(start.centre.x, 0.0, 1e-15);
  EXPECT_NEAR(start.centre.z, 0.0, 1e-15);
  EXPECT_NEAR(end.centre.x, scene.L, 1e-14);
  EXPECT_NEAR(end.centre.z, scene.H, 1e-14);
}

TEST(BetweenCentres, TheSmoothContactIsTheCaseOfItsOwnEndPoints) {
  // The extremal with smooth contact is by definition the one between fixed
  // centre end points. Solved as such, from points moved to the origin, it has
  // to be the same path.
  const Scene smooth = reference("reference_case").scene();
  const Solution expected = solve(smooth);
  ASSERT_TRUE(expected.verified()) << expected.message;
  const Point from = expected.motion()->at(0.0).centre;
  const Point to = expected.motion()->at(1.0).centre;
  Scene centre = smooth;
  centre.contact = Contact::Centre;
  centre.L = to.x - from.x;
  centre.H = to.z - from.z;

  const Solution solution = solve(centre);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->transit_time(),
              expected.motion()->transit_time(),
              kTolerance * expected.motion()->transit_time());
  EXPECT_NEAR(solution.motion()->end_angle(), expected.motion()->end_angle(),
              100.0 * kTolerance);
}

TEST(PrincipalBranch, IsFollowedFromTheCycloidToTheBodyOfTheScene) {
  for (const auto* row : {&reference("fast"), &reference("r_0.2")}) {
    const Solution solution = solve(row->scene());

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), row->tau, kTolerance * row->tau);
    const std::vector<ContinuationStep>& steps = solution.effort.continuation;
    ASSERT_FALSE(steps.empty()) << row->name;
    EXPECT_EQ(steps.front().eta_m, 0.0);
    EXPECT_DOUBLE_EQ(steps.back().eta_m, row->eta_m);
    for (std::size_t i = 1; i < steps.size(); ++i) {
      EXPECT_GT(steps[i].eta_m, steps[i - 1].eta_m);
    }
  }
}

TEST(PrincipalBranch, StartsAtTheCycloid) {
  const Scene scene = reference("fast").scene();
  Scene centred = scene;
  centred.body.eta_m = 0.0;
  const auto arc = axisymmetric_optimum(centred);
  ASSERT_TRUE(arc);

  const Solution solution = solve(scene);

  ASSERT_FALSE(solution.effort.continuation.empty());
  // On a coarse mesh, but a cycloid is solved to 1e-10 on any.
  EXPECT_NEAR(solution.effort.continuation.front().phi,
              arc->slope_angle(arc->psi_end), 1e-9);
}

TEST(InfeasibleBody, IsVerifiedAndSaysWhatWouldHappen) {
  // So steep and so much off its axis that the body is thrown off the track.
  Scene scene;
  scene.body = Body::cylinder(0.2, 0.8, 0.0, 0.02);
  scene.L = 0.5;
  scene.H = 1.0;

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_FALSE(solution.feasible());
  EXPECT_LT(solution.diagnostics->min_normal_force.value, 0.0);
  ASSERT_FALSE(solution.infeasible_because().empty());
  EXPECT_NE(solution.infeasible_because().front().find("lift off"),
            std::string::npos);
}

Scene leaving_upwards(double L, double r, double eta, double theta_m,
                      double k) {
  Scene scene;
  scene.body = Body::cylinder(r, eta, theta_m, k);
  scene.L = L;
  scene.H = 1.0;
  return scene;
}

TEST(InfeasibleBody, LiftsOffAtTheStartWhereTheSlopeGrowsThere) {
  // β′(0) > 0, found by an independent integration. Of both the normal force is
  // negative up to the first node at most.
  for (const Scene& scene :
       {leaving_upwards(1.4909, 0.4325, 0.8057, -1.8984, 0.3464),
        leaving_upwards(3.7418, 0.4052, 0.83, -2.8464, 0.2303)}) {
    const Solution solution = solve(scene);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_TRUE(solution.diagnostics->at_start.lifts_off());
    EXPECT_LT(solution.diagnostics->min_normal_force.value, 0.0);
    EXPECT_EQ(solution.diagnostics->min_fold_margin.value,
              -std::numeric_limits<double>::infinity());
    const std::vector<std::string> reasons = solution.infeasible_because();
    ASSERT_GE(reasons.size(), 2u);
    EXPECT_NE(reasons[0].find("lift off at the start"), std::string::npos);
    EXPECT_NE(reasons[1].find("folds at the start"), std::string::npos);
  }
}

TEST(InfeasibleBody, IsNotPreferredToAFasterOneThatIsNoWorse) {
  // A slower contact that lifts off at its start as well.
  const Scene scene = leaving_upwards(1.6311, 0.1168, 0.8914, -1.3704, 0.193);
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;

  const Solution solution = solve(scene, options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), 3.59745, 5e-6);
  EXPECT_FALSE(solution.feasible());
}

TEST(InfeasibleBody, IsNeverABeadForItIsHeldByItsWire) {
  Solution solution = solve(reference("bead_L3").scene());
  ASSERT_TRUE(solution.diagnostics);

  solution.diagnostics->min_normal_force.value = -1.0;
  solution.diagnostics->min_fold_margin.value = -1.0;

  EXPECT_TRUE(solution.feasible());
}

TEST(InfeasibleBody, MayHaveSeveralReasons) {
  Solution solution = solve(reference("uniform_L3").scene());
  ASSERT_TRUE(solution.diagnostics);
  EXPECT_TRUE(solution.feasible());

  solution.diagnostics->min_normal_force = {-0.5, 1.25};
  solution.diagnostics->min_fold_margin = {0.0, 2.5};
  solution.diagnostics->folds_back = 0.01;

  const std::vector<std::string> reasons = solution.infeasible_because();
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_NE(reasons[0].find("-0.5 m g at x_b = 1.25"), std::string::npos);
  EXPECT_NE(reasons[1].find("at x_b = 2.5, and runs back by 0.01 m"),
            std::string::npos);
}

TEST(Effort, AddsUp) {
  const Solution solution = solve(reference("reference_case").scene());

  const Effort& effort = solution.effort;
  EXPECT_GE(effort.iterations, effort.final_mesh().first_iterations);
  EXPECT_GE(effort.passes, effort.final_mesh().passes);
  EXPECT_GT(effort.seconds, 0.0);
  EXPECT_GT(effort.certificate_seconds, 0.0);
  EXPECT_LT(effort.certificate_seconds, effort.seconds);
}

TEST(Log, IsKeptIfAskedForOnly) {
  const Scene scene = reference("uniform_L3").scene();

  EXPECT_EQ(solve(scene).effort.log, "");
  EXPECT_NE(solve(scene, {}, {.verbose = true}).effort.log, "");
}

/// Of the uniform cylinder every way leads to the cycloid in closed form.
TEST(Solution, HasOneMotionWhateverTheAnswer) {
  const ReferenceValue& row = reference("uniform_L3");
  SolveOptions pieces;
  pieces.use<Collocation>().discretisation.formulation = Formulation::ArcLength;
  SolveOptions shooting;
  shooting.method = Shooting{};
  GivenPath cycloid;
  cycloid.curve = GivenPath::Curve::Centre;
  cycloid.shape = GivenPath::Shape::Cycloid;
  Scene given = row.scene();
  given.path = std::make_shared<const GivenPath>(cycloid);

  for (Solution solution : {solve(row.scene()), solve(row.scene(), pieces),
                            solve(row.scene(), shooting), solve(given)}) {
    const bool on_pieces =
        answer_as<PiecewiseAnswer>(solution.answer) != nullptr;
    const double tolerance =
        on_pieces ? kDefaultArcLengthTolerance : kTolerance;
    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), row.tau, tolerance * row.tau);
    EXPECT_EQ(solution.program() == nullptr, solution.scene.path != nullptr);
    EXPECT_EQ(solution.discrete(), nullptr);

    solution.discard_answer();

    EXPECT_EQ(solution.motion(), nullptr);
    EXPECT_FALSE(solution.program() || trajectory_of(solution) ||
                 solution.as_neighbour() || solution.diagnostics);
  }
}

TEST(Solve, GivesTheSameNumbersEveryTime) {
  const Scene scene = reference("theta_30").scene();

  const Solution first = solve(scene);
  const Solution second = solve(scene);

  EXPECT_EQ(first.motion()->tau(), second.motion()->tau());
  EXPECT_EQ(first.effort.iterations, second.effort.iterations);
}

}  // namespace
}  // namespace brachisto
