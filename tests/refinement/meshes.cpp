// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// How the mesh is chosen, and what becomes of a bad choice.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "model/units.hpp"
#include "refinement/surface_passages.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::reference;

const Scene kScene = reference("reference_case").scene();
constexpr double kTau = reference("reference_case").tau;

TEST(FixedMesh, IsTakenAsItIs) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 3;
  mesh.elements = 17;

  const Solution solution = solve(kScene, options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_EQ(trajectory_of(solution)->curve().mesh().degree, 3);
  EXPECT_EQ(trajectory_of(solution)->curve().mesh().num_elements(), 17);
  EXPECT_EQ(solution.program()->nodes, 3 * 17 + 1);
  // Four states and β at N p nodes and points, and U.
  EXPECT_EQ(solution.program()->variables, 4 * 52 + 51 + 1);
  EXPECT_EQ(solution.program()->constraints, 4 * 51);
}

TEST(FixedMesh, MovesItsEndsToWhereTheyAreWanted) {
  constexpr bool kAsMany = true;
  const Mesh mesh = uniform_mesh(5, 4);
  const auto ends = [&](const std::vector<double>& places) {
    return with_ends_at(mesh, places, kAsMany).boundaries;
  };
  EXPECT_THAT(ends({0.45}), ElementsAre(0.0, 0.25, 0.45, 0.75, 1.0));
  EXPECT_THAT(ends({0.1}), ElementsAre(0.0, 0.1, 0.5, 0.75, 1.0));
  EXPECT_THAT(ends({0.95}), ElementsAre(0.0, 0.25, 0.5, 0.95, 1.0));
  // Each has its own, however near they are.
  EXPECT_THAT(ends({0.27, 0.3}), ElementsAre(0.0, 0.27, 0.3, 0.75, 1.0));
  EXPECT_THAT(ends({0.27, 0.3, 0.31}), ElementsAre(0.0, 0.27, 0.3, 0.31, 1.0));
  // One more where there is none left.
  EXPECT_THAT(ends({0.8, 0.9}), ElementsAre(0.0, 0.25, 0.5, 0.8, 0.9, 1.0));
  EXPECT_THAT(with_ends_at(uniform_mesh(5, 1), {0.4}, kAsMany).boundaries,
              ElementsAre(0.0, 0.4, 1.0));
}

TEST(FixedMesh, HasNoThetaForABodyThatDoesNotNeedIt) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 3;
  mesh.elements = 17;
  for (const auto* row : {&reference("bead_L3"), &reference("uniform_L3")}) {
    const Solution solution = solve(row->scene(), options);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_EQ(solution.program()->variables, 3 * 52 + 51 + 1) << row->name;
    EXPECT_EQ(solution.program()->constraints, 3 * 51) << row->name;
  }
}

TEST(FixedMesh, NodesAreAnotherWayToSayElements) {
  SolveOptions elements;
  elements.use<Collocation>().discretisation.degree = 4;
  elements.use<Collocation>().discretisation.elements = 20;
  SolveOptions nodes;
  nodes.use<Collocation>().discretisation.degree = 4;
  nodes.use<Collocation>().discretisation.nodes = 81;

  const Solution one = solve(kScene, elements);
  const Solution other = solve(kScene, nodes);

  ASSERT_TRUE(one.verified() && other.verified());
  EXPECT_EQ(other.program()->nodes, 81);
  EXPECT_EQ(other.motion()->tau(), one.motion()->tau());
}

TEST(FixedMesh, IsJudgedWithALooseToleranceToo) {
  SolveOptions options;
  auto& program = options.use<Collocation>();
  program.tolerance = 1e-6;
  program.discretisation.degree = 5;
  program.discretisation.elements = 20;

  const Solution solution = solve(kScene, options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_LE(std::abs(solution.motion()->tau() / kTau - 1.0),
            solution.estimated_error.value());
}

/// τ by the extremal method, which knows of no mesh, with its own error.
struct KnownTau {
  double tau, error;
};

KnownTau tau_of_extremal_method() {
  SolveOptions options;
  options.method = Shooting{};
  const Solution solution = solve(kScene, options);
  EXPECT_EQ(solution.status, Status::Solved) << solution.message;
  return {solution.motion()->tau(), *solution.estimated_error};
}

SolveOptions fine_mesh(int degree, int elements) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = degree;
  mesh.elements = elements;
  return options;
}

