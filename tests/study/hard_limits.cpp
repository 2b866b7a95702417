// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Scenes under limits that the first start does not lead to an answer of,
// against the indirect method, which shares no program with it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <utility>
#include <vector>

#include "brachisto/study/solve.hpp"

namespace brachisto {
namespace {

Scene cylinder_scene(double r, double eta, double theta_degrees, double k,
                     double L, PathLimits limits) {
  Scene scene;
  scene.L = L;
  scene.H = 1.0;
  scene.body =
      Body::cylinder(r, eta, theta_degrees * std::numbers::pi / 180.0, k);
  scene.limits = std::move(limits);
  return scene;
}

/// Verified, and T agrees with shooting over its arcs.
Solution confirmed(const Scene& scene) {
  SolveOptions options;
  options.use<Collocation>().certify = Certify::Extremal;
  Solution solution = solve(scene, options);
  EXPECT_TRUE(solution.verified())
      << solution.message
      << ::testing::PrintToString(solution.not_verified_because());
  EXPECT_TRUE(solution.extremal && solution.extremal->solved);
  return solution;
}

/// The cycloid of a bead passes a disc at 0.2648531203064. One that is greater
/// by a ten-thousandth is followed for 1e-5 of the path: a cycloid, an arc of
/// the circle and another cycloid, as in tests/search/limited_search.cpp, by
/// scipy.
TEST(HardLimits, ADiscThatIsHardlyTouchedIsFollowedAllTheSame) {
  struct Case {
    double radius, tau;
  };
  for (const auto& [radius, tau] :
       {Case{0.264953120306414, 4.51056314380051},
        Case{0.265153120306414, 4.51056320023721},
        Case{0.265853120306414, 4.51056384245616}}) {
    Scene scene;
    scene.body = Body::bead();
    scene.L = 3.0;
    scene.H = 1.0;
    scene.limits.discs = {{{1.2, 1.4}, radius}};

    const Solution solution = solve(scene, {});

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_LE(*solution.estimated_error, 1e-12) << radius;
    // scipy's τ, from junctions to 1e-15, is known to its last digit but two.
    EXPECT_NEAR(solution.motion()->tau(), tau,
                tau * *solution.estimated_error + 1e-12)
        << radius;
  }
}

/// The free track passes below the disc, where a half-plane leaves no room: an
/// elastic program that starts from it ends between the two.
TEST(HardLimits, APathGoesRoundADiscOnTheSideThatIsOpen) {
  PathLimits limits;
  limits.half_planes = {{{3.775, 1.549}, -107.6 * std::numbers::pi / 180.0}};
  limits.discs = {{{3.236, 1.191}, 0.063}};
  const Scene scene =
      cylinder_scene(0.4497, 0.137, -87.5, 0.851, 4.455, limits);

  const Solution solution = confirmed(scene);

  ASSERT_NE(solution.motion(), nullptr);
  const Motion& motion = *solution.motion();
  for (int i = 0; i <= 1000; ++i) {
    const Point centre = motion.at(i / 1000.0).centre;
    EXPECT_GE(std::hypot(centre.x - 3.236, centre.z - 1.191),
              0.063 + 0.4497 - 1e-9);
    if (std::abs(centre.x - 3.236) > 0.05) continue;
    EXPECT_LT(centre.z, 1.191);
  }
}

/// T is right to 1e-13 on elements that leave 3e-10 in the motion next to the
/// end of an arc, where curvature grows steeply.
TEST(HardLimits, ElementsAreHalvedUntilTheMotionIsAsAccurateAsTheTime) {
  PathLimits limits;
  limits.fold_margin = 0.422;

  const Solution solution =
      confirmed(cylinder_scene(0.6215, 0.645, 37.48, 0.43, 2.583, limits));

  EXPECT_LE(solution.certificate.find("reintegration_error")->value, 1e-10);
}

struct RoughScene {
  const char* name;
  Scene scene;
};

void PrintTo(const RoughScene& rough, std::ostream* out) {
  *out << rough.name;
}

class RoughElements : public ::testing::TestWithParam<RoughScene> {};

/// On those that are enough for T to 1e-11 slopes err by 1e-7: of the first
/// scene between nodes, of the second at nodes too, carried on from elements
/// that make errors of 1e-9. They are divided until slopes do not err by more
/// than 1e-8, or 1e-3 √tolerance.
TEST_P(RoughElements, AreDividedUntilSlopesAreAccurateToo) {
  constexpr double kAllowed = 1e-8;
  const Scene& scene = GetParam().scene;

  const Solution solution = solve(scene);
  const Solution shot = solve(scene, {.method = Shooting{}});

  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_TRUE(shot.verified()) << shot.message;
  for (int i = 0; i <= 1000; ++i) {
    const double sigma = i / 1000.0;
    EXPECT_NEAR(solution.motion()->at(sigma).beta,
                shot.motion()->at(sigma).beta, kAllowed)
        << sigma;
  }
}

PathLimits table_in_the_way() {
  PathLimits limits;
  limits.floor = 1.25;
  limits.discs = {{{1.35, 0.35}, 0.15}};
  return limits;
}

/// The contacts are optimal.
Scene bends_beside_a_board() {
  PathLimits limits;
  limits.half_planes = {{{1.147, 1.5}, -94.36 * std::numbers::pi / 180.0}};
  limits.curvature.valley = 1.182;
  limits.curvature.hump = 0.695;
  limits.curvature.of = CurvatureLimit::Of::Centre;
  Scene scene = cylinder_scene(0.0597, 0.408, 44.85, 0.407, 1.275, limits);
  scene.contact = Contact::Optimal;
  return scene;
}

INSTANTIATE_TEST_SUITE_P(
    HardLimits, RoughElements,
    ::testing::Values(RoughScene{"table_in_the_way",
                                 cylinder_scene(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5,
                                                3.0, table_in_the_way())},
                      RoughScene{"bends_beside_a_board",
                                 bends_beside_a_board()}),
    [](const auto& row) { return row.param.name; });

/// Slopes next to A would be more accurate yet on elements on which no arcs are
/// found: nothing is missing where they are not.
TEST(HardLimits, AnAnswerIsNoFailureWhereItsElementsCannotBeDivided) {
  PathLimits limits;
  limits.normal_min = 1e-5;

  const Solution solution =
      solve(cylinder_scene(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 3.0, limits));

  EXPECT_TRUE(solution.verified());
  EXPECT_EQ(solution.message, "solved under limits");
}

/// The greatest force of the free path is 1e-7 of it above the bound, along
/// some 1e-4 of the path. On elements that have not been divided yet that may
/// be an error of polynomials; for a certificate it is too much. An excess ε
/// along √ε of the path costs some ε^(3/2), 3e-11.
TEST(HardLimits, WhatThePathItselfExceedsIsHeldHoweverLittle) {
  constexpr double kBelow = 1e-7, kCost = 1e-10;
  Scene bead;
  bead.body.shape = Shape::Bead;
  bead.L = 1.56;
  bead.H = 1.0;
  Scene between_ends =
      cylinder_scene(0.374, 0.031, 23.0, 0.288, 2.45, PathLimits{});
  between_ends.contact = Contact::Centre;
  for (Scene scene : {bead, between_ends}) {
    const Solution free = solve(scene);
    ASSERT_TRUE(free.verified()) << free.message;
    const double most = free.diagnostics->max_normal_force.value;

    scene.limits.normal_max = most * (1.0 - kBelow);
    const Solution held = solve(scene);

    ASSERT_TRUE(held.verified())
        << ::testing::PrintToString(held.not_verified_because());
    EXPECT_NEAR(held.motion()->tau(), free.motion()->tau(), kCost);
  }
}

/// What is exceeded next to rest falls slowly as elements are divided, and is
/// an error of polynomials all the same.
TEST(HardLimits, WhatFallsSlowlyNextToRestIsNotThePaths) {
  PathLimits limits;
  limits.friction = 0.781;
  limits.discs = {{{2.873, 0.655}, 0.184}};

  const Solution solution =
      confirmed(cylinder_scene(0.1746, 0.326, -24.92, 0.683, 4.742, limits));

  EXPECT_LE(*solution.estimated_error, 1e-10);
}

/// Where the static cone ends next to the slope that a valley bound asks for,
/// friction holds for less and less of the way, for 12 nm at last, and from
/// 0.7218 on not at all. T is a smooth function of its coefficient up to there:
/// of equal steps of 5e-4 the third difference is 1e-10 of T'''.
TEST(HardLimits, AnArcFromRestMayBeAsShortAsItLikes) {
  const auto tau_at = [](double friction) {
    PathLimits limits;
    limits.friction = friction;
    limits.curvature = {2.7, 4.0, CurvatureLimit::Of::Centre};
    const Solution solution =
        confirmed(cylinder_scene(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 3.0, limits));
    EXPECT_LE(*solution.estimated_error, 1e-10) << friction;
    EXPECT_LE(solution.extremal->difference, 1e-11) << friction;
    return solution.motion()->tau();
  };
  constexpr double kThird = 1e-9;  // T''' is some 1 as T'' is 0.08
  const double third = tau_at(0.7215) - 3.0 * tau_at(0.7210) +
                       3.0 * tau_at(0.7205) - tau_at(0.72);
  EXPECT_NEAR(third, 0.0, kThird);
  // The border of the static cone alone holds, between the last one and what is
  // not bound.
  const double last = tau_at(0.72179);
  EXPECT_LT(last, tau_at(0.7215));
  EXPECT_GT(last, tau_at(0.75));
}

/// Between the ends of the centre such an arc is found however little it is
/// worth: at 0.6255 it spares 1.3e-11 of T.
TEST(HardLimits, AnArcFromRestIsFoundBetweenEndsOfTheCentre) {
  PathLimits limits;
  limits.friction = 0.6255;
  limits.curvature = {2.7, 4.0, CurvatureLimit::Of::Centre};
  Scene scene = cylinder_scene(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 3.0, limits);
  scene.contact = Contact::Centre;
  const Solution solution = confirmed(scene);
  EXPECT_LE(*solution.estimated_error, 1e-12);
  EXPECT_FALSE(solution.certificate.find("start_corner"));
}

/// The border of the static cone holds at A alone where what it asks for is
/// what the bound of valleys gives: with optimal contacts, or a cost of 1e-13.
TEST(HardLimits, ABorderMayHoldAtRestAlone) {
  const auto scene_with = [](Contact contact, double friction) {
    PathLimits limits;
    limits.friction = friction;
    limits.curvature = {2.7, 4.0, CurvatureLimit::Of::Centre};
    Scene scene = cylinder_scene(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 3.0, limits);
    scene.contact = contact;
    return scene;
  };
  for (const auto& [contact, friction] :
       {std::pair{Contact::Optimal, 1.07}, {Contact::Centre, 0.6265}}) {
    const Solution solution = confirmed(scene_with(contact, friction));
    EXPECT_LE(*solution.estimated_error, 1e-10);
    EXPECT_LE(solution.extremal->difference, 1e-11);
    EXPECT_TRUE(solution.certificate.find("start_corner_sign"));
    // Its price is the slope of whole solves, for T is one smooth function.
    constexpr double kStep = 1e-4;
    const auto tau_at = [&](double mu) {
      return confirmed(scene_with(contact, mu)).motion()->tau();
    };
    const double slope =
        (tau_at(friction + kStep) - tau_at(friction - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(*solution.limits.front().price, slope, 1e-3 * std::abs(slope));
  }
}

/// Between a valley and a hump the control jumps, and the body lifts off behind
/// the jump: the indirect method, which knows the arcs, has R_n = −0.265. A
/// mesh that knows none goes over the jump, with 0.024 at its points.
TEST(HardLimits, WhatAMeshWithoutArcsMayHideIsNotFeasible) {
  PathLimits limits;
  limits.curvature = {2.264508886224581, 0.9489034148238713};
  Scene scene = cylinder_scene(0.20375877981757287, 0.342,
                               -2.446513371520144 * 180.0 / std::numbers::pi,
                               0.1545147539558567, 3.466165865959849, limits);
  scene.contact = Contact::Centre;

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_FALSE(solution.feasible() && solution.undecided_because().empty());
}

/// And until the contacts are as closed as the certificate wants them.
TEST(HardLimits, ElementsAreHalvedUntilTheContactsAreClosed) {
  PathLimits limits;
  limits.floor = 1.627;
  limits.curvature.hump = 0.675;
  limits.curvature.of = CurvatureLimit::Of::Centre;

  const Solution solution =
      confirmed(cylinder_scene(1.1774, 0.43, 53.84, 0.224, 4.892, limits));

  EXPECT_LE(solution.certificate.find("contact_error")->value, 1e-9);
}

/// Where friction gives way to a free arc the valley's bound is reached too: an
/// arc along it has 2e-6 of the path, and its equations are rounding.
TEST(HardLimits, AnArcOfNothingIsLeftOut) {
  PathLimits limits;
  limits.friction = 0.504;
  limits.curvature.valley = 2.529;
  limits.curvature.of = CurvatureLimit::Of::Centre;

  const Solution solution =
      confirmed(cylinder_scene(0.8737, 0.71, -76.35, 0.346, 4.101, limits));

  ASSERT_FALSE(solution.limits.empty());
  for (const LimitOnPath& limit : solution.limits) {
    for (const ActiveArc& arc : limit.active) {
      EXPECT_GT(arc.sigma.to - arc.sigma.from, 1e-5) << limit.name;
    }
  }
}

/// Resistance in proportion to the load asks for a slope beyond the vertical at
/// rest, where the body would lift off: at first it rolls down without load,
/// along 3e-4 of the path, where no point of a mesh lies.
TEST(HardLimits, ABodyWithRollingResistanceBeginsWithoutLoad) {
  PathLimits limits;
  limits.normal_min = 0.0;
  limits.normal_max = 2.465;
  Scene scene = cylinder_scene(0.0327, 0.0, 0.0, 0.243, 1.525, limits);
  scene.world.losses.rolling = 0.0025;

  const Solution solution = confirmed(scene);

  ASSERT_FALSE(solution.limits.empty());
  const std::vector<ActiveArc>& least_load = solution.limits[0].active;
  ASSERT_EQ(least_load.size(), 1U);
  EXPECT_EQ(least_load[0].sigma.from, 0.0);
  ASSERT_NE(solution.motion(), nullptr);
  const double end = least_load[0].sigma.to;
  for (const double share : {0.1, 0.5, 0.9}) {
    const TrajectoryPoint falling = solution.motion()->at(share * end);
    EXPECT_NEAR(falling.beta, std::numbers::pi / 2.0, 1e-9);
    // As along a vertical wall that it only touches, rolling.
    const double fall = scene.gravity / (1.0 + scene.body.k);
    EXPECT_NEAR(falling.s, 0.5 * fall * falling.t * falling.t,
                1e-9 * falling.s);
  }
}

/// Next to A friction holds behind a hump, and what its polynomials exceed the
/// bound by falls slowly there. No other arc could hold what holds already.
TEST(HardLimits, WhatALimitThatHoldsIsExceededByIsDividedFor) {
  PathLimits limits;
  limits.friction = 0.917;
  limits.curvature.hump = 1.101;
  limits.curvature.of = CurvatureLimit::Of::Centre;
  Scene scene = cylinder_scene(0.4325, 0.676, -34.93, 0.411, 2.059, limits);
  scene.world.air.linear = 0.04;
  scene.world.air.quadratic = 0.013;

  confirmed(scene);
}

/// Its first path meets all conditions but the sign of a multiplier: others are
/// faster, and the program that it is a start for leads to one.
TEST(HardLimits, APathWhoseMultiplierHasTheWrongSignIsLeft) {
  PathLimits limits;
  limits.floor = 1.329;
  limits.fold_margin = 0.348;
  limits.curvature.valley = 0.536;
  limits.curvature.of = CurvatureLimit::Of::Centre;

  const Solution solution =
      confirmed(cylinder_scene(0.268, 0.061, 57.85, 0.766, 4.165, limits));

  // As from random starts of a program on 30 elements of degree 3.
  ASSERT_NE(solution.motion(), nullptr);
  EXPECT_NEAR(solution.motion()->tau(), 7.10096, 1e-4);
}

TEST(HardLimits, ForcesOfASmallBodyAreHeldToTheirRounding) {
  // Eight turns with three arcs to each. Terms of the force are some 10⁴ m g,
  // so that no limit is kept to 1e-11 in the numbers that there are.
  for (const double friction : {5.0, 1.5, 1.35}) {
    PathLimits limits;
    limits.friction = friction;
    Scene scene = cylinder_scene(0.05, 2.0 / 3.0, -30.0, 0.5, 2.5, limits);
    scene.H = 2.0;

    const Solution found = confirmed(scene);

    ASSERT_TRUE(found.extremal) << friction;
    EXPECT_LE(found.extremal->difference, 1e-12) << friction;
  }
}

/// A slope at A that is free would rather be within the static cone: the path
/// turns as fast as humps may for a millionth of its length until it comes to
/// the limit on forces, which from rest on would turn it faster still.
TEST(HardLimits, FreeSlopesAreLedToTheLimitOnForcesByTheBoundOfHumps) {
  PathLimits load, friction, all;
  load.normal_min = 0.4875;
  load.normal_max = 2.0;
  load.curvature.hump = 2.0;
  friction.friction = 0.5;
  friction.curvature.hump = 1.3;
  friction.curvature.valley = 1.9;
  Scene small = cylinder_scene(0.028, 0.0, 0.0, 0.35, 0.8, load);
  small.H = 0.2;
  Scene off_centred = cylinder_scene(0.24, 0.2, -15.0, 0.5, 4.0, friction);
  off_centred.H = 0.92;
  all.friction = 0.815;
  all.normal_max = 3.95;
  all.curvature.hump = 1.02;
  all.curvature.valley = 1.22;
  Scene in_field = cylinder_scene(0.141, 0.0, 0.0, 0.326, 3.696, all);
  in_field.H = 1.896;
  in_field.world.losses.rolling = 0.0013;
  in_field.world.sphere = Sphere{{-1.1, 29.0}, 37.6, 9.81};
  for (Scene* scene : {&small, &off_centred, &in_field}) {
    scene->contact = Contact::Optimal;
    const double hump = *scene->limits.curvature.hump;

    const Solution found = confirmed(*scene);

    ASSERT_TRUE(found.diagnostics && found.extremal);
    EXPECT_LE(found.extremal->difference, 1e-13);
    EXPECT_LE(found.diagnostics->max_curvature.value, hump * (1.0 + 1e-9));
  }
}

/// A ball in a sharp groove has the moment of many: its slope turns in a layer
/// behind the arc along which its friction is used up, which changes the sign
/// of the multiplier at the last point of that arc on coarse elements.
TEST(HardLimits, SignsAreRightNextToThinLayers) {
  for (const double friction : {0.4, 0.6, 1.0}) {
    PathLimits limits;
    limits.friction = friction;
    Scene scene = cylinder_scene(0.1, 0.0, 0.0, 0.4, 2.0, limits);
    scene.body = Body::rolling_ball(
        {.radius = 0.1, .k = 0.4, .groove = 12.0 * std::numbers::pi / 180.0},
        0.0);

    const Solution found = confirmed(scene);

    ASSERT_TRUE(found.extremal) << friction;
    EXPECT_LE(found.extremal->difference, 1e-12) << friction;
  }
}

/// On a mesh without arcs equations depend on each other, and one of the zero
/// eigenvalues is counted as positive.
TEST(HardLimits, NoMatrixHasMorePositiveEigenvaluesThanVariables) {
  PathLimits limits;
  limits.friction = 2.0;
  limits.curvature.hump = 3.9;
  limits.curvature.valley = 5.6;
  Scene scene = cylinder_scene(0.073, 0.48, -120.0, 0.7, 0.8, limits);
  scene.H = 0.29;
  scene.contact = Contact::Optimal;

  const Solution found = solve(scene, {});

  ASSERT_TRUE(found.verified()) << found.message;
  EXPECT_LE(*found.estimated_error, 1e-5);
  // Between 1.95 and 2.05, as solved with tolerance 1e-9 on arcs.
  EXPECT_NEAR(found.motion()->tau(), 5.215122253020637,
              *found.estimated_error * 5.2151);
}

/// In this air the free extremal is followed from still air to 0.12 of the
/// drag, no further. The program on 30 elements of degree 3, which keeps limits
/// at its points alone, came to τ = 7.914 from three of six other random paths.
TEST(HardLimits, RandomPathsLeadWhereTheFreeExtremalIsNotReached) {
  PathLimits limits;
  limits.normal_max = 3.217;
  Scene scene = cylinder_scene(0.9929, 0.769, 28.3, 0.254, 4.457, limits);
  scene.world.air.linear = 0.034;
  scene.world.air.quadratic = 0.06;

  const Solution solution = confirmed(scene);

  ASSERT_NE(solution.motion(), nullptr);
  EXPECT_NEAR(solution.motion()->tau(), 7.914, 2e-3 * 7.914);
  EXPECT_NE(solution.message.find("others may be faster"), std::string::npos);
}

}  // namespace
}  // namespace brachisto
