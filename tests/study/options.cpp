// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What solve() is handed is looked at before it is used.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>

#include "brachisto/study/solve.hpp"
#include "search/continuation.hpp"
#include "support/numbers.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using ::testing::HasSubstr;
using testing::kNaN;
using testing::reference;

/// A way to spoil the options, and what of it has to be said.
struct Spoiled {
  const char* name;
  std::function<void(SolveOptions&)> spoil;
  const char* said;
};
void PrintTo(const Spoiled& spoiled, std::ostream* out) {
  *out << spoiled.name;
}

class WrongOptions : public ::testing::TestWithParam<Spoiled> {};

TEST_P(WrongOptions, AreRefused) {
  SolveOptions options;
  GetParam().spoil(options);

  try {
    static_cast<void>(solve(reference("reference_case").scene(), options));
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().said));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Options, WrongOptions,
    ::testing::Values(
        Spoiled{"no_elements",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.elements = 0;
                },
                "discretisation.elements is 0; allowed is 1 to 10000000"},
        Spoiled{"too_many_elements",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.elements = 2000000000;
                },
                "discretisation.elements is 2000000000"},
        Spoiled{"negative_nodes",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.nodes = -1;
                },
                "discretisation.nodes is -1; allowed is 2 to 80000001"},
        Spoiled{"odd_nodes",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.nodes = 100;
                },
                "nodes − 1 is a multiple of the degree 5"},
        Spoiled{"nodes_and_elements",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.nodes = 101;
                  o.use<Collocation>().discretisation.elements = 20;
                },
                "both fix the mesh"},
        Spoiled{"degree_0",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.degree = 0;
                },
                "discretisation.degree is 0; allowed is 1 to 8"},
        Spoiled{"degree_9",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.degree = 9;
                },
                "discretisation.degree is 9"},
        Spoiled{"tolerance_of_T",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.tolerance = kNaN;
                },
                "discretisation.tolerance is nan"},
        Spoiled{"formulation",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.formulation =
                      static_cast<Formulation>(5);
                },
                "discretisation.formulation has no value 5"},
        Spoiled{"tolerance",
                [](SolveOptions& o) { o.use<Collocation>().tolerance = kNaN; },
                "tolerance is nan; allowed is 1e-14 to 1e-06"},
        Spoiled{"tolerance_0",
                [](SolveOptions& o) { o.use<Collocation>().tolerance = 0.0; },
                "tolerance is 0"},
        Spoiled{"method",
                [](SolveOptions& o) {
                  o.use<Collocation>().solver = static_cast<ProgramSolver>(17);
                },
                "solver has no value 17"},
        Spoiled{"linear_solver",
                [](SolveOptions& o) {
                  o.use<Collocation>().linear_solver =
                      static_cast<LinearSolver>(-1);
                },
                "linear_solver has no value -1"},
        Spoiled{"threads",
                [](SolveOptions& o) { o.use<Collocation>().threads = 0; },
                "threads is 0"},
        Spoiled{"search",
                [](SolveOptions& o) {
                  o.use<Collocation>().search = static_cast<Search>(2);
                },
                "search has no value 2"},
        Spoiled{"sensitivities",
                [](SolveOptions& o) {
                  o.use<Collocation>().sensitivities =
                      static_cast<SensitivityOrder>(3);
                },
                "sensitivities has no value 3"},
        Spoiled{"certify",
                [](SolveOptions& o) {
                  o.use<Collocation>().certify = static_cast<Certify>(3);
                },
                "certify has no value 3"},
        Spoiled{"guess",
                [](SolveOptions& o) {
                  o.use<Collocation>().guess = static_cast<Guess>(3);
                },
                "guess has no value 3"},
        Spoiled{"seconds", [](SolveOptions& o) { o.limits.seconds = kNaN; },
                "limits.seconds is nan"},
        Spoiled{"no_seconds", [](SolveOptions& o) { o.limits.seconds = 0.0; },
                "limits.seconds is 0"},
        Spoiled{"iterations", [](SolveOptions& o) { o.limits.iterations = -3; },
                "limits.iterations is -3"},
        Spoiled{"discrete_nodes",
                [](SolveOptions& o) { o.use<DiscreteSystem>().nodes = 2; },
                "nodes is 2; allowed is 3"},
        Spoiled{"discrete_solver",
                [](SolveOptions& o) {
                  o.use<DiscreteSystem>().solver =
                      static_cast<DiscreteSolver>(3);
                },
                "solver has no value 3"},
        Spoiled{"quadrature",
                [](SolveOptions& o) {
                  o.use<DiscreteSystem>().reading.quadrature =
                      static_cast<DiscreteReading::Quadrature>(9);
                },
                "quadrature has no value 9"},
        Spoiled{"epsilon",
                [](SolveOptions& o) {
                  o.use<DiscreteSystem>().reading.epsilon = -1.0;
                },
                "epsilon is -1"},
        Spoiled{"arc_length",
                [](SolveOptions& o) {
                  o.use<Collocation>().discretisation.formulation =
                      Formulation::ArcLength;
                  o.use<Collocation>().discretisation.elements = 7;
                },
                "arc_length has no degree, 8 pieces or more"}));