TEST(AFineMesh, IsJudgedByOneOfAnEighthOfTheElements) {
  const KnownTau known = tau_of_extremal_method();
  ASSERT_NEAR(known.tau, kTau, 2e-12 * kTau);

  const Solution solution = solve(kScene, fine_mesh(5, 4000));

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_EQ(solution.program()->nodes, 20'001);
  const Check* agreement = solution.certificate.find("agreement");
  ASSERT_NE(agreement, nullptr);
  EXPECT_NE(agreement->where.find("4000 elements against 500"),
            std::string::npos)
      << agreement->where;
  EXPECT_EQ(agreement->value, *solution.estimated_error);
  EXPECT_LE(std::abs(solution.motion()->tau() / known.tau - 1.0),
            *solution.estimated_error + known.error);
}

TEST(AFineMesh, OfDegreeOneIsJudgedByDegreeTwo) {
  // An eighth of the elements is far from exact: 2.4e-6 with 200.
  const Solution solution = solve(kScene, fine_mesh(1, 4000));

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_EQ(solution.program()->nodes, 4001);
  const Check* agreement = solution.certificate.find("agreement");
  ASSERT_NE(agreement, nullptr);
  EXPECT_NE(agreement->where.find("degree 1 against 2"), std::string::npos)
      << agreement->where;
  const double error = std::abs(solution.motion()->tau() / kTau - 1.0);
  EXPECT_LE(error, *solution.estimated_error);
  // Order 2 from there: a four-hundredth.
  EXPECT_GT(error, 1e-9);
  EXPECT_LT(error, 2e-8);
}

TEST(AFineMesh, ReportsHonestlyIfMoreIsWantedThanRoundingAllows) {
  const KnownTau known = tau_of_extremal_method();
  for (const auto& [degree, elements] :
       {std::pair{5, 8000}, {3, 4000}, {3, 8000}, {5, 4000}}) {
    SolveOptions options = fine_mesh(degree, elements);
    options.use<Collocation>().discretisation.tolerance = 1e-13;

    const Solution solution = solve(kScene, options);

    const std::string what =
        std::to_string(degree) + " × " + std::to_string(elements);
    ASSERT_EQ(solution.status, Status::Solved)
        << what << ": " << solution.message;
    ASSERT_TRUE(trajectory_of(solution) && solution.estimated_error) << what;
    EXPECT_EQ(solution.program()->nodes, degree * elements + 1) << what;
    EXPECT_LE(std::abs(solution.motion()->tau() / known.tau - 1.0),
              *solution.estimated_error + known.error)
        << what;
    EXPECT_EQ(solution.verified(), solution.not_verified_because().empty());
    const Check* agreement = solution.certificate.find("agreement");
    ASSERT_NE(agreement, nullptr) << what;
    EXPECT_EQ(agreement->threshold, 1e-13) << what;
    EXPECT_EQ(agreement->passed, *solution.estimated_error <= 1e-13) << what;
  }
}

TEST(EveryDegree, FindsTheSameAnswer) {
  // Of p = 1 with N = 200 the tests of convergence foretell 2.4e-6, of p = 2
  // 1.6e-10; from p = 3 on rounding and the KKT tolerance count.
  const auto expected_error = [](int degree) {
    return degree == 1 ? 1e-5 : degree == 2 ? 1e-9 : 1e-11;
  };
  for (int degree = kMinDegree; degree <= kMaxDegree; ++degree) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = degree;
    mesh.elements = 200;

    const Solution solution = solve(kScene, options);

    ASSERT_TRUE(solution.verified()) << degree << ": " << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), kTau, expected_error(degree) * kTau)
        << "degree " << degree;
  }
}

