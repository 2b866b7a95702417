// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The indirect method under limits, as a witness and as the method: against
// references that share no code with this project, against the program, and by
// itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "extremal/arc_shooting.hpp"
#include "model/start_angle.hpp"
#include "model/units.hpp"
#include "refinement/limited_refinement.hpp"
#include "study/limited_shooting.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"
#include "support/limited_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

SolveOptions cross_checked() {
  SolveOptions options;
  options.use<Collocation>().certify = Certify::Extremal;
  return options;
}

/// What is asked of it: τ to 1e-10, slopes to 1e-8, junctions to 1e-7.
void expect_agreement(const Solution& solution) {
  ASSERT_TRUE(solution.verified())
      << solution.message
      << ::testing::PrintToString(solution.not_verified_because());
  ASSERT_TRUE(solution.extremal.has_value());
  const CrossCheck& check = *solution.extremal;
  ASSERT_TRUE(check.solved) << check.message;
  EXPECT_LE(check.difference, 1e-10);
  EXPECT_LE(check.of_slopes.value_or(1.0), 1e-8);
  EXPECT_LE(check.of_junctions.value_or(1.0), 1e-7);
}

class WitnessOfRow : public ::testing::TestWithParam<LimitedReference> {};

TEST_P(WitnessOfRow, AgreesWithTheProgramAndWithTheReference) {
  const LimitedReference& row = GetParam();

  const Solution solution = solve(row.scene, cross_checked());

  expect_agreement(solution);
  // Half a unit of the last decimal that is given, and as much again: residuals
  // of the references are 2e-13.
  EXPECT_NEAR(solution.extremal->tau, row.tau, 1e-12);
  EXPECT_LE(solution.extremal->error_estimate, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Rows, WitnessOfRow,
                         ::testing::ValuesIn(limited_references()),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

class ShotRow : public ::testing::TestWithParam<LimitedReference> {};

/// As of the witness; slopes as many decimals as the references have.
TEST_P(ShotRow, IsThatOfTheReference) {
  const LimitedReference& row = GetParam();
  SolveOptions options;
  options.method = Shooting{};

  const Solution solution = solve(row.scene, options);

  ASSERT_TRUE(solution.verified())
      << solution.message
      << ::testing::PrintToString(solution.not_verified_because());
  EXPECT_NE(solution.message.find("the arcs that the program found"),
            std::string::npos)
      << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), row.tau, 1e-12);
  EXPECT_LE(*solution.estimated_error, 1e-12);
  if (row.end_angle) {
    EXPECT_NEAR(solution.motion()->end_angle(), *row.end_angle, 1e-9);
  }
  if (row.start_angle) {
    EXPECT_NEAR(solution.motion()->start_angle(), *row.start_angle, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, ShotRow,
                         ::testing::ValuesIn(limited_references()),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

Body heavy_body() {
  return Body::cylinder(1.0 / 3.0, 0.8, -0.5, 0.3);
}

PathLimits discs_and_planes(std::vector<Disc> discs,
                            std::vector<HalfPlane> planes) {
  PathLimits limits;
  limits.discs = std::move(discs);
  limits.half_planes = std::move(planes);
  return limits;
}

/// Of a body that touches a floor while friction holds it, and one that has its
/// least force at B while it turns as sharply as it may; of slopes that are
/// given and optimal, of loads, discs, half-planes and given ends.
std::vector<Scene> scenes_of_other_arcs() {
  const Scene base = off_centred_scene();
  Scene touching = base;
  touching.body = heavy_body();
  touching.L = 5.0;
  touching.limits.friction = 0.9;
  touching.limits.floor = 1.59;
  Scene given = under(base, bends(2.0, 2.0), Contact::EndSlope);
  given.end_slope = -0.5;
  PathLimits on_table = bends(2.0, 2.0);
  on_table.floor = 1.3;
  PathLimits grip = bends(2.0, 4.0);
  grip.friction = 0.6;
  PathLimits loaded = bends(2.0, 2.0);
  loaded.normal_min = 0.2;
  Scene light_at_B =
      under(scene_of(Body::cylinder(1.0 / 3.0, 0.577, -0.4, 0.0)), loaded,
            Contact::Optimal);
  light_at_B.H = 0.1;
  PathLimits pressed;
  pressed.normal_max = 2.5;
  return {
      touching,
      light_at_B,
      given,
      under(base, pressed),
      under(base, discs_and_planes({{{1.5, 1.3}, 0.3}}, {})),
      under(base, discs_and_planes({}, {{{1.5, 1.2}, -80.0 * kPi / 180.0}})),
      under(bead_scene(), discs_and_planes({{{1.5, 1.0}, 0.2}}, {})),
      under(base, on_table, Contact::Optimal),
      under(base, grip, Contact::Optimal),
      under(base, friction(0.5), Contact::Centre)};
}

TEST(LimitedWitness, AgreesOnOtherArcs) {
  for (const Scene& scene : scenes_of_other_arcs()) {
    expect_agreement(solve(scene, cross_checked()));
  }
}

/// The finite problem on a mesh on which nothing was solved accepts all of it:
/// impulses where costates jump, and multipliers of contacts and of arcs from
/// rest on.
TEST(LimitedWitness, GivesAnswersThatTheProgramsConditionsAccept) {
  SolveOptions options;
  options.method = Shooting{};
  for (const Scene& scene : scenes_of_other_arcs()) {
    const Solution shot = solve(scene, options);
    const Solution solved = solve(scene);

    ASSERT_TRUE(shot.verified())
        << shot.message
        << ::testing::PrintToString(shot.not_verified_because());
    ASSERT_TRUE(solved.verified()) << solved.message;
    EXPECT_NEAR(shot.motion()->tau(), solved.motion()->tau(),
                1e-10 * solved.motion()->tau());
    ASSERT_EQ(shot.limits.size(), solved.limits.size());
    for (std::size_t i = 0; i < shot.limits.size(); ++i) {
      EXPECT_EQ(shot.limits[i].active.size(), solved.limits[i].active.size());
      EXPECT_NEAR(shot.limits[i].price.value_or(0.0),
                  solved.limits[i].price.value_or(0.0), 1e-6)
          << shot.limits[i].name;
    }
  }
}

/// Behind the floor the body has to climb faster than a free arc may: the
/// valley's bound holds at once, with p_β = 0 and a jump of p_z at its start.
TEST(LimitedWitness, AgreesWhereABoundOfValleysHoldsBehindAFloor) {
  PathLimits limits = bends(2.0, 2.0);
  limits.floor = 1.1;
  Scene scene = under(off_centred_scene(), limits, Contact::EndSlope);
  scene.end_slope = 0.0;

  expect_agreement(solve(scene, cross_checked()));
}

/// Both methods, which have the slope at B that the scene gives.
void expect_both(const Scene& scene) {
  const Solution solved = solve(scene, cross_checked());
  expect_agreement(solved);
  SolveOptions options;
  options.method = Shooting{};
  const Solution shot = solve(scene, options);
  ASSERT_TRUE(shot.verified())
      << shot.message << ::testing::PrintToString(shot.not_verified_because());
  EXPECT_NEAR(shot.motion()->tau(), solved.motion()->tau(),
              1e-10 * solved.motion()->tau());
  if (!scene.end_slope) return;
  EXPECT_NEAR(solved.motion()->end_angle(), *scene.end_slope, 1e-12);
  EXPECT_NEAR(shot.motion()->end_angle(), *scene.end_slope, 1e-12);
}

Scene with_finish(const Body& body, double L, double H,
                  const PathLimits& limits) {
  Scene scene = under(scene_of(body), limits);
  scene.L = L;
  scene.H = H;
  return scene;
}
Scene with_end_slope(Scene scene, double slope) {
  scene.contact = Contact::EndSlope;
  scene.end_slope = slope;
  return scene;
}

/// A bead touches B whatever its slope there, so that nothing else than the
/// condition itself ties the path to a slope that is given.
TEST(LimitedWitness, AgreesWhereTheLastSlopeOfABeadIsGiven) {
  PathLimits table = bends(1.6, 2.3);
  table.floor = 2.7;
  expect_both(with_end_slope(
      with_finish(Body::bead(), 1.344, 0.126, bends(2.217, 34.55)), -0.529));
  expect_both(
      with_end_slope(with_finish(Body::bead(), 15.0, 1.0, table), 0.576));
}

/// Between a free arc and a valley up to B another limit holds for 4e-6 U; and
/// a floor for 0.9 U, where costates are some hundred and rounding of them is
/// what is left on fine meshes.
TEST(LimitedWitness, GivesAnswersWithVeryShortAndVeryLongArcs) {
  PathLimits loaded = bends(1.666, 4.997);
  loaded.normal_min = 0.087;
  PathLimits table = floor_at(0.276);
  table.normal_min = 0.037;
  SolveOptions options;
  options.method = Shooting{};
  for (const Scene& scene :
       {with_end_slope(
            with_finish(Body::bead(), 0.839, 1.0, bends(0.561, 4.439)), -0.739),
        with_end_slope(with_finish(Body::cylinder(0.466, 0.0, 0.0, 0.277), 1.09,
                                   1.0, loaded),
                       -0.388),
        under(with_finish(Body::bead(), 11.898, 0.153, table), table,
              Contact::Centre)}) {
    const Solution shot = solve(scene, options);
    const Solution solved = solve(scene);

    ASSERT_TRUE(shot.verified())
        << shot.message
        << ::testing::PrintToString(shot.not_verified_because());
    EXPECT_NEAR(shot.motion()->tau(), solved.motion()->tau(),
                1e-10 * solved.motion()->tau());
  }
}

/// Inclines from rest that are long or gentle, with friction that holds up to B
/// too, and a bound of humps.
TEST(LimitedWitness, AgreesOnInclinesOfUniformCylinders) {
  PathLimits rails = bends(1.819, 1.168);
  rails.friction = 0.2165;
  expect_both(with_end_slope(
      with_finish(Body::cylinder(0.2, 0.0, 0.0, 0.6388), 14.929, 1.456, rails),
      0.104));
  expect_both(with_finish(Body::cylinder(0.512, 0.0, 0.0, 0.52), 10.797, 1.0,
                          friction(0.228)));
  expect_both(with_finish(Body::cylinder(0.05, 0.0, 0.0, 0.5845), 3.0, 0.022,
                          friction(0.2688)));
}

/// Between given ends of the centre the slope at A is nobody's but the path's.
/// A bounded valley makes it start less steeply than the free one, and costs
/// little as long as that is allowed.
TEST(LimitedWitness, AgreesThatABoundOfValleysFreesTheSlopeOfAGivenCentre) {
  const Scene base = off_centred_scene();
  const Scene scene = under(base, bends({}, 2.0), Contact::Centre);
  Scene free = base;
  free.contact = Contact::Centre;

  const Solution solution = solve(scene, cross_checked());

  expect_agreement(solution);
  EXPECT_LT(solution.motion()->start_angle(), start_angle(base.body) - 0.4);
  EXPECT_LT(solution.motion()->tau(), 1.01 * solve(free).motion()->tau());
}

/// The path of a scene under limits, in natural units.
struct Fitted {
  explicit Fitted(const Scene& scene) : posed(pose(scene, {}, {})) {
    const Start start = start_from_cycloid(posed);
    LimitedRefinement found = refine_limited(
        *posed.limited, posed.program.discretisation, *start.curve, start.phi,
        posed.mesh_options_after({}), Tightening::Care::Rough);
    if (!found.answer) throw std::runtime_error(found.message);
    path.emplace(std::move(found.answer->path));
  }

  PosedProblem posed;
  std::optional<FittedPath> path;
};

double tau_of(const LimitedExtremal& found, const Scene& natural) {
  return found.transit_time * std::sqrt(2.0 * natural.gravity / natural.H);
}

/// From the path under a bound to the one under another, which nothing but the
/// witness has seen.
LimitedExtremal found_from(const Scene& nearby, const Scene& scene) {
  const Fitted fitted(nearby);
  const Scene natural = in_natural_units(scene);
  arcs::Guess guess = as_guess(*fitted.path);
  const auto limits = inequalities(natural.body, natural.limits);
  for (arcs::Arc& arc : guess.arcs) {
    if (!arc.held) continue;
    for (const PathInequality& limit : limits) {
      if (limit.kind == arc.held->limit.kind) {
        arc.held = {limit, limit.lower};
      }
    }
  }
  return solve_limited_extremal(natural, guess, {});
}

// The integration errs by 1e-13 at each of some hundred steps.
constexpr double kClosed = 1e-12;

/// From 0.115 on, where the incline is nearly all of it: 1/9 is the least
/// friction on which the body gets to B.
TEST(LimitedWitness, FindsTheSteepestInclineThatGripsAndTheCycloid) {
  const Scene uniform = uniform_scene();
  for (const double mu : {0.115, 0.14, 0.2, 0.3, 0.5, 1.0}) {
    const Scene scene = under(uniform, friction(mu));

    const LimitedExtremal found =
        found_from(under(uniform, friction(1.1 * mu)), scene);

    ASSERT_TRUE(found.solved) << found.message;
    const ClosedTrack closed =
        closed_incline(uniform, static_slope(uniform.body, mu));
    EXPECT_NEAR(tau_of(found, in_natural_units(scene)), closed.tau, kClosed);
    EXPECT_NEAR(found.end_angle.value, closed.end_angle, kClosed);
    EXPECT_NEAR(found.start_angle.value, static_slope(uniform.body, mu),
                kClosed);
  }
}

TEST(LimitedWitness, FindsACycloidALineOnTheFloorAndTheSameCycloid) {
  for (const double D : {1.05, 1.2}) {
    const Scene scene = under(bead_scene(), floor_at(D));

    const LimitedExtremal found =
        found_from(under(bead_scene(), floor_at(D + 0.02)), scene);

    ASSERT_TRUE(found.solved) << found.message;
    const ClosedTrack closed = closed_on_floor(bead_scene(), D);
    EXPECT_NEAR(tau_of(found, in_natural_units(scene)), closed.tau, kClosed);
    EXPECT_NEAR(found.end_angle.value, closed.end_angle, kClosed);
  }
}

TEST(LimitedWitness, ObjectsToArcsThatLeaveALimitOut) {
  const Scene scene = under(off_centred_scene(), floor_at(0.9 + 1.0 / 3.0));
  const Fitted fitted(scene);
  arcs::Guess guess = as_guess(*fitted.path);
  ASSERT_EQ(guess.arcs.size(), 3U);
  // The free extremal's own arc, from a path that is not far.
  arcs::Arc all;
  for (const arcs::Arc& arc : guess.arcs) all.duration += arc.duration;
  guess.arcs = {all};
  const LimitedCurve& curve = fitted.path->curve;
  guess.state = [&](std::size_t, double share) {
    const LimitedPoint at = curve.at(share);
    return arcs::State{at.state.x,    at.state.z, at.state.theta, at.state.w,
                       at.state.beta, at.p.p_x,   at.p.p_z,       at.p.p_theta,
                       at.p.p_w,      0.0};
  };

  const LimitedExtremal found =
      solve_limited_extremal(*fitted.posed.limited, guess, {});

  EXPECT_FALSE(found.solved);
  EXPECT_NE(found.message.find("floor is exceeded"), std::string::npos)
      << found.message;
}

/// The same path along a floor that holds the body down.
TEST(LimitedWitness, ObjectsToALimitThatHoldsTheOtherWay) {
  const Fitted fitted(under(off_centred_scene(), floor_at(0.9 + 1.0 / 3.0)));
  arcs::Guess guess = as_guess(*fitted.path);
  Scene natural = *fitted.posed.limited;
  natural.limits = {};
  const PathInequality& floor = guess.arcs.at(1).held->limit;
  ASSERT_EQ(floor.kind, PathInequality::Kind::Floor);
  guess.arcs[1].held = {{.kind = PathInequality::Kind::HalfPlane,
                         .place = {0.0, floor.number},
                         .normal = {0.0, 1.0}},
                        0.0};

  const LimitedExtremal found = solve_limited_extremal(natural, guess, {});

  EXPECT_FALSE(found.solved);
  EXPECT_NE(found.message.find("the multiplier of half_plane has the wrong "
                               "sign"),
            std::string::npos)
      << found.message;
}

/// Between the steps of its integration, at whose ends arcs meet.
TEST(LimitedWitness, KnowsItsPathBetweenItsSteps) {
  const Fitted fitted(under(off_centred_scene(), friction(0.5)));
  const Scene& natural = *fitted.posed.limited;

  const LimitedExtremal found = shoot_over_arcs(*fitted.path, {});

  ASSERT_TRUE(found.solved) << found.message;
  const arcs::ArcPath& path = found.path;
  ASSERT_TRUE(path.blind(0));
  // h⁴ of central differences of order four, and rounding over h.
  constexpr double kStep = 1e-3, kDifferences = 1e-9;
  for (std::size_t a = 0; a < path.arcs().size(); ++a) {
    const arcs::ArcPath::Stretch& arc = path.arcs()[a];
    for (const double share : {0.3, 0.55, 0.8}) {
      const double u = share * arc.duration;
      ASSERT_GT(std::min(u, arc.duration - u), 2.0 * kStep);
      const arcs::State y = path.at(a, u).y;
      const auto rate = [&](std::size_t i) {
        const auto across = [&](double h) {
          return path.at(a, u + h).y[i] - path.at(a, u - h).y[i];
        };
        return (8.0 * across(kStep) - across(2.0 * kStep)) / (12.0 * kStep);
      };
      EXPECT_NEAR(rate(arcs::kX), y[arcs::kW] * std::cos(y[arcs::kBeta]),
                  kDifferences);
      EXPECT_NEAR(
          rate(arcs::kW),
          natural.gravity * (std::sin(y[arcs::kBeta]) +
                             natural.body.eta_m * std::cos(y[arcs::kTheta])),
          kDifferences);
    }
    if (a + 1 == path.arcs().size()) continue;
    const arcs::State end = path.at(a, arc.duration).y;
    const arcs::State next = path.at(a + 1, 0.0).y;
    for (std::size_t i = 0; i < arcs::kStates; ++i) {
      EXPECT_NEAR(end[i], next[i], 1e-11) << a << ", " << i;
    }
  }
}

TEST(LimitedWitness, SaysWhichConditionsFail) {
  const Fitted fitted(under(bead_scene(), floor_at(1.0)));
  arcs::Guess guess = as_guess(*fitted.path);
  ASSERT_EQ(guess.arcs.size(), 2U);
  // An arc along the floor does not end above it.
  Scene elsewhere = *fitted.posed.limited;
  elsewhere.H *= 0.9;

  const Outcome missed =
      outcome_of(solve_limited_extremal(elsewhere, guess, {}));
  guess.arcs[1].duration = -1.0;
  const Outcome lost = outcome_of(solve_limited_extremal(elsewhere, guess, {}));

  for (const Outcome& outcome : {missed, lost}) {
    EXPECT_EQ(outcome.status, Status::NotConverged);
    EXPECT_NE(outcome.message.find("Try method: ipopt"), std::string::npos)
        << outcome.message;
  }
  EXPECT_NE(missed.message.find("the conditions for "), std::string::npos)
      << missed.message;
  EXPECT_NE(lost.message.find("on arc 2 of 2, along floor"), std::string::npos)
      << lost.message;
}

TEST(LimitedWitness, RefusesArcsOnWhichTwoLimitsHold) {
  PathLimits limits = friction(1.0);
  limits.floor = 2.0;
  Fitted fitted(under(off_centred_scene(), limits));
  for (nlp::Held& held : fitted.path->arcs.front().held) {
    held = nlp::Held::AtLower;
  }

  const LimitedExtremal found = shoot_over_arcs(*fitted.path, {});

  EXPECT_FALSE(found.solved);
  EXPECT_NE(found.message.find("two limits hold"), std::string::npos)
      << found.message;
}

TEST(LimitedWitness, NamesTheArcsThatItDoesNotKnow) {
  const Scene scene = under(off_centred_scene(), floor_at(0.9 + 1.0 / 3.0));
  const Fitted fitted(scene);
  arcs::Guess guess = as_guess(*fitted.path);
  guess.arcs.erase(guess.arcs.begin());
  const auto state = guess.state;
  guess.state = [=](std::size_t arc, double share) {
    return state(arc + 1, share);
  };

  const LimitedExtremal found =
      solve_limited_extremal(*fitted.posed.limited, guess, {});

  EXPECT_FALSE(found.solved);
  EXPECT_NE(found.message.find("it starts along a boundary"), std::string::npos)
      << found.message;
}

}  // namespace
}  // namespace brachisto