TEST(WrongOptions, AreToldAllAtOnce) {
  SolveOptions options;
  options.use<Collocation>().tolerance = 1.0;
  options.limits.iterations = 0;

  try {
    static_cast<void>(solve(reference("reference_case").scene(), options));
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("tolerance is 1;"));
    EXPECT_THAT(error.what(), HasSubstr("limits.iterations is 0;"));
  }
}

TEST(WrongOptions, OfAGivenPathAreRefusedToo) {
  Scene scene = reference("reference_case").scene();
  scene.path = std::make_shared<const GivenPath>();
  SolveOptions options;
  options.use<Collocation>().discretisation.tolerance = kNaN;

  EXPECT_THROW(static_cast<void>(solve(scene, options)), std::invalid_argument);
}

TEST(RightOptions, MayLieOnTheirBounds) {
  SolveOptions options;
  auto& program = options.use<Collocation>();
  program.tolerance = 1e-6;
  program.discretisation.degree = 8;
  program.discretisation.tolerance = 1e-13;
  options.limits.seconds = std::numeric_limits<double>::infinity();

  EXPECT_NO_THROW(
      static_cast<void>(solve(reference("reference_case").scene(), options)));
}

/// A way to spoil a neighbour.
struct Broken {
  const char* name;
  std::function<void(Neighbour&)> spoil;
};
void PrintTo(const Broken& broken, std::ostream* out) {
  *out << broken.name;
}

class BrokenNeighbour : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenNeighbour, IsNotUsed) {
  const auto& row = reference("reference_case");
  Scene near = row.scene();
  near.body.eta_m -= 0.01;
  Neighbour neighbour = *solve(near).as_neighbour();
  GetParam().spoil(neighbour);

  const Solution solution = solve(row.scene(), {}, {.neighbour = &neighbour});

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), row.tau,
              2.0 * kDefaultTolerance * row.tau);
  // From the cycloid.
  EXPECT_EQ(solution.effort.continuation.front().eta_m, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Neighbours, BrokenNeighbour,
    ::testing::Values(
        Broken{"short_x", [](Neighbour& n) { n.point.x.pop_back(); }},
        Broken{"no_point", [](Neighbour& n) { n.point = {}; }},
        Broken{"long_lambda",
               [](Neighbour& n) { n.point.lambda.push_back(0); }},
        Broken{"nan_in_x", [](Neighbour& n) { n.point.x[5] = kNaN; }},
        Broken{"nan_in_lambda", [](Neighbour& n) { n.point.lambda[5] = kNaN; }},
        Broken{"nan_phi", [](Neighbour& n) { n.phi = kNaN; }},
        Broken{"no_mesh", [](Neighbour& n) { n.mesh = {}; }},
        Broken{"mesh_out_of_order",
               [](Neighbour& n) {
                 std::swap(n.mesh.boundaries[1], n.mesh.boundaries[2]);
               }},
        Broken{"mesh_with_nan",
               [](Neighbour& n) { n.mesh.boundaries[1] = kNaN; }},
        Broken{"degree", [](Neighbour& n) { n.mesh.degree = -2; }},
        Broken{"scene", [](Neighbour& n) { n.scene.H = -1.0; }},
        Broken{"at_rest",
               [](Neighbour& n) {
                 std::fill(n.point.x.begin(), n.point.x.end(), 0.0);
               }},
        Broken{"far_off", [](Neighbour& n) {
                 for (double& value : n.point.x) value *= 1e200;
               }}));

TEST(GoodNeighbour, IsUsed) {
  const auto& row = reference("reference_case");
  Scene near = row.scene();
  near.body.eta_m -= 0.01;
  const Neighbour neighbour = *solve(near).as_neighbour();

  const Solution solution = solve(row.scene(), {}, {.neighbour = &neighbour});

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_EQ(solution.effort.continuation.front().eta_m, near.body.eta_m);
}

}  // namespace
}  // namespace brachisto