TEST(HighestDegree, SolvesWithTheMeshOfItsOwnChoice) {
  for (const auto* row :
       {&reference("reference_case"), &reference("L4"), &reference("r_0.2")}) {
    SolveOptions options;
    options.use<Collocation>().discretisation.degree = kMaxDegree;

    const Solution solution = solve(row->scene(), options);

    ASSERT_TRUE(solution.verified()) << row->name << ": " << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), row->tau, 1e-9 * row->tau)
        << row->name;
  }
}

TEST(WantedTolerance, IsMetByEveryDegreeAndPaidForInNodes) {
  for (const int degree : {2, 3, 5}) {
    int nodes = 0;
    for (const double tolerance : {1e-4, 1e-7, 1e-9}) {
      SolveOptions options;
      Discretisation& mesh = options.use<Collocation>().discretisation;
      mesh.degree = degree;
      mesh.tolerance = tolerance;

      const Solution solution = solve(kScene, options);

      ASSERT_TRUE(solution.verified())
          << degree << ", " << tolerance << ": " << solution.message;
      EXPECT_NEAR(solution.motion()->tau(), kTau, 10.0 * tolerance * kTau);
      EXPECT_LE(*solution.estimated_error, tolerance);
      EXPECT_GE(solution.program()->nodes, nodes);
      nodes = solution.program()->nodes;
    }
  }
}

TEST(AMeshOfItsOwnChoice, BeginsWhereTheCoarseOneIsTooCoarseToBeJudged) {
  // A mass point next to the rim: A falls to 1e-4, and on the mesh of the
  // continuation 𝓗 has no minimum in β at some places.
  Scene scene = kScene;
  scene.body.eta_m = 0.99;
  scene.body.k = 0.0;
  SolveOptions fixed;
  fixed.use<Collocation>().discretisation.degree = 8;
  fixed.use<Collocation>().discretisation.elements = 60;
  const Solution known = solve(scene, fixed);
  ASSERT_TRUE(trajectory_of(known)) << known.message;
  ASSERT_LT(*known.estimated_error, 1e-8);
  const double tau = known.motion()->tau();

  for (const double tolerance : {1e-6, kDefaultTolerance}) {
    SolveOptions options;
    options.use<Collocation>().discretisation.tolerance = tolerance;

    const Solution solution = solve(scene, options);

    ASSERT_TRUE(solution.verified()) << tolerance << ": " << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), tau,
                (tolerance + *known.estimated_error) * tau);
  }
}

/// A body that is pushed into air, where its loads rise to 48 m g.
Scene slow_in_air() {
  Scene scene;
  scene.body = Body::cylinder(0.39745216497562025, 0.5800789974931027,
                              -0.28009107585877757, 0.17235749599577982);
  scene.L = 4.440204382946029;
  scene.H = 1.0;
  scene.world.air = {.linear = 0.371116511326611,
                     .quadratic = 0.08464722983059579};
  scene.world.start_speed = 0.4448525990743061;
  return scene;
}

void expect_its_extremal_within_the_estimate(const Scene& scene) {
  const Scene natural = in_natural_units(scene);
  const ExtremalSolution extremal = solve_extremal(natural);
  ASSERT_TRUE(extremal.usable()) << extremal.message;

  const Solution solution = solve(scene, {});

  ASSERT_TRUE(solution.verified()) << solution.message;
  const double tau = extremal.transit_time / std::sqrt(natural.H);
  EXPECT_NEAR(solution.motion()->tau(), tau,
              (*solution.estimated_error + extremal.error_estimate) * tau);
}

