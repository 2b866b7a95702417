// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Newton's and Euler's laws along answers of all kinds, with the forces that
// are printed with them, and along none of the same answers misread.

#include "support/newton_euler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "support/limited_scenes.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

/// What answers may leave of the laws, see allowed_along(): T wanted to 1e-10,
/// by polynomials of any degree. And what faults leave at least.
constexpr double kUnseen = 3e-6, kSeen = 1e-3;

struct AskedScene {
  std::string name;
  Scene scene;
  SolveOptions options = {};
};

std::ostream& operator<<(std::ostream& out, const AskedScene& row) {
  return out << row.name;
}

Scene on_path(Scene scene, GivenPath::Curve curve, GivenPath::Shape shape) {
  auto path = std::make_shared<GivenPath>();
  path->curve = curve;
  path->shape = shape;
  if (shape == GivenPath::Shape::Parabola) path->start_angle = kPi / 3.0;
  if (shape == GivenPath::Shape::Points) {
    path->points = {{0.0, 0.0}, {0.8, 0.9}, {1.7, 1.1}, {3.0, 1.0}};
  }
  scene.path = std::move(path);
  return scene;
}

std::vector<AskedScene> answers() {
  using enum GivenPath::Curve;
  using enum GivenPath::Shape;
  const Scene base = off_centred_scene(), ahead = off_centred_scene(-kPi / 6.0);
  const Scene bead = bead_scene(), uniform = uniform_scene();
  const Scene ring = scene_of(Body::cylinder(0.25, 0.6, 0.8, 0.64));
  const Scene mass = scene_of(Body::cylinder(1.0 / 3.0, 0.7, -0.3, 0.0));
  PathLimits loads;
  loads.normal_min = 0.1;
  loads.normal_max = 2.5;
  PathLimits disc;
  disc.discs = {{{1.5, 1.3}, 0.3}};
  PathLimits turns = bends(2.0, 2.0);
  turns.floor = 1.5;
  Scene given = under(base, bends(2.0, 3.0), Contact::EndSlope);
  given.end_slope = -0.5;
  SolveOptions shooting;
  shooting.method = Shooting{};
  return {
      {"bead", bead},
      {"uniform", uniform},
      {"base", base},
      {"mass_ahead", ahead},
      {"mass_on_the_rim", ring},
      {"mass_without_inertia", mass},
      {"shot", ahead, shooting},
      {"inside_a_sphere", about_sphere(ahead, around())},
      {"outside_a_sphere", about_sphere(ring, below())},
      {"in_and_out", about_sphere(ring, {{1.0, 10.0}, 9.3, 9.81})},
      {"bead_outside", with_push(about_sphere(bead, below()), 1.0)},
      {"linear_drag", in_air(base, 0.2, 0.0)},
      {"quadratic_drag", in_air(ahead, 0.0, 0.1)},
      {"push", with_push(ahead, 1.5)},
      {"all_of_it",
       with_push(in_air(about_sphere(base, below()), 0.1, 0.05), 1.0)},
      {"friction", under(ahead, friction(0.6))},
      {"incline", under(uniform, friction(0.2))},
      {"loads", under(base, loads)},
      {"turns", under(base, turns, Contact::Optimal)},
      {"given_slope", given},
      {"floor_shot", under(bead, floor_at(1.1)), shooting},
      {"disc", under(base, disc)},
      {"parabola", on_path(base, Track, Parabola)},
      {"arc_of_the_centre", on_path(ahead, Centre, CircularArc)},
      {"points", on_path(ring, Track, Points)},
  };
}

class LawsAlong : public ::testing::TestWithParam<AskedScene> {};

TEST_P(LawsAlong, TheAnswerHold) {
  const Solution solution = solve(GetParam().scene, GetParam().options);
  ASSERT_TRUE(solution.verified())
      << solution.message
      << ::testing::PrintToString(solution.not_verified_because());
  const double allowed = allowed_along(solution);
  ASSERT_LE(allowed, kUnseen);

  const LeftOver left =
      left_over(*solution.motion(), rigid_body_of(GetParam().scene));

  EXPECT_LE(left.largest(), allowed) << left;
}

INSTANTIATE_TEST_SUITE_P(Answers, LawsAlong, ::testing::ValuesIn(answers()),
                         [](const auto& row) { return row.param.name; });

/// A fault that a program could have, and which of the laws it breaks.
struct Fault {
  std::string name, answer;
  double LeftOver::*law;
  /// What would have to act for the faulty motion to be right.
  std::function<void(RigidBody&)> body = {};
  std::function<void(TrajectoryPoint&)> read = {};
};

