// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of τ by the scene against whole solves of other scenes.

#include "brachisto/study/solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <ostream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "model/cycloid.hpp"
#include "model/inertia.hpp"
#include "study/in_lanes.hpp"
#include "study/tau_rates.hpp"
#include "support/limited_scenes.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

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

bool passes_surface(const Scene& scene) {
  return scene.world.sphere &&
         scene.world.sphere->radius == in_the_way().radius;
}
/// Relative, of T.
constexpr double kOnItsOwnMesh = 1e-11;

/// On a mesh that does not change with the scene: a discrete time and its
/// derivatives have their error in common. Of the reference τ is exact but for
/// rounding on 40 elements; the costly solves in other worlds have fewer. Where
/// a surface is passed elements have to follow, to a tolerance.
Solution solved(const Scene& scene) {
  SolveOptions options;
  auto& program = options.use<Collocation>();
  if (passes_surface(scene)) {
    program.discretisation.tolerance = kOnItsOwnMesh;
  } else {
    program.discretisation.elements = scene.limits.any()       ? 80
                                      : scene.world.ordinary() ? 40
                                                               : 16;
  }
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
/// Errors of τ ≈ 5 on meshes of their own are not in common: differences divide
/// 5e-11 by h/4, and extrapolation takes 64/45 + 20/90 + 1/180 < 1.9 of that.
double allowed(const Scene& scene) {
  return passes_surface(scene) ? 2e-7 : kAllowed;
}

struct Case {
  std::string test;
  Scene scene;
};
std::ostream& operator<<(std::ostream& out, const Case& one) {
  return out << one.test;
}

Scene scene_between(const Body& body, Contact contact = Contact::Smooth) {
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

void expect_total_slope(const Scene& scene, const Sensitivities& found,
                        SceneParameter parameter) {
  const double expected = slope_of_tau(
      scene, [&](Scene& other, double by) { value_of(other, parameter) += by; },
      kStep);
  EXPECT_NEAR(found.by[parameter].tau, expected,
              allowed(scene) * std::max(1.0, std::abs(expected)))
      << name(parameter);
}

class OfTheScene : public ::testing::TestWithParam<Case> {};

TEST_P(OfTheScene, AreTheSlopesOfWholeSolves) {
  const Scene& scene = GetParam().scene;
  const auto found = sensitivities(solved(scene));
  ASSERT_TRUE(found);

  for (const SceneParameter parameter : kParameters) {
    if (scene.body.rolls() || parameter >= SceneParameter::L) {
      expect_total_slope(scene, *found, parameter);
    } else {
      EXPECT_TRUE(std::isnan(found->by[parameter].tau)) << name(parameter);
    }
  }
}

/// τ has no unit, and T is as long as the square root of the scene's size.
class OfTheFreeScene : public OfTheScene {};

TEST_P(OfTheFreeScene, ObeyTheLawOfUnits) {
  constexpr double kRounding = 1e-9;
  const Scene& scene = GetParam().scene;
  const Solution solution = solved(scene);
  const auto found = sensitivities(solution);
  ASSERT_TRUE(found);

  double tau = 0.0, time = 0.0, tau_fixed = 0.0, time_fixed = 0.0;
  for (const SceneParameter parameter :
       {SceneParameter::Radius, SceneParameter::L, SceneParameter::H}) {
    const TimeDerivatives& by = found->by[parameter];
    if (std::isnan(by.tau)) continue;
    Scene own = scene;
    const double value = value_of(own, parameter);
    tau += value * by.tau;
    time += value * by.transit_time;
    tau_fixed += value * by.tau_at_fixed_contacts;
    time_fixed += value * by.transit_time_at_fixed_contacts;
  }

  const double half = 0.5 * solution.motion()->transit_time();
  EXPECT_NEAR(tau, 0.0, kRounding);
  EXPECT_NEAR(tau_fixed, 0.0, kRounding);
  EXPECT_NEAR(time, half, kRounding);
  EXPECT_NEAR(time_fixed, half, kRounding);
}

Scene bead() {
  return scene_between(Body::bead());
}
Scene on_limits(Scene scene, const PathLimits& limits,
                Contact contact = Contact::Smooth) {
  return under(std::move(scene), limits, contact);
}
std::vector<Case> free_scenes() {
  return {{"Reference", scene_between(reference_body())},
          {"Backwards", scene_between(reference_body(-std::numbers::pi / 6.0))},
          {"Centre", scene_between(reference_body(0.4), Contact::Centre)},
          {"Bead", bead()}};
}

INSTANTIATE_TEST_SUITE_P(Scenes, OfTheScene, ::testing::ValuesIn(free_scenes()),
                         [](const auto& one) { return one.param.test; });
INSTANTIATE_TEST_SUITE_P(Scenes, OfTheFreeScene,
                         ::testing::ValuesIn(free_scenes()),
                         [](const auto& one) { return one.param.test; });

INSTANTIATE_TEST_SUITE_P(
    Limited, OfTheScene,
    ::testing::Values(
        Case{"Friction",
             on_limits(scene_between(reference_body()), friction(1.0))},
        Case{"Floor", on_limits(scene_between(reference_body()),
                                floor_at(0.9 + 1.0 / 3.0))},
        Case{"Optimal", on_limits(scene_between(reference_body()),
                                  bends(2.0, 2.0), Contact::Optimal)}),
    [](const auto& one) { return one.param.test; });

Scene backwards(Contact contact = Contact::Smooth) {
  return scene_between(reference_body(-std::numbers::pi / 6.0), contact);
}
std::vector<Case> worlds_at_rest() {
  return {
      {"Air", in_air(backwards(), 0.3, 0.1)},
      {"InASphere", about_sphere(scene_between(reference_body(0.4)), around())},
      {"AboveASphere",
       about_sphere(scene_between(reference_body(0.4)), below())}};
}
INSTANTIATE_TEST_SUITE_P(Worlds, OfTheScene,
                         ::testing::ValuesIn(worlds_at_rest()),
                         [](const auto& one) { return one.param.test; });

Scene into_a_planet(const Body& body, Contact contact = Contact::Smooth) {
  return about_sphere(scene_between(body, contact), in_the_way());
}
Case through_a_surface() {
  return {"Offset", into_a_planet(reference_body(0.35))};
}
/// Where the passage moves with a number, so does the place at which the
/// costates' rates jump, and with it the slope at B.
INSTANTIATE_TEST_SUITE_P(
    ThroughASurface, OfTheScene,
    ::testing::Values(through_a_surface(),
                      Case{"BetweenEnds", into_a_planet(reference_body(0.35),
                                                        Contact::Centre)},
                      Case{"BetweenEndsPushed",
                           with_push(into_a_planet(reference_body(0.35),
                                                   Contact::Centre),
                                     0.5)},
                      Case{"Bead", into_a_planet(Body::bead())}),
    [](const auto& one) { return one.param.test; });

/// Elements that are asked for end on the surface as others do. 32 of degree 5
/// err by 1e-8 or so.
TEST(Sensitivities, OnElementsThatAreAskedForFollowThePassageToo) {
  constexpr double kOfTheMesh = 1e-6;
  const Scene scene = through_a_surface().scene;
  SolveOptions options;
  options.use<Collocation>().discretisation.elements = 32;
  const auto asked = sensitivities(solve(scene, options));
  const auto own = sensitivities(solved(scene));
  ASSERT_TRUE(asked && own);

  for (const SceneParameter parameter : kParameters) {
    EXPECT_NEAR(asked->by[parameter].tau, own->by[parameter].tau, kOfTheMesh)
        << name(parameter);
  }
}

/// The figures of docs/theory.md: the slope of τ over η_m is not what it is
/// between fixed ends.
TEST(Sensitivities, OfTheReferenceAtFixedContactsAreOthers) {
  const auto found = sensitivities(solved(scene_between(reference_body())));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->by[SceneParameter::EtaM].tau, 0.6009, 5e-5);
  EXPECT_NEAR(found->by[SceneParameter::EtaM].tau_at_fixed_contacts, 0.3904,
              5e-5);
}

/// With the slopes at A and B held the ends of the centre's path follow from
/// them: the same motion, seen from C_A, with contact: centre.
Scene between_its_ends(const Scene& scene, double beta_A, double beta_B) {
  Scene out = scene;
  if (scene.contact == Contact::Centre) return out;
  const double r = scene.body.radius;
  const Point C_A{r * std::sin(beta_A), -r * std::cos(beta_A)};
  out.contact = Contact::Centre;
  out.L += r * std::sin(beta_B) - C_A.x;
  out.H += -r * std::cos(beta_B) - C_A.z;
  if (out.world.sphere) {
    out.world.sphere->centre.x -= C_A.x;
    out.world.sphere->centre.z -= C_A.z;
  }
  return out;
}

/// T of a motion between given ends with the energy of v₀ in the direction β_A.
/// It sets out in another direction β with the v of v √A(β) = v₀ √A(β_A), by
/// the secant method, T on the last secant: in error by the product of its
/// ends.
double time_between_its_ends(Scene ends, double beta_A) {
  constexpr int kMostSolves = 10;
  constexpr double kRounding = 1e-14;
  const auto root = [&](double beta) {
    return std::sqrt(inertia_factor(ends.body, ends.body.theta_m, beta));
  };
  double& speed = ends.world.start_speed;
  const double wanted = speed * root(beta_A);
  double last_speed = 0.0, last_off = -1.0, last_time = 0.0;
  for (int i = 0; i < kMostSolves; ++i) {
    const Solution solution = solved(ends);
    const double time = solution.motion()->transit_time();
    if (wanted == 0.0) return time;
    const double off =
        speed * root(solution.motion()->start_angle()) / wanted - 1.0;
    if (off == 0.0) return time;
    const double per_off = 1.0 / (off - last_off);
    if (i > 0 && std::abs(off * last_off) <= kRounding) {
      return time - off * (time - last_time) * per_off;
    }
    const double next = speed - off * (speed - last_speed) * per_off;
    last_speed = std::exchange(speed, next);
    last_off = off;
    last_time = time;
  }
  throw std::runtime_error("the energy at A is not met");
}

void expect_slope_at_fixed_contacts(const Solution& solution,
                                    const Sensitivities& found,
                                    SceneParameter parameter) {
  const Scene& scene = solution.scene;
  const double beta_A = solution.motion()->start_angle();
  const double beta_B = solution.motion()->end_angle();
  const double expected = slope(
      [&](double by) {
        Scene other = scene;
        value_of(other, parameter) += by;
        return time_between_its_ends(between_its_ends(other, beta_A, beta_B),
                                     beta_A) *
               std::sqrt(2.0 * scene.gravity / other.H);
      },
      kStep);
  EXPECT_NEAR(found.by[parameter].tau_at_fixed_contacts, expected,
              allowed(scene) * std::max(1.0, std::abs(expected)))
      << name(parameter);
}

class AtFixedContacts : public ::testing::TestWithParam<Case> {};

TEST_P(AtFixedContacts, AreThoseBetweenTheEndsOfTheCentre) {
  const Solution solution = solved(GetParam().scene);
  const auto found = sensitivities(solution);
  ASSERT_TRUE(found);

  for (const SceneParameter parameter : kParameters) {
    expect_slope_at_fixed_contacts(solution, *found, parameter);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AtFixedContacts,
                         ::testing::Values(Case{
                             "Backwards", scene_between(reference_body(-0.5))}),
                         [](const auto& one) { return one.param.test; });
INSTANTIATE_TEST_SUITE_P(Worlds, AtFixedContacts,
                         ::testing::ValuesIn(worlds_at_rest()),
                         [](const auto& one) { return one.param.test; });
INSTANTIATE_TEST_SUITE_P(ThroughASurface, AtFixedContacts,
                         ::testing::Values(through_a_surface()),
                         [](const auto& one) { return one.param.test; });

Case push() {
  return {"Push", with_push(backwards(), 1.0)};
}
Case push_between_ends() {
  return {"PushBetweenEnds", with_push(backwards(Contact::Centre), 1.0)};
}
Case push_in_air_in_a_sphere() {
  const Scene scene =
      about_sphere(scene_between(reference_body(0.4)), around());
  return {"PushInAirInASphere", in_air(with_push(scene, 0.7), 0.1, 0.05)};
}

/// A start with a speed has slopes at both contacts that the answer determines,
/// between given ends that at A, for the energy of the start. Its solves are
/// long.
class OfAPushedScene
    : public ::testing::TestWithParam<std::tuple<Case, SceneParameter>> {};

TEST_P(OfAPushedScene, AreTheSlopesOfWholeSolves) {
  const auto& [pushed, parameter] = GetParam();
  const auto found = sensitivities(solved(pushed.scene));
  ASSERT_TRUE(found);

  expect_total_slope(pushed.scene, *found, parameter);
}

class OfAPushAtFixedContacts : public OfAPushedScene {};

TEST_P(OfAPushAtFixedContacts, AreThoseBetweenTheEndsOfTheCentre) {
  const auto& [pushed, parameter] = GetParam();
  const Solution solution = solved(pushed.scene);
  const auto found = sensitivities(solution);
  ASSERT_TRUE(found);

  expect_slope_at_fixed_contacts(solution, *found, parameter);
}

std::string name_of(
    const ::testing::TestParamInfo<std::tuple<Case, SceneParameter>>& one) {
  return std::get<0>(one.param).test + "_" + name(std::get<1>(one.param));
}
INSTANTIATE_TEST_SUITE_P(
    Scenes, OfAPushedScene,
    ::testing::Combine(::testing::Values(push(), push_between_ends(),
                                         push_in_air_in_a_sphere()),
                       ::testing::ValuesIn(kParameters)),
    name_of);
Case push_through_a_surface() {
  return {"Push", with_push(through_a_surface().scene, 0.5)};
}
INSTANTIATE_TEST_SUITE_P(
    ThroughASurface, OfAPushedScene,
    ::testing::Combine(::testing::Values(push_through_a_surface()),
                       ::testing::Values(SceneParameter::EtaM,
                                         SceneParameter::L)),
    name_of);
INSTANTIATE_TEST_SUITE_P(
    Scenes, OfAPushAtFixedContacts,
    ::testing::Combine(::testing::Values(push(), push_between_ends()),
                       ::testing::ValuesIn(kParameters)),
    name_of);

/// On the floor up to B, which is given: where B alone is lower nothing but the
/// last rise of the bead is spared, and T stays, dτ/dH = −τ/(2H). Farther by dL
/// it goes on at √(2gH): dτ/dL = 1.
TEST(Sensitivities, OfABeadOnAFloorUpToBAreInClosedForm) {
  Scene scene;
  scene.body = Body::bead();
  scene.L = 5.0;
  scene.H = 1.0;
  scene.limits.floor = 1.0;
  const Solution solution = solved(scene);
  const auto found = sensitivities(solution);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->by[SceneParameter::H].tau, -0.5 * solution.motion()->tau(),
              1e-8);
  EXPECT_NEAR(found->by[SceneParameter::L].tau, 1.0, 1e-8);
}

/// T = √(1 + k) U along one cycloid for all k.
TEST(Sensitivities, OfAUniformCylinderAreThoseOfTheCycloid) {
  constexpr double kRounding = 1e-9;
  const Scene scene = scene_between(Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5));
  const Solution solution = solved(scene);
  const auto found = sensitivities(solution, true);
  ASSERT_TRUE(found && found->second);
  const double tau = solution.motion()->tau();

  EXPECT_NEAR(found->by[SceneParameter::K].tau, tau / 3.0, kRounding);
  EXPECT_NEAR((*found->second)[SceneParameter::K][SceneParameter::K],
              -tau / 9.0, kRounding);
  for (const SceneParameter parameter :
       {SceneParameter::Radius, SceneParameter::L, SceneParameter::H}) {
    const double expected = slope(
        [&](double by) {
          Scene other = scene;
          value_of(other, parameter) += by;
          const auto cycloid = axisymmetric_optimum(other);
          return std::sqrt(1.5 * cycloid->a / other.gravity) *
                 cycloid->psi_end * std::sqrt(2.0 * other.gravity / other.H);
        },
        kStep);
    EXPECT_NEAR(found->by[parameter].tau, expected, kRounding)
        << name(parameter);
  }
}

