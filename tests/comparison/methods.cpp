// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Every method has options that a solve takes, whatever the problem said
// before.

#include "comparison/methods.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "io/reading.hpp"

namespace brachisto::comparison {
namespace {

using Kind = ComparedMethod::Kind;

const std::vector<ComparedMethod> kAll{rolling_time(1),
                                       rolling_time(8),
                                       {.kind = Kind::Adaptive},
                                       {.kind = Kind::ArcLength},
                                       {.kind = Kind::Extremal},
                                       discrete_system(DiscreteArm::Rest),
                                       discrete_system(DiscreteArm::Release),
                                       discrete_system(DiscreteArm::Newton),
                                       discrete_system(DiscreteArm::Lifted)};

/// Problems that state much of what a method has to replace.
const std::vector<std::string> kFiles{
    io::kBead, io::kBead + "discretisation: {degree: 3, elements: 7}\n",
    io::kBead +
        "discretisation: {nodes: 50}\n"
        "solver: {method: fsolve, fsolve: {quadrature: midpoint, "
        "epsilon: 1e-4}}\n",
    io::kBead +
        "solver: {tolerance: 1e-9, polish: false, linear_solver: "
        "mumps, limits: {iterations: 77, seconds: 5}}\n"};

TEST(Methods, AreAcceptedBySolve) {
  for (const std::string& file : kFiles) {
    const io::ProblemFile base = io::read(file);
    for (const ComparedMethod& method : kAll) {
      for (const int mesh : {smallest_mesh(method), 20}) {
        SolveOptions options =
            options_of(method, {.mesh = mesh, .tolerance = 1e-7}, base.options);
        options.limits.seconds = 1e-9;  // they are checked before

        EXPECT_NO_THROW(static_cast<void>(solve(base.scene, options)))
            << label(method) << " of\n"
            << file;
      }
    }
  }
}

TEST(Methods, HaveTheMeshTheyAreGiven) {
  const SolveOptions base = io::read(kFiles[1]).options;
  const auto of = [&](const ComparedMethod& method) {
    return options_of(method, {.mesh = 20}, base);
  };

  const auto program = std::get<Collocation>(of(rolling_time(4)).method);
  EXPECT_EQ(program.solver, ProgramSolver::Ipopt);
  EXPECT_EQ(program.discretisation.degree, 4);
  EXPECT_EQ(program.discretisation.elements, 20);
  const auto rest =
      std::get<DiscreteSystem>(of(discrete_system(DiscreteArm::Rest)).method);
  EXPECT_EQ(rest.nodes, 20);
  EXPECT_EQ(rest.reading.datum, DiscreteReading::Datum::Rest);
  EXPECT_EQ(rest.solver, DiscreteSolver::Hybrid);
  EXPECT_EQ(
      std::get<DiscreteSystem>(of(discrete_system(DiscreteArm::Newton)).method)
          .solver,
      DiscreteSolver::Newton);
  EXPECT_TRUE(of({.kind = Kind::Extremal}).of<Shooting>());
}

TEST(Methods, ThatAdaptHaveNoMeshOfTheirProblem) {
  const SolveOptions options =
      options_of({.kind = Kind::Adaptive}, {.tolerance = 1e-7},
                 io::read(kFiles[1]).options);

  const auto mesh = std::get<Collocation>(options.method).discretisation;
  EXPECT_FALSE(mesh.fixed());
  EXPECT_FALSE(mesh.degree);
  EXPECT_EQ(mesh.tolerance, 1e-7);
}

TEST(Methods, OfCollocationPromiseTwiceTheirDegree) {
  EXPECT_EQ(promised_order(rolling_time(3), false), 6);
  EXPECT_EQ(promised_order(rolling_time(3), true), 5) << "Radau's points";
  EXPECT_EQ(promised_order({.kind = Kind::ArcLength}, false), 2);
  EXPECT_FALSE(promised_order(discrete_system(DiscreteArm::Rest), false));
}

TEST(Methods, KeepWhatIsNotTheirs) {
  const auto system = std::get<DiscreteSystem>(
      options_of(discrete_system(DiscreteArm::Rest), {.mesh = 20},
                 io::read(kFiles[2]).options)
          .method);
  EXPECT_EQ(system.reading.quadrature, DiscreteReading::Quadrature::Midpoint);
  EXPECT_EQ(system.reading.epsilon, 1e-4);
  const SolveOptions options =
      options_of(rolling_time(2), {.mesh = 20}, io::read(kFiles[3]).options);
  const auto program = std::get<Collocation>(options.method);
  EXPECT_EQ(program.tolerance, 1e-9);
  EXPECT_FALSE(program.polish);
  EXPECT_EQ(options.limits.iterations, 77);
  EXPECT_EQ(options.limits.seconds, 5.0);
}

TEST(Methods, HaveDifferentNames) {
  for (std::size_t i = 0; i < kAll.size(); ++i) {
    EXPECT_EQ(identifier(kAll[i]).find(' '), std::string::npos);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NE(identifier(kAll[i]), identifier(kAll[j]));
    }
  }
}

}  // namespace
}  // namespace brachisto::comparison