std::ostream& operator<<(std::ostream& out, const Fault& row) {
  return out << row.name;
}

std::vector<Fault> faults() {
  using Vector = RigidBody::Vector;
  const auto turned_drag = [](RigidBody& body) {
    body.linear_drag *= -1.0;
    body.quadratic_drag *= -1.0;
  };
  const auto no_quadratic = [](RigidBody& body) { body.quadratic_drag = 0.0; };
  const auto field_of_A = [](RigidBody& body) {
    const Vector G = body.field(Vector::Zero());
    body.field = [G](const Vector&) { return G; };
  };
  const auto field_without_x = [](RigidBody& body) {
    const auto field = body.field;
    body.field = [field](const Vector& at) -> Vector {
      return field(Vector(0.0, at.y()));
    };
  };
  // As high above the centre of mass as that may lie below the centre.
  const auto field_elsewhere = [](RigidBody& body) {
    const auto field = body.field;
    body.field = [field, r_m = body.offset](const Vector& at) -> Vector {
      return field(at - Vector(0.0, r_m));
    };
  };
  const auto turned_offset = [](RigidBody& body) { body.offset *= -1.0; };
  const auto more_inertia = [](RigidBody& body) { body.inertia *= 1.01; };
  const auto let_go = [](RigidBody& body) { body.start_speed = 0.0; };
  const auto turned_normal = [](TrajectoryPoint& p) { p.motion.R_n *= -1.0; };
  const auto turned_tangential = [](TrajectoryPoint& p) {
    p.motion.R_t *= -1.0;
  };
  // v² = 2 g (E + δ), δ = H/100: energy counted from elsewhere.
  const auto other_datum = [](TrajectoryPoint& p) {
    p.motion.v_c = std::sqrt(p.motion.v_c * p.motion.v_c + 0.02 * 9.81);
  };
  const auto slips = [](TrajectoryPoint& p) { p.motion.omega *= 1.01; };
  const auto late = [](TrajectoryPoint& p) { p.t *= 1.01; };
  return {
      {"TurnedDrag", "all_of_it", &LeftOver::force, turned_drag},
      {"TurnedDragOfEnergy", "linear_drag", &LeftOver::energy, turned_drag},
      {"NoQuadraticDrag", "quadratic_drag", &LeftOver::energy, no_quadratic},
      {"TurnedDragOnACentreOffTheMass", "linear_drag", &LeftOver::moment,
       turned_drag},
      {"FieldOfA", "inside_a_sphere", &LeftOver::force, field_of_A},
      {"FieldWithoutX", "outside_a_sphere", &LeftOver::force, field_without_x},
      {"FieldElsewhere", "all_of_it", &LeftOver::force, field_elsewhere},
      {"TurnedOffset", "base", &LeftOver::force, turned_offset},
      {"TurnedOffsetOfEnergy", "friction", &LeftOver::energy, turned_offset},
      {"MoreInertia", "base", &LeftOver::moment, more_inertia},
      {"MoreInertiaOfEnergy", "uniform", &LeftOver::energy, more_inertia},
      {"TurnedNormalForce", "bead", &LeftOver::force, {}, turned_normal},
      {"TurnedNormalForceOfTheMoment",
       "loads",
       &LeftOver::moment,
       {},
       turned_normal},
      {"TurnedTangentialForce",
       "uniform",
       &LeftOver::moment,
       {},
       turned_tangential},
      {"TurnedTangentialForceInAWorld",
       "outside_a_sphere",
       &LeftOver::force,
       {},
       turned_tangential},
      {"OtherDatum", "bead", &LeftOver::energy, {}, other_datum},
      {"NotFromRest", "push", &LeftOver::start, let_go},
      {"Slip", "disc", &LeftOver::slip, {}, slips},
      {"OtherTime", "parabola", &LeftOver::place, {}, late},
  };
}

class LawsNotAlong : public ::testing::TestWithParam<Fault> {};

TEST_P(LawsNotAlong, AFaultyAnswer) {
  const Fault& fault = GetParam();
  const std::vector<AskedScene> all = answers();
  const auto found = std::ranges::find(all, fault.answer, &AskedScene::name);
  ASSERT_NE(found, all.end());
  const Solution solution = solve(found->scene, found->options);
  ASSERT_TRUE(solution.verified()) << solution.message;
  RigidBody body = rigid_body_of(found->scene);
  if (fault.body) fault.body(body);

  const LeftOver left = left_over(*solution.motion(), body, fault.read);

  EXPECT_GE(left.*fault.law, kSeen);
}

INSTANTIATE_TEST_SUITE_P(Faults, LawsNotAlong, ::testing::ValuesIn(faults()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto
