// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The shares of the elements add up to the error of T: not a bound, the error
// itself as the mesh is refined.

#include "transcription/extremal_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <ostream>
#include <vector>

#include "brachisto/solvers/program_solvers.hpp"
#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto::testing {
namespace {

/// Between fixed end points of the centre.
Scene between_centres(double theta_m) {
  Scene scene = natural(off_centred_scene(theta_m));
  scene.contact = Contact::Centre;
  return scene;
}

/// The principal extremal, to some 13 digits.
const ExtremalCurve& exact_curve(double theta_m) {
  static std::map<double, ExtremalCurve> curves;
  const auto known = curves.find(theta_m);
  if (known != curves.end()) return known->second;
  SolveOptions options;
  Discretisation& mesh = options.use<brachisto::Collocation>().discretisation;
  mesh.degree = 8;
  mesh.elements = 40;
  const Solution solution = solve(between_centres(theta_m), options);
  return curves.emplace(theta_m, trajectory_of(solution)->curve())
      .first->second;
}

/// The same extremal on another mesh, by Newton's method, which stays near.
ExtremalCurve curve_on(const Mesh& mesh, double theta_m) {
  const ExtremalCurve& exact = exact_curve(theta_m);
  RollingTime problem(exact.scene(), mesh, 0.0);
  const NewtonResult result =
      solve_with_newton(problem, prolong(exact, problem));
  EXPECT_EQ(result.status, Status::Solved);
  return {problem, result.point};
}

struct Case {
  double theta_m;
  int degree;
  std::array<int, 3> elements;  // the finest error well above 1e-12
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << "theta_m " << c.theta_m << ", degree " << c.degree;
}

class ElementErrors : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Degrees, ElementErrors,
                         ::testing::Values(Case{0.0, 1, {20, 40, 80}},
                                           Case{0.0, 2, {12, 24, 48}},
                                           Case{0.0, 3, {10, 14, 20}},
                                           Case{0.0, 4, {8, 10, 12}},
                                           Case{-kPi / 6.0, 1, {20, 40, 80}},
                                           Case{-kPi / 6.0, 2, {12, 24, 48}},
                                           Case{-kPi / 6.0, 3, {10, 14, 20}},
                                           Case{-kPi / 6.0, 4, {8, 10, 12}}));

TEST_P(ElementErrors, AddUpToTheErrorOfTheTime) {
  const Case& c = GetParam();
  const double exact = exact_curve(c.theta_m).transit_time();

  std::array<double, 3> off{};
  for (std::size_t i = 0; i < off.size(); ++i) {
    const ExtremalCurve curve =
        curve_on(uniform_mesh(c.degree, c.elements[i]), c.theta_m);
    const double error = exact - curve.transit_time();
    ASSERT_GT(std::abs(error), 1e-12) << c.elements[i];
    const std::vector<double> shares = element_errors(curve);
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    off[i] = std::abs(sum / error - 1.0);
  }

  // Any wrong factor in the shares would show as a half or more.
  constexpr double kLeft = 0.03;
  EXPECT_LE(off[2], kLeft) << off[0] << ", " << off[1];
  // T − T_h = Σ + O(h^(2p+2)): relative to T − T_h that is O(h²), seen where
  // meshes are doubled.
  if (c.degree <= 2) {
    EXPECT_NEAR(std::log2(off[1] / off[2]), 2.0, 0.5)
        << off[0] << ", " << off[1] << ", " << off[2];
  }
}

TEST(ElementErrors, AreAsManyAsElementsOnAnyMesh) {
  Mesh mesh = uniform_mesh(3, 11);
  for (double& boundary : mesh.boundaries) boundary *= boundary;

  EXPECT_EQ(element_errors(curve_on(mesh, 0.0)).size(), 11u);
}

TEST(ElementErrors, AreNothingButRoundingOnACycloid) {
  // The cycloid is entire in σ; degree 8 on 12 elements resolves it fully.
  Scene scene = natural(uniform_scene());
  scene.contact = Contact::Centre;
  const SolvedProblem solution = solved(scene, uniform_mesh(8, 12), 0.0);

  for (const double error :
       element_errors({solution.problem, solution.point})) {
    // 𝓗 is a difference of terms of order one, multipliers have 1e-12.
    EXPECT_NEAR(error, 0.0, 1e-12);
  }
}

TEST(ElementErrors, PointAtTheElementThatIsTooLong) {
  Mesh mesh = uniform_mesh(4, 24);
  // Four elements become one.
  mesh.boundaries.erase(mesh.boundaries.begin() + 13,
                        mesh.boundaries.begin() + 16);

  const std::vector<double> errors = element_errors(curve_on(mesh, 0.0));

  const auto largest = std::max_element(
      errors.begin(), errors.end(),
      [](double a, double b) { return std::abs(a) < std::abs(b); });
  EXPECT_EQ(largest - errors.begin(), 12);
}

}  // namespace
}  // namespace brachisto::testing
