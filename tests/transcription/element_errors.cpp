// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The shares of the elements add up to the error of T: not a bound, the error
// itself as the mesh is refined.

#include "brachisto/transcription/element_errors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <ostream>
#include <vector>

#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"

namespace brachisto::testing {
namespace {

/// Between fixed end points of the centre.
Scene between_centres(double theta_m) {
  Scene scene = natural(off_centred_scene(theta_m));
  scene.contact = Contact::Centre;
  return scene;
}

ExtremalCurve curve_on(const Scene& scene, const Mesh& mesh) {
  const SolvedProblem solution = solved(scene, mesh, 0.0);
  return {solution.problem, solution.point};
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
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
INSTANTIATE_TEST_SUITE_P(
    Degrees, ElementErrors,
    ::testing::Values(Case{0.0, 1, {20, 40, 80}}, Case{0.0, 2, {12, 24, 48}},
                      Case{0.0, 3, {10, 14, 20}}, Case{0.0, 4, {8, 10, 12}},
                      Case{-kPi / 6.0, 1, {20, 40, 80}},
                      Case{-kPi / 6.0, 2, {12, 24, 48}},
                      Case{-kPi / 6.0, 3, {10, 14, 20}},
                      Case{-kPi / 6.0, 4, {8, 10, 12}}));

TEST_P(ElementErrors, AddUpToTheErrorOfTheTime) {
  const Case& c = GetParam();
  const Scene scene = between_centres(c.theta_m);
  const double exact = curve_on(scene, uniform_mesh(8, 40)).transit_time();

  // T − T_h = Σ + O(h^(2p+2)): what is missing falls by h² faster than T − T_h,
  // so the constant of h² in the ratio is bounded by its value on the first
  // mesh.
  std::array<double, 3> scaled{};
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const ExtremalCurve curve =
        curve_on(scene, uniform_mesh(c.degree, c.elements[i]));
    const double error = exact - curve.transit_time();
    ASSERT_GT(std::abs(error), 100.0 * ulps(100.0)) << c.elements[i];
    const double ratio = sum(element_errors(curve)) / error;

    EXPECT_NEAR(ratio, 1.0, 0.5) << c.elements[i] << " elements";
    scaled[i] = std::abs(ratio - 1.0) * c.elements[i] * c.elements[i];
  }
  constexpr double kDrift = 2.0;
  EXPECT_LE(scaled[2], kDrift * std::max(scaled[0], scaled[1]))
      << scaled[0] << ", " << scaled[1] << ", " << scaled[2];
}

TEST(ElementErrors, AreAsManyAsElementsOnAnyMesh) {
  Mesh mesh = uniform_mesh(3, 11);
  for (double& boundary : mesh.boundaries) boundary *= boundary;
  const ExtremalCurve curve = curve_on(between_centres(0.3), mesh);

  EXPECT_EQ(element_errors(curve).size(), 11u);
}

TEST(ElementErrors, AreNothingButRoundingOnACycloid) {
  // The cycloid is entire in σ; degree 8 on 12 elements resolves it fully.
  Scene scene = natural(uniform_scene());
  scene.contact = Contact::Centre;
  const ExtremalCurve curve = curve_on(scene, uniform_mesh(8, 12));

  for (const double error : element_errors(curve)) {
    // 𝓗 is a difference of terms of order one, multipliers have 1e-12.
    EXPECT_NEAR(error, 0.0, 1e-12);
  }
}

TEST(ElementErrors, PointAtTheElementThatIsTooLong) {
  Mesh mesh = uniform_mesh(4, 24);
  // Without every other boundary in the middle, one element of four.
  mesh.boundaries.erase(mesh.boundaries.begin() + 13,
                        mesh.boundaries.begin() + 16);
  const std::vector<double> errors =
      element_errors(curve_on(between_centres(0.0), mesh));

  const auto largest =
      std::max_element(errors.begin(), errors.end(), [](double a, double b) {
        return std::abs(a) < std::abs(b);
      });
  EXPECT_EQ(largest - errors.begin(), 12);
}

}  // namespace
}  // namespace brachisto::testing
