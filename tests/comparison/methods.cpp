// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Every method is a problem file that the reader takes, whatever the file said
// before.

#include "comparison/methods.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/reading.hpp"

namespace brachisto::comparison {
namespace {

using Kind = ComparedMethod::Kind;

const std::vector<ComparedMethod> kAll{
    rolling_time(1),           rolling_time(8),
    {.kind = Kind::ArcLength}, {.kind = Kind::Extremal},
    fsolve(FsolveArm::Rest),   fsolve(FsolveArm::Release),
    fsolve(FsolveArm::Newton), fsolve(FsolveArm::Lifted)};

/// Files that state much of what a method has to replace.
const std::vector<std::string> kFiles{
    io::kBead, io::kBead + "discretisation: {degree: 3, elements: 7}\n",
    io::kBead +
        "discretisation: {nodes: 50}\n"
        "solver: {method: fsolve, fsolve: {quadrature: midpoint, "
        "epsilon: 1e-4}}\n",
    io::kBead +
        "solver: {tolerance: 1e-9, polish: false, linear_solver: "
        "mumps, limits: {iterations: 77, seconds: 5}}\n"};

TEST(Methods, AreProblemsThatAreRead) {
  for (const std::string& file : kFiles) {
    for (const ComparedMethod& method : kAll) {
      if (!available(method)) continue;
      EXPECT_EQ(io::errors(file, overrides(method, 20, io::read(file))), "")
          << label(method) << " of\n"
          << file;
    }
  }
}

TEST(Methods, HaveTheMeshTheyAreGiven) {
  const io::ProblemFile base = io::read(kFiles[1]);
  const auto read = [&](const ComparedMethod& method) {
    return io::read(kFiles[1], overrides(method, 20, base)).options;
  };

  const SolveOptions collocation = read(rolling_time(4));
  EXPECT_EQ(collocation.method, Method::Ipopt);
  EXPECT_EQ(collocation.discretisation.degree, 4);
  EXPECT_EQ(collocation.discretisation.elements, 20);
  const SolveOptions rest = read(fsolve(FsolveArm::Rest));
  EXPECT_EQ(rest.method, Method::Fsolve);
  EXPECT_EQ(rest.discretisation.nodes, 20);
  EXPECT_EQ(rest.fsolve.reading.datum, DiscreteReading::Datum::Rest);
  EXPECT_EQ(rest.fsolve.variant, FsolveVariant::Hybrid);
  EXPECT_EQ(read(fsolve(FsolveArm::Newton)).fsolve.variant,
            FsolveVariant::Newton);
  EXPECT_EQ(read({.kind = Kind::Extremal}).method, Method::Extremal);
}

TEST(Methods, TakeTheirSmallestMesh) {
  for (const ComparedMethod& method : kAll) {
    if (!available(method) || !has_meshes(method)) continue;
    const int mesh = smallest_mesh(method);
    EXPECT_EQ(
        io::errors(kFiles[0], overrides(method, mesh, io::read(kFiles[0]))), "")
        << label(method);
  }
}

TEST(Methods, OfCollocationPromiseTwiceTheirDegree) {
  EXPECT_EQ(promised_order(rolling_time(3)), 6);
  EXPECT_EQ(promised_order({.kind = Kind::ArcLength}), 2);
  EXPECT_FALSE(promised_order(fsolve(FsolveArm::Rest)));
}

TEST(Methods, KeepWhatIsNotTheirs) {
  const io::ProblemFile read = io::read(kFiles[2]);
  const io::ProblemFile limits = io::read(kFiles[3]);

  const FsolveOptions fsolve_options =
      io::read(kFiles[2], overrides(fsolve(FsolveArm::Rest), 20, read))
          .options.fsolve;
  EXPECT_EQ(fsolve_options.reading.quadrature,
            DiscreteReading::Quadrature::Midpoint);
  EXPECT_EQ(fsolve_options.reading.epsilon, 1e-4);
  const SolveOptions options =
      io::read(kFiles[3], overrides(rolling_time(2), 20, limits)).options;
  EXPECT_EQ(options.tolerance, 1e-9);
  EXPECT_FALSE(options.polish);
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
