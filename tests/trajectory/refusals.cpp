// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Nothing is verified that is wrong: answers to other questions, each of them
// plausible, and each refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "brachisto/math/index.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "model/start_angle.hpp"
#include "solvers/inertia.hpp"
#include "support/random_points.hpp"
#include "support/scenes.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/sliding_end.hpp"
#include "trajectory/solved_case.hpp"

namespace brachisto::testing {
namespace {

using enum StateComponent;

struct Answer {
  RollingTime problem;
  PrimalDual point;
  double phi;
};

Answer answer_to(const Scene& scene, const Mesh& mesh) {
  const Scene natural = in_natural_units(scene);
  const auto arc = axisymmetric_optimum(natural);
  const double phi = arc->slope_angle(arc->psi_end);
  RollingTime problem(natural, mesh, phi);
  MeshSolution solution =
      solve_on_mesh(problem, {cycloid_guess(problem, *arc), phi, -1.0}, {});
  EXPECT_TRUE(solution.solved()) << solution.message;
  return {std::move(problem), std::move(solution.point), solution.tangency.phi};
}

bool passes(const Certificate& certificate, const char* name) {
  const Check* check = certificate.find(name);
  return check != nullptr && check->passed;
}

TEST(Refused, IsTheAnswerForAnotherBody) {
  Scene other = off_centred_scene();
  other.body.eta_m = 0.66;
  const Mesh mesh = uniform_mesh(5, 24);
  const Answer answer = answer_to(other, mesh);
  RollingTime problem(in_natural_units(off_centred_scene()), mesh, 0.0);

  const Certificate result =
      certify(problem, answer.point, answer.phi, kSolvedError);

  EXPECT_FALSE(result.verified());
  EXPECT_FALSE(passes(result, "kkt_residual"));
  EXPECT_FALSE(passes(result, "defects"));
  EXPECT_FALSE(passes(result, "energy_drift"));
  EXPECT_FALSE(passes(result, "reintegration_error"));
}

TEST(Refused, IsTheAnswerForABodyThatDiffersInOneNumberOnly) {
  const Mesh mesh = uniform_mesh(5, 24);
  const Answer answer = answer_to(off_centred_scene(), mesh);
  for (int change = 0; change < 5; ++change) {
    Scene scene = off_centred_scene();
    if (change == 0) scene.body.k += 1e-6;
    if (change == 1) scene.body.radius += 1e-6;
    if (change == 2) scene.body.theta_m += 1e-6;
    if (change == 3) scene.L += 1e-5;
    if (change == 4) scene.H += 1e-5;
    RollingTime problem(in_natural_units(scene), mesh, 0.0);

    EXPECT_FALSE(
        certify(problem, answer.point, answer.phi, kSolvedError).verified())
        << "change " << change;
  }
}

TEST(Refused, IsAnEndThatSlidesAndBendsTheLastElement) {
  const Mesh mesh = uniform_mesh(1, 40);
  for (const Scene& scene : {uniform_scene(), off_centred_scene()}) {
    Answer answer = answer_to(scene, mesh);
    ASSERT_TRUE(answer.problem.set_point(answer.point.x));
    const double honest = answer.problem.eval_f();
    SlidingEnd sliding(answer.problem);
    PrimalDual start = answer.point;
    start.lambda.clear();
    const SolverResult bent = solve_with_ipopt(sliding, start, {});
    ASSERT_EQ(bent.status, Status::Solved) << bent.message;
    PrimalDual point = bent.point;
    point.lambda.resize(point.lambda.size() - 2);
    ASSERT_TRUE(answer.problem.set_point(point.x));
    // Too fast by per cents: the trap is real.
    EXPECT_LT(answer.problem.eval_f(), 0.99 * honest);

    // Whatever error the mesh is granted, up to one that says nothing.
    for (const double error : {1e-10, 1e-6, 1e-3, 1e-2}) {
      const Certificate result =
          certify(answer.problem, point, sliding.phi(bent.point), error);

      EXPECT_FALSE(result.verified()) << error;
      EXPECT_FALSE(passes(result, "kkt_residual")) << error;
      EXPECT_FALSE(passes(result, "closure")) << error;
    }
  }
}

TEST(Refused, IsATrackWithItsLastSlopesBent) {
  Answer answer = answer_to(off_centred_scene(), uniform_mesh(5, 24));
  const VariableLayout& layout = answer.problem.layout();
  for (int c = layout.num_points() - 3; c < layout.num_points(); ++c) {
    answer.point.x[at(layout.beta(c))] += 0.3;
  }
  for (const double phi : {answer.phi, answer.phi + 0.3}) {
    const Certificate result =
        certify(answer.problem, answer.point, phi, kSolvedError);

    EXPECT_FALSE(result.verified()) << phi;
    EXPECT_FALSE(passes(result, "kkt_residual")) << phi;
    EXPECT_FALSE(passes(result, "defects")) << phi;
  }
}

/// The smooth-contact extremal of a body with the speed w at its start, contact
/// closed.
Answer with_start_speed(const Scene& scene, double start_speed) {
  Answer answer = answer_to(scene, uniform_mesh(5, 24));
  RollingTime& problem = answer.problem;
  const VariableLayout& layout = problem.layout();
  MovedBounds moved(problem);
  moved.fix(layout.state(0, W), start_speed);
  for (int node = 0; node < layout.num_nodes(); ++node) {
    double& w = answer.point.x[at(layout.state(node, W))];
    w = std::hypot(w, start_speed);
  }
  bool closed = false;
  for (int pass = 0; pass < 60 && !closed; ++pass) {
    problem.set_end_angle(answer.phi);
    for (const StateComponent component : {X, Z}) {
      const int end = layout.state(layout.num_points(), component);
      moved.fix(end, problem.variable_range(end).lower);
    }
    const SolverResult result = solve_with_ipopt(moved, answer.point, {});
    EXPECT_EQ(result.status, Status::Solved) << result.message;
    if (result.status != Status::Solved) break;
    answer.point = result.point;
    const double slope = problem.end_slope(answer.point.x, answer.point.lambda);
    closed = std::abs(slope - answer.phi) < 1e-10;
    if (!closed) answer.phi += 0.5 * (slope - answer.phi);
  }
  EXPECT_TRUE(closed);
  return answer;
}

TEST(Refused, IsAFlyingStart) {
  // Optimal, consistent, and the answer to another question.
  for (const double start_speed : {1e-6, 0.05}) {
    Answer answer = with_start_speed(off_centred_scene(), start_speed);

    const Certificate result =
        certify(answer.problem, answer.point, answer.phi, kSolvedError);

    EXPECT_FALSE(result.verified()) << start_speed;
    EXPECT_TRUE(passes(result, "kkt_residual")) << start_speed;
    EXPECT_FALSE(passes(result, "defects")) << start_speed;
  }
}

TEST(Refused, IsTheEnergyCountedFromAInsteadOfTheStartOfTheCentre) {
  // z for z − z(0): a start that is not vertical lies below A for θ_m < 0, and
  // the body sets out with w² = 2 g z(0).
  const Scene scene = off_centred_scene(-kPi / 6.0);
  const Scene natural = in_natural_units(scene);
  const double z_start = start_of_centre(natural).z;
  ASSERT_GT(z_start, 0.01);
  const double speed = std::sqrt(2.0 * natural.gravity * z_start);
  Answer answer = with_start_speed(scene, speed);

  const Certificate result =
      certify(answer.problem, answer.point, answer.phi, kSolvedError);

  EXPECT_FALSE(result.verified());
  EXPECT_FALSE(passes(result, "defects"));
  EXPECT_FALSE(passes(result, "energy_drift"));
  EXPECT_FALSE(passes(result, "reintegration_error"));
}

TEST(Refused, AreMultipliersOfTheWrongSign) {
  Answer answer = answer_to(off_centred_scene(), uniform_mesh(5, 24));
  for (double& value : answer.point.lambda) value = -value;

  const Certificate result =
      certify(answer.problem, answer.point, answer.phi, kSolvedError);

  EXPECT_FALSE(result.verified());
  EXPECT_FALSE(passes(result, "kkt_residual"));
  EXPECT_FALSE(passes(result, "hamiltonian"));
}

TEST(Refused, IsAnExtremalThatIsNoMinimum) {
  // Newton's method goes to any stationary point. On a coarse mesh it finds
  // some that are no minima; their first-order conditions hold to rounding.
  const Scene scene = in_natural_units(off_centred_scene());
  RollingTime problem(scene, uniform_mesh(2, 6), -0.1);
  const auto arc = axisymmetric_optimum(scene);
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 300 && found < 3; ++seed) {
    Random random(seed);
    PrimalDual start = random_guess(problem, *arc, seed);
    start.lambda = cycloid_extremal(problem, *arc).lambda;
    for (double& value : start.lambda) value *= random.uniform(0.3, 2.0);
    NewtonOptions options;
    options.max_iterations = 60;
    options.max_halvings = 8;
    const NewtonResult result = solve_with_newton(problem, start, options);
    if (result.status != Status::Solved) continue;
    const Inertia inertia = kkt_inertia(problem, result.point);
    if (inertia.negative == problem.num_constraints()) continue;
    ++found;

    // As much error as a mesh may have at all.
    const Certificate checks = certify(problem, result.point, -0.1, 1e-2);

    EXPECT_FALSE(checks.verified()) << "seed " << seed;
    EXPECT_TRUE(passes(checks, "kkt_residual")) << "seed " << seed;
    EXPECT_TRUE(passes(checks, "defects")) << "seed " << seed;
    EXPECT_FALSE(passes(checks, "second_order")) << "seed " << seed;
  }
  EXPECT_GE(found, 1);
}

TEST(Refused, IsALoop) {
  Answer answer = answer_to(off_centred_scene(), uniform_mesh(5, 24));
  const VariableLayout& layout = answer.problem.layout();
  // One turn more, spread over the whole path.
  for (int c = 0; c < layout.num_points(); ++c) {
    answer.point.x[at(layout.beta(c))] -=
        2.0 * kPi * (c + 1) / layout.num_points();
  }

  const Certificate result =
      certify(answer.problem, answer.point, answer.phi, kSolvedError);

  EXPECT_FALSE(result.verified());
  EXPECT_FALSE(passes(result, "slope_angle"));
}

TEST(Refused, IsANumberThatIsNoneWhereverItStands) {
  const Answer answer = answer_to(off_centred_scene(), uniform_mesh(3, 8));
  RollingTime problem = answer.problem;
  for (std::size_t i = 0;
       i < answer.point.x.size() + answer.point.lambda.size(); ++i) {
    PrimalDual spoilt = answer.point;
    const std::size_t n = spoilt.x.size();
    (i < n ? spoilt.x[i] : spoilt.lambda[i - n]) =
        std::numeric_limits<double>::quiet_NaN();

    EXPECT_FALSE(certify(problem, spoilt, answer.phi, 1e-2).verified())
        << "number " << i << " of " << n;
  }
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(certify(problem, answer.point, bad, 1e-2).verified());
    if (std::isnan(bad)) {
      EXPECT_FALSE(certify(problem, answer.point, answer.phi, bad).verified());
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