/// The static angle, which the track begins with, moves with k too.
TEST(Sensitivities, OfAUniformCylinderWithLittleGripAreThoseOfTheClosedForm) {
  const double mu = 0.5;
  const Scene scene = under(
      scene_between(Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5)), friction(mu));
  const auto found = sensitivities(solved(scene));
  ASSERT_TRUE(found);

  for (const SceneParameter parameter :
       {SceneParameter::K, SceneParameter::Radius, SceneParameter::L,
        SceneParameter::H}) {
    const double expected = slope(
        [&](double by) {
          Scene other = scene;
          value_of(other, parameter) += by;
          return closed_incline(natural(other), static_slope(other.body, mu))
                     .tau /
                 std::sqrt(other.H);
        },
        kStep);
    EXPECT_NEAR(found->by[parameter].tau, expected, kAllowed)
        << name(parameter);
  }
}

/// η_m = 0 is no corner: bodies to all sides of it are solved whole.
class WithoutOffset : public ::testing::TestWithParam<Case> {};

TEST_P(WithoutOffset, ByOffsetAreRegular) {
  const Scene& scene = GetParam().scene;
  const auto found = sensitivities(solved(scene));
  ASSERT_TRUE(found);
  const auto along = [&](double theta_m) {
    return slope_of_tau(
        scene,
        [&](Scene& other, double by) {
          other.body.eta_m = std::abs(by);
          other.body.theta_m = theta_m + (by < 0.0 ? std::numbers::pi : 0.0);
        },
        kStep);
  };

  const double near = allowed(scene);
  EXPECT_NEAR(found->by_offset[0].tau, along(0.0), near);
  EXPECT_NEAR(found->by_offset[1].tau, along(0.5 * std::numbers::pi), near);
  EXPECT_NEAR(found->by[SceneParameter::EtaM].tau, along(0.7), near);
  EXPECT_EQ(found->by[SceneParameter::ThetaM].tau, 0.0);
}

