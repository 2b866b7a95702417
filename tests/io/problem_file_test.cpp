// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/io/problem_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <variant>

#include "io/reading.hpp"

namespace brachisto::io {
namespace {

/// Why a path cannot be read; "" if it can.
std::string io_error(const std::filesystem::path& path) {
  try {
    static_cast<void>(read_problem_file(path));
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(ProblemFile, EveryKeyArrives) {
  const ProblemFile problem = read(R"(
version: 1
scene:
  body: {shape: cylinder, radius: 1/3, eta_m: 2/3, theta_m: -30 deg, k: 0.1,
         mass: 2}
  finish: {L: 3, H: 1.5}
  gravity: 1.62
  contact: centre
discretisation: {formulation: rolling_time, tolerance: 1e-8, degree: 4,
                 nodes: 41}
solver:
  method: ipopt
  linear_solver: mumps
  tolerance: 1e-10
  search: principal
  polish: false
  certify: extremal
  guess: random
  seed: 7
  limits: {iterations: 100, seconds: 60}
)");

  const Body& body = problem.scene.body;
  EXPECT_EQ(body.shape, Shape::Cylinder);
  EXPECT_EQ(body.radius, 1.0 / 3.0);
  EXPECT_EQ(body.eta_m, 2.0 / 3.0);
  EXPECT_EQ(body.theta_m, -std::numbers::pi / 6.0);
  EXPECT_EQ(body.k, 0.1);
  EXPECT_EQ(body.mass, 2.0);
  EXPECT_EQ(problem.scene.L, 3.0);
  EXPECT_EQ(problem.scene.H, 1.5);
  EXPECT_EQ(problem.scene.gravity, 1.62);
  EXPECT_EQ(problem.scene.contact, Contact::Centre);
  const auto program = std::get<Collocation>(problem.options.method);
  const Discretisation& mesh = program.discretisation;
  EXPECT_EQ(mesh.formulation, Formulation::RollingTime);
  EXPECT_EQ(mesh.tolerance, 1e-8);
  EXPECT_EQ(mesh.degree, 4);
  EXPECT_EQ(mesh.elements, std::nullopt);
  EXPECT_EQ(mesh.nodes, 41);
  EXPECT_EQ(program.solver, ProgramSolver::Ipopt);
  EXPECT_EQ(program.linear_solver, LinearSolver::Mumps);
  EXPECT_EQ(program.tolerance, 1e-10);
  EXPECT_EQ(program.search, Search::Principal);
  EXPECT_FALSE(program.polish);
  EXPECT_EQ(program.certify, Certify::Extremal);
  EXPECT_EQ(program.guess, Guess::Random);
  EXPECT_EQ(program.seed, 7u);
  EXPECT_EQ(problem.options.limits.iterations, 100);
  EXPECT_EQ(problem.options.limits.seconds, 60.0);
}

TEST(ProblemFile, WordsThatExcludeOtherKeysArrive) {
  EXPECT_TRUE(
      read(kBead + "solver: {method: extremal}\n").options.of<Shooting>());
  EXPECT_TRUE(read(kBead + "solver: {search: global}\n").options.searches());
}

TEST(ProblemFile, ElementsArrive) {
  const ProblemFile problem = read(kBead + "discretisation: {elements: 40}\n");

  EXPECT_EQ(problem.options.of<Collocation>()->discretisation.elements, 40);
}

TEST(ProblemFile, ZeroHasNoSign) {
  const Body body =
      read(cylinder("radius: 1/3, eta_m: -0, theta_m: -0, k: 1/2")).scene.body;

  EXPECT_FALSE(std::signbit(body.eta_m));
  EXPECT_FALSE(std::signbit(body.theta_m));
}

TEST(ProblemFile, AbsentMeshKeysStayAbsent) {
  const ProblemFile problem = read(kBead);
  const Discretisation& mesh =
      problem.options.of<Collocation>()->discretisation;

  EXPECT_FALSE(mesh.tolerance || mesh.degree || mesh.elements || mesh.nodes);
}

TEST(ProblemFile, TheShortestOneIsABead) {
  const Scene scene = read(kBead).scene;

  EXPECT_EQ(scene.body.shape, Shape::Bead);
  EXPECT_EQ(scene.body.mass, std::nullopt);
  EXPECT_TRUE(validate(scene).empty());
}

TEST(ProblemFile, MissingFilesAreIoErrors) {
  EXPECT_EQ(io_error("/nowhere/problem.yaml"),
            "/nowhere/problem.yaml: cannot be opened: No such file or "
            "directory");
}

TEST(ProblemFile, DirectoriesAreIoErrors) {
  EXPECT_EQ(io_error("/"),
            "/: is a directory; expected a problem file, or - for standard "
            "input");
}

TEST(ProblemFile, IsReadFromDisk) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / "brachisto_io_test.yaml";
  std::ofstream(path) << kBead << "version: 3\n";

  std::string message;
  try {
    static_cast<void>(read_problem_file(path));
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_TRUE(message.starts_with(path.string() + ":2:10: version: "))
      << message;
  std::filesystem::remove(path);
}

TEST(ProblemFile, DiagnosticsKeepTheirParts) {
  try {
    static_cast<void>(read(kBead + "version: 3\n", {"x=1"}));
    FAIL() << "must not be read";
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 2U);
    const Diagnostic& first = error.diagnostics()[0];
    EXPECT_EQ(first.file, "p.yaml");
    EXPECT_EQ(first.line, 2);
    EXPECT_EQ(first.column, 10);
    EXPECT_EQ(first.key, "version");
    const Diagnostic& second = error.diagnostics()[1];
    EXPECT_EQ(second.file, "--set x=1");
    EXPECT_EQ(second.line, 0);
    EXPECT_EQ(second.column, 0);
    EXPECT_EQ(second.key, "x");
  }
}

TEST(ProblemFile, AnglesOfManyTurnsAreReducedWithAWarning) {
  const std::string text = cylinder("radius: 1/3, k: 1/2, theta_m: 1e18 deg");

  const ProblemFile problem = read(text);

  EXPECT_EQ(problem.scene.body.theta_m, 280.0 / 180.0 * std::numbers::pi);
  ASSERT_EQ(problem.warnings.size(), 1U);
  EXPECT_EQ(
      to_string(problem.warnings[0]),
      "p.yaml:3:57: scene.body.theta_m: \"1e18 deg\" is more than a "
      "turn; whole turns mean nothing here, and 4.886921906 rad is taken, "
      "which is 280°");
}

TEST(ProblemFile, RadiansOfManyTurnsAreReducedAsFarAsTheyMeanSomething) {
  const auto theta_m = [](const std::string& value) {
    return cylinder("radius: 1/3, k: 1/2, theta_m: " + value);
  };

  const ProblemFile problem = read(theta_m("-1e6"));

  // −1e6 + 159155 · 2π, computed with sixty digits.
  EXPECT_NEAR(problem.scene.body.theta_m, 0.357564167085735, 1e-14);
  EXPECT_EQ(problem.warnings.size(), 1U);
  EXPECT_NE(errors(theta_m("1e12")).find("at most 1e+06 rad"),
            std::string::npos)
      << errors(theta_m("1e12"));
  EXPECT_TRUE(read(theta_m("330 deg")).warnings.empty());
  EXPECT_TRUE(read(theta_m("-2*pi")).warnings.empty());
}

TEST(ProblemFile, TheStartAngleOfAPathIsReducedToo) {
  const ProblemFile problem = read(
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, path: {shape: "
      "circular_arc, start_angle: 3600000000045 deg}}\n");

  EXPECT_EQ(problem.scene.path->start_angle, std::numbers::pi / 4.0);
  EXPECT_EQ(problem.warnings.size(), 1U);
}

}  // namespace
}  // namespace brachisto::io
