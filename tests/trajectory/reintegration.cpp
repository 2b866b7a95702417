// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/reintegration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"

namespace brachisto::testing {
namespace {

TEST(Reintegration, RunsDownTheCycloidInTheTimeOfTheClosedForm) {
  // T = ψ_end √(a/g) √(1 + k), here on a mesh that resolves the cycloid to
  // rounding. The integrator has 1e-14 per step, in some hundred steps, and s
  // is found from the polynomials to about as much.
  constexpr double kTolerance = 1e-10;
  for (const Scene& scene : {natural(bead_scene()), natural(uniform_scene())}) {
    const CycloidArc arc = *axisymmetric_optimum(scene);
    const SolvedProblem solution =
        solved(scene, uniform_mesh(6, 12), arc.slope_angle(arc.psi_end));
    const ExtremalCurve curve(solution.problem, solution.point);

    const Reintegration motion = reintegrate(curve);

    ASSERT_TRUE(motion.arrived());
    EXPECT_GT(motion.steps, 5);
    EXPECT_LE(motion.time_error, kTolerance);
    EXPECT_LE(motion.speed_error, kTolerance);
    EXPECT_LE(motion.position_error, kTolerance);
    EXPECT_LE(motion.rotation_error, kTolerance);
    EXPECT_NEAR(curve.transit_time(),
                arc.rolling_time(scene.gravity) * std::sqrt(1.0 + scene.body.k),
                kTolerance);
  }
}

TEST(Reintegration, AgreesForABodyOffItsAxisToTheErrorOfTheMesh) {
  // β between nodes has order p + 1, 9 here: 1e-9 and less.
  for (const double theta_m : {0.0, -kPi / 6.0, 1.0}) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = 8;
    mesh.elements = 30;
    const Solution solution = solve(off_centred_scene(theta_m), options);
    ASSERT_TRUE(trajectory_of(solution)) << solution.message;

    const Reintegration motion = reintegrate(trajectory_of(solution)->curve());

    ASSERT_TRUE(motion.arrived()) << theta_m;
    EXPECT_LE(motion.time_error, 1e-9) << theta_m;
    EXPECT_LE(motion.speed_error, 1e-9) << theta_m;
    EXPECT_LE(motion.position_error, 1e-9) << theta_m;
    EXPECT_LE(motion.rotation_error, 1e-9) << theta_m;
  }
}

TEST(Reintegration, ImprovesWithTheMesh) {
  double before = 1.0;
  for (const int elements : {8, 16, 32}) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = 3;
    mesh.elements = elements;
    const Solution solution = solve(off_centred_scene(), options);
    ASSERT_TRUE(trajectory_of(solution)) << solution.message;

    const Reintegration motion = reintegrate(trajectory_of(solution)->curve());

    ASSERT_TRUE(motion.arrived()) << elements;
    const double error = std::max(motion.time_error, motion.position_error);
    // Order p + 1 or more: 16 times, half of it for coarse meshes.
    EXPECT_LT(error, before / 8.0) << elements << " elements";
    before = error;
  }
}

TEST(Reintegration, OfAPolygonOfSpeedsIsThatOfOneAndTheSamePath) {
  // With p = 1 slopes have kinks and the time between nodes is not that of the
  // states; still the body arrives, and to the same end point its time exceeds
  // the least one by the square of the path's error: order 2, ratio 4.
  double before = 1.0;
  for (const int elements : {5, 10, 20, 40, 80}) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = 1;
    mesh.elements = elements;
    const Solution solution = solve(off_centred_scene(), options);
    ASSERT_TRUE(trajectory_of(solution)) << solution.message;

    const Reintegration motion = reintegrate(trajectory_of(solution)->curve());

    ASSERT_TRUE(motion.arrived()) << elements << describe(motion.end);
    EXPECT_LT(motion.corrected_time_error, *solution.estimated_error);
    EXPECT_LT(motion.corrected_time_error, before / 3.5) << elements;
    before = motion.corrected_time_error;
  }
}

TEST(Reintegration, DoesNotRunOverTheWavesOfABodyThatIsHardlyOffCentred) {
  // 160 turns with waves of 1e-5 and less. An error estimate that does not see
  // them left 1e-9 to 4e-8. Some thousand steps round θ = 1000 by 1e-13 each.
  constexpr double kOfSteps = 1e-10;
  const auto again = [](double radius, double eta_m) {
    Scene scene;
    scene.body = Body::cylinder(radius, eta_m, 0.0, 0.5);
    scene.L = 3.0;
    scene.H = 1.0;
    const Solution solution = solve(scene);
    EXPECT_TRUE(solution.verified()) << solution.message;
    return reintegrate(trajectory_of(solution)->curve());
  };
  for (const double eta_m : {1e-6, 1e-5, 1e-4}) {
    const Reintegration motion = again(0.003, eta_m);
    ASSERT_TRUE(motion.arrived()) << eta_m;
    EXPECT_LE(motion.worst(), kOfSteps) << eta_m;
  }
  // One on its axis has none, however often it turns.
  EXPECT_LT(again(1e-5, 0.0).steps, 1000);
}

TEST(Reintegration, HasASentenceForEveryEnd) {
  for (int i = 0; i <= static_cast<int>(MotionEnd::TooManySteps); ++i) {
    EXPECT_EQ(describe(static_cast<MotionEnd>(i)).find("unknown"),
              std::string_view::npos);
  }
}

TEST(Reintegration, DoesNotArriveWhereTheBodyCannotClimb) {
  // A gentle descent, and a body whose centre of mass comes up on the way by
  // more than the path goes down: 2 r η |cos(θ_m + S/2r) sin(S/2r)| > H.
  Scene scene = natural(scene_of(Body::cylinder(1.0, 0.3, 0.0, 0.5)));
  scene.contact = Contact::Centre;
  scene.H = 0.1;
  const SolvedProblem solution = solved(scene, uniform_mesh(5, 16), 0.0);
  const double S = ExtremalCurve(solution.problem, solution.point).arc_length();
  scene.body.theta_m = kPi - 0.5 * S / scene.body.radius;
  const double end_height = scene.H + scene.body.radius * scene.body.eta_m *
                                          (std::sin(scene.body.theta_m + S) -
                                           std::sin(scene.body.theta_m));
  ASSERT_LT(end_height, 0.0);
  // The same path, the angles of the states included, for the turned body.
  const RollingTime turned(scene, solution.problem.mesh(), 0.0);

  const Reintegration motion = reintegrate({turned, solution.point});

  EXPECT_EQ(motion.end, MotionEnd::ComesToRest) << describe(motion.end);
  EXPECT_GT(motion.share, 0.1);
  EXPECT_LT(motion.share, 1.0);
}

}  // namespace
}  // namespace brachisto::testing
