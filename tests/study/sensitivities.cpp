// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of τ by the scene against whole solves of other scenes.

#include "brachisto/study/sensitivities.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"

namespace brachisto {
namespace {

constexpr std::array kParameters{SceneParameter::EtaM, SceneParameter::ThetaM,
                                 SceneParameter::K,    SceneParameter::Radius,
                                 SceneParameter::L,    SceneParameter::H};

double& value_of(Scene& scene, SceneParameter parameter) {
  switch (parameter) {
    case SceneParameter::EtaM:
      return scene.body.eta_m;
    case SceneParameter::ThetaM:
      return scene.body.theta_m;
    case SceneParameter::K:
      return scene.body.k;
    case SceneParameter::Radius:
      return scene.body.radius;
    case SceneParameter::L:
      return scene.L;
    case SceneParameter::H:
      return scene.H;
  }
  throw std::logic_error("no such parameter");
}

/// On a mesh that does not change with the scene, and whose τ is exact but for
/// rounding.
Solution solved(const Scene& scene) {
  SolveOptions options;
  options.use<Collocation>().discretisation.elements = 40;
  Solution solution = solve(scene, options);
  if (!solution.verified()) throw std::runtime_error(solution.message);
  return solution;
}

/// Scene with a number changed by so much.
using Change = std::function<void(Scene&, double by)>;

/// Central differences with h, h/2, h/4 and Richardson's extrapolation, whose
/// error is of order h⁶.
double slope(const std::function<double(double by)>& f, double h) {
  std::array<double, 3> rows{};
  for (double& row : rows) {
    row = (f(h) - f(-h)) / (2.0 * h);
    h *= 0.5;
  }
  const double first = (4.0 * rows[1] - rows[0]) / 3.0;
  const double second = (4.0 * rows[2] - rows[1]) / 3.0;
  return (16.0 * second - first) / 15.0;
}

double slope_of_tau(const Scene& scene, const Change& change, double h) {
  return slope(
      [&](double by) {
        Scene other = scene;
        change(other, by);
        return solved(other).motion()->tau();
      },
      h);
}

/// τ is exact to some 1e-14, which the differences divide by their smallest
/// step, h/4, and extrapolation doubles: 1e-10 with room for Newton's method on
/// another iterate. (h/ρ)⁶ is as little where a scene varies on a length ρ of
/// 0.1.
constexpr double kStep = 2e-3;
constexpr double kAllowed = 1e-8;

struct Case {
  std::string test;
  Scene scene;
};
std::ostream& operator<<(std::ostream& out, const Case& one) {
  return out << one.test;
}

Scene scene_of(const Body& body, Contact contact = Contact::Smooth) {
  Scene scene;
  scene.body = body;
  scene.L = 3.0;
  scene.H = 1.0;
  scene.contact = contact;
  return scene;
}

Body reference_body(double theta_m = 0.0) {
  return Body::cylinder(1.0 / 3.0, 2.0 / 3.0, theta_m, 0.5);
}

class OfTheScene : public ::testing::TestWithParam<Case> {};

TEST_P(OfTheScene, AreTheSlopesOfWholeSolves) {
  const Scene& scene = GetParam().scene;
  const auto found = sensitivities(solved(scene));
  ASSERT_TRUE(found);

  for (const SceneParameter parameter : kParameters) {
    const double expected = slope_of_tau(
        scene,
        [&](Scene& other, double by) { value_of(other, parameter) += by; },
        kStep);
    EXPECT_NEAR(found->by[parameter].tau, expected,
                kAllowed * std::max(1.0, std::abs(expected)))
        << name(parameter);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, OfTheScene,
    ::testing::Values(
        Case{"Reference", scene_of(reference_body())},
        Case{"Backwards", scene_of(reference_body(-std::numbers::pi / 6.0))},
        Case{"Centre", scene_of(reference_body(0.4), Contact::Centre)}),
    [](const auto& one) { return one.param.test; });

/// The figures of docs/theory.md: the slope of τ over η_m is not what it is
/// between fixed ends.
TEST(Sensitivities, OfTheReferenceAtFixedContactsAreOthers) {
  const auto found = sensitivities(solved(scene_of(reference_body())));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->by[SceneParameter::EtaM].tau, 0.6009, 5e-5);
  EXPECT_NEAR(found->by[SceneParameter::EtaM].tau_at_fixed_contacts, 0.3904,
              5e-5);
}

}  // namespace
}  // namespace brachisto