Scene uniform(Contact contact = Contact::Smooth) {
  return scene_between(Body::cylinder(1.0 / 3.0, 0.0, 0.7, 0.5), contact);
}
INSTANTIATE_TEST_SUITE_P(
    Scenes, WithoutOffset,
    ::testing::Values(
        Case{"AtRest", uniform()}, Case{"Push", with_push(uniform(), 1.0)},
        Case{"PushBetweenEnds", with_push(uniform(Contact::Centre), 1.0)},
        Case{"InASphere", about_sphere(uniform(), around())},
        Case{"ThroughASurface", about_sphere(uniform(), in_the_way())},
        Case{"PushBetweenEndsInASphere",
             with_push(about_sphere(uniform(Contact::Centre), around()), 1.0)}),
    [](const auto& one) { return one.param.test; });

/// The path of a uniform body owes nothing to its turns, and a handful of
/// elements has it; how it changes with an offset owes all to them.
class OfASmallBodyWithoutOffset : public ::testing::TestWithParam<Case> {};

TEST_P(OfASmallBodyWithoutOffset, ResolveItsTurns) {
  // It turns some nineteen times, and T varies with η_m on a length of 0.1: h⁶
  // leaves 1e-10. Relative errors of 1e-12 in τ < 6 make 4 · 1.9 · 6e-12/h.
  constexpr double kNear = 3e-8;
  const Scene& scene = GetParam().scene;
  SolveOptions options;
  options.use<Collocation>().discretisation.tolerance = 1e-12;
  const auto found = sensitivities(solve(scene, {}));
  ASSERT_TRUE(found);

  const double expected = slope(
      [&](double by) {
        Scene other = scene;
        other.body.eta_m = std::abs(by);
        other.body.theta_m += by < 0.0 ? std::numbers::pi : 0.0;
        const Solution solution = solve(other, options);
        EXPECT_TRUE(solution.verified()) << solution.message;
        return solution.motion()->tau();
      },
      kStep);
  EXPECT_NEAR(found->by[SceneParameter::EtaM].tau, expected, kNear);
}