TEST(AMeshOfItsOwnChoice, BecomesAccurateWhereAnotherOneErredMore) {
  // One degree more errs more on the same elements.
  Scene unlucky;
  unlucky.body = Body::cylinder(0.44674801070213627, 0.4484141455238041,
                                -2.7400420236298535, 0.024513956145787635);
  unlucky.L = 1.5614933768348456;
  unlucky.H = 1.0;
  for (const Scene& scene : {unlucky, slow_in_air()}) {
    expect_its_extremal_within_the_estimate(scene);
  }
}

/// The change of φ from one degree to the next is twice in the estimate: once
/// it is less than the error here, where the finer degree errs to the same
/// side.
TEST(AMeshOfItsOwnChoice, IsJudgedByTwiceTheChangeOfPhi) {
  Scene scene;
  scene.body = Body::cylinder(0.5775706717149177, 0.34194382279239266,
                              -2.8182081439959683, 0.04119549119967858);
  scene.L = 2.2078461650186325;
  scene.H = 1.0;
  expect_its_extremal_within_the_estimate(scene);
}

/// Where the slope that makes 𝓗 minimal jumps, no polynomial comes near it.
TEST(AMeshOfItsOwnChoice, EndsWhereNoMeshOfASmoothPathCanBeAccurate) {
  Scene scene = slow_in_air();
  scene.body.eta_m = 0.8;
  const Solution solution = solve(scene, {});
  EXPECT_FALSE(solution.verified());
  EXPECT_THAT(solution.message, HasSubstr("weierstrass"));
  EXPECT_LT(solution.program()->nodes, 3000);
  EXPECT_THAT(solution.advice(), HasSubstr("a smaller eta_m or less air"));
}

TEST(ACoarseMesh, IsVerifiedIfItsEstimateIsHonest) {
  // One or two digits per turn. The largest threshold is below one, for what is
  // off by as much is no picture of a path.
  for (const auto& [degree, elements] :
       {std::pair{1, 10}, {1, 15}, {1, 20}, {1, 40}, {2, 5}, {2, 8}, {3, 4}}) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = degree;
    mesh.elements = elements;

    const Solution solution = solve(kScene, options);

    ASSERT_TRUE(solution.verified())
        << degree << "×" << elements << ": " << solution.message;
    EXPECT_LE(std::abs(solution.motion()->tau() / kTau - 1.0),
              *solution.estimated_error)
        << degree << "×" << elements;
    for (const Check& check : solution.certificate.checks) {
      if (check.name == "slope_angle") continue;
      EXPECT_LT(check.threshold, 1.0) << check.name;
    }
  }
}

TEST(ACoarseMesh, IsNotVerifiedIfMoreIsWanted) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 2;
  mesh.elements = 8;
  mesh.tolerance = 1e-9;

  const Solution solution = solve(kScene, options);

  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_FALSE(solution.verified());
  ASSERT_NE(solution.certificate.find("agreement"), nullptr);
  EXPECT_FALSE(solution.certificate.find("agreement")->passed);
  ASSERT_EQ(solution.not_verified_because().size(), 1u);
  EXPECT_NE(solution.not_verified_because().front().find("agreement is "),
            std::string::npos);
  EXPECT_EQ(solution.message, "solved, but not verified: " +
                                  solution.not_verified_because().front());
}

TEST(ACoarseMesh, IsNeverVerifiedFarFromTheAnswer) {
  // Without a tolerance a fixed mesh is taken at its word, but for the answer
  // to mean anything it has to be good to some per cent.
  for (const int degree : {1, 2, 3}) {
    for (const int elements : {1, 2, 3, 4, 5}) {
      SolveOptions options;
      Discretisation& mesh = options.use<Collocation>().discretisation;
      mesh.degree = degree;
      mesh.elements = elements;

      const Solution solution = solve(kScene, options);

      if (!solution.verified()) continue;
      EXPECT_NEAR(solution.motion()->tau(), kTau, 0.03 * kTau)
          << "degree " << degree << ", " << elements << " elements";
    }
  }
}

}  // namespace
}  // namespace brachisto