Scene small_uniform() {
  Scene scene = scene_between(Body::cylinder(0.02, 0.0, -1.48, 0.4));
  scene.L = 2.0;
  scene.H = 0.6;
  return scene;
}
INSTANTIATE_TEST_SUITE_P(Scenes, OfASmallBodyWithoutOffset,
                         ::testing::Values(Case{"Free", small_uniform()},
                                           Case{"UnderALimit",
                                                under(small_uniform(),
                                                      friction(0.5))}),
                         [](const auto& one) { return one.param.test; });

/// Second derivatives, of whole solves' first ones: those are compared with
/// whole solves above.
class SecondDerivativesOf : public ::testing::TestWithParam<Case> {};

TEST_P(SecondDerivativesOf, AreTheSlopesOfTheFirst) {
  const Scene& scene = GetParam().scene;
  // Slopes are exact to some ten times what τ is.
  const double allowed_of_second = 10.0 * allowed(scene);
  const auto found = sensitivities(solved(scene), true);
  ASSERT_TRUE(found && found->second);

  for (const SceneParameter one : kParameters) {
    std::map<double, Sensitivities> known;
    const auto first = [&](double by) -> const Sensitivities& {
      Scene next = scene;
      value_of(next, one) += by;
      if (!known.contains(by)) {
        known[by] = sensitivities(solved(next)).value();
      }
      return known[by];
    };
    for (const SceneParameter other : kParameters) {
      const double expected =
          slope([&](double by) { return first(by).by[other].tau; }, kStep);
      EXPECT_NEAR((*found->second)[one][other], expected,
                  allowed_of_second * std::max(1.0, std::abs(expected)))
          << name(one) << ", " << name(other);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SecondDerivativesOf,
    ::testing::Values(Case{"Reference", scene_between(reference_body())},
                      Case{"Backwards", backwards()}, push(),
                      through_a_surface()),
    [](const auto& one) { return one.param.test; });

/// Of an extremal in lanes by shots. What differs is theirs: of steps that
/// change T by less than 1e-11, a hundred times as much of its derivatives.
constexpr double kOfSteps = 1e-9;

Solution solved_in_lanes(const Scene& scene) {
  SolveOptions options;
  options.use<Collocation>().in_lanes = true;
  options.use<Collocation>().sensitivities = SensitivityOrder::First;
  const std::vector<SceneToSolve> one{{scene, options}};
  return solve_in_lanes(one).front().value();
}

Scene for_lanes(double eta_m, double theta_m, double k,
                Contact contact = Contact::Smooth) {
  Scene scene = scene_between(Body::cylinder(0.3, eta_m, theta_m, k), contact);
  scene.L = 2.5;
  scene.H = 1.2;
  return scene;
}
/// It turns some four times on its way: a shot depends closely on its radius.
Scene push_of_a_small_body() {
  Scene scene = scene_between(Body::cylinder(0.1725, 0.798, 0.287, 0.108));
  scene.L = 4.0;
  return with_push(scene, 1.5);
}
/// Outside of it, or within a large one.
Scene by_planet(Scene scene, double radius) {
  scene.world.sphere = Sphere{{1.5, 12.0}, radius, 12.0};
  return scene;
}
std::vector<Case> pushed_in_lanes() {
  return {
      {"Push", with_push(for_lanes(0.4, 0.7, 0.5), 1.0)},
      {"GentlePush", with_push(for_lanes(0.4, 0.7, 0.5), 0.1)},
      {"HardPushBackwards", with_push(for_lanes(0.7, -1.2, 0.1), 3.0)},
      {"PushBetweenEnds",
       with_push(for_lanes(0.5, 2.0, 0.3, Contact::Centre), 1.5)},
      {"PushOfASmallBody", push_of_a_small_body()},
      {"PushInAir", in_air(with_push(for_lanes(0.4, 0.7, 0.5), 1.0), 0.2, 0.1)},
      {"PushByAPlanet",
       by_planet(with_push(for_lanes(0.4, 0.7, 0.5), 1.0), 9.0)},
  };
}

/// Drag makes shots spread by orders of magnitude on this way.
TEST(SensitivitiesInLanes, AreNotGivenWhereDifferencesOfShotsMeanNothing) {
  Scene scene = scene_between(
      Body::cylinder(0.2, 0.2, -2.0 / 3.0 * std::numbers::pi, 0.4));
  scene.L = 2.0;
  scene.H = 0.6;
  scene = in_air(scene, 0.0, 1.0);
  SolveOptions options;
  options.use<Collocation>().in_lanes = true;
  const auto solve_one = [&] {
    const std::vector<SceneToSolve> one{{scene, options}};
    return solve_in_lanes(one).front();
  };
  EXPECT_TRUE(solve_one());
  options.use<Collocation>().sensitivities = SensitivityOrder::First;
  EXPECT_FALSE(solve_one());
}

class OfLanes : public ::testing::TestWithParam<Case> {};

/// By its program on a mesh at a tolerance of 1e-13 they err by less than 1e-9.
TEST_P(OfLanes, AreThoseOfTheirOwnSolves) {
  const Scene& scene = GetParam().scene;
  const auto lanes = solved_in_lanes(scene).sensitivities;
  SolveOptions options;
  options.use<Collocation>().discretisation.tolerance = 1e-13;
  const auto own = sensitivities(solve(scene, options));

  ASSERT_TRUE(lanes && own);
  const auto expect_near = [](double a, double b, const char* of) {
    EXPECT_NEAR(a, b, kOfSteps * std::max(1.0, std::abs(b))) << of;
  };
  const auto expect_same = [&](const TimeDerivatives& a,
                               const TimeDerivatives& b, const char* of) {
    expect_near(a.tau, b.tau, of);
    expect_near(a.tau_at_fixed_contacts, b.tau_at_fixed_contacts, of);
  };
  for (const SceneParameter parameter : kParameters) {
    expect_same(lanes->by[parameter], own->by[parameter], name(parameter));
  }
  expect_same(lanes->by_offset[0], own->by_offset[0], "offset x");
  expect_same(lanes->by_offset[1], own->by_offset[1], "offset z");
  if (scene.contact == Contact::Smooth) {
    expect_near(lanes->contact_response, own->contact_response, "contact");
  } else {
    EXPECT_TRUE(std::isnan(lanes->contact_response));
  }
}

INSTANTIATE_TEST_SUITE_P(
    AtRest, OfLanes,
    ::testing::Values(
        Case{"Forwards", for_lanes(0.4, 0.7, 0.5)},
        Case{"Backwards", for_lanes(0.7, -1.2, 0.1)},
        Case{"BetweenEnds", for_lanes(0.5, 2.0, 0.3, Contact::Centre)},
        Case{"InAir", in_air(for_lanes(0.4, 0.7, 0.5), 0.2, 0.1)},
        Case{"ByAPlanet", by_planet(for_lanes(0.4, 0.7, 0.5), 9.0)},
        Case{"WithinAPlanet", by_planet(for_lanes(0.7, -1.2, 0.1), 16.0)}),
    [](const auto& one) { return one.param.test; });
INSTANTIATE_TEST_SUITE_P(Pushed, OfLanes,
                         ::testing::ValuesIn(pushed_in_lanes()),
                         [](const auto& one) { return one.param.test; });
INSTANTIATE_TEST_SUITE_P(
    WithoutOffset, OfLanes,
    ::testing::Values(Case{"AtRest", for_lanes(0.0, 0.7, 0.5)},
                      Case{"Pushed", with_push(for_lanes(0.0, 0.7, 0.5), 1.0)}),
    [](const auto& one) { return one.param.test; });

/// Of extremals to 1e-13, of which differences leave a thousand times as much.
class OfPushedLanes : public ::testing::TestWithParam<Case> {};

TEST_P(OfPushedLanes, AreTheSlopesOfExtremals) {
  const Scene& scene = GetParam().scene;
  const auto found = solved_in_lanes(scene).sensitivities;
  ASSERT_TRUE(found);

  for (const SceneParameter parameter : kParameters) {
    const double expected = slope(
        [&](double by) {
          Scene other = scene;
          value_of(other, parameter) += by;
          return solve_extremal(other).tau;
        },
        kStep);
    EXPECT_NEAR(found->by[parameter].tau, expected,
                kOfSteps * std::max(1.0, std::abs(expected)))
        << name(parameter);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OfPushedLanes,
                         ::testing::ValuesIn(pushed_in_lanes()),
                         [](const auto& one) { return one.param.test; });

}  // namespace
}  // namespace brachisto
