// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Prices of bounds against whole solves under other bounds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "support/limited_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

/// A bound of a scene, and how it is moved in the unit that its price is by.
struct Bound {
  std::string test, limit;
  Scene scene;
  std::function<void(PathLimits&, double by)> move;
  /// Of the differences, in the unit of the bound.
  double step = 1e-4;
};

std::ostream& operator<<(std::ostream& out, const Bound& bound) {
  return out << bound.test;
}

void move_friction(PathLimits& limits, double by) {
  *limits.friction += by;
}
void move_least_force(PathLimits& limits, double by) {
  *limits.normal_min += by;
}
void move_greatest_force(PathLimits& limits, double by) {
  *limits.normal_max += by;
}
void move_valley(PathLimits& limits, double by) {
  *limits.curvature.valley += by;
}
void move_fold_margin(PathLimits& limits, double by) {
  *limits.fold_margin += by;
}
void move_floor(PathLimits& limits, double by) {
  *limits.floor += by;
}
void move_disc(PathLimits& limits, double by) {
  limits.discs.front().radius += by;
}
void move_half_plane(PathLimits& limits, double by) {
  HalfPlane& plane = limits.half_planes.front();
  plane.point.x += by * std::cos(plane.normal);
  plane.point.z += by * std::sin(plane.normal);
}

/// A stone that the free track would run over.
PathLimits stone() {
  PathLimits limits;
  limits.discs = {{{1.5, 1.4}, 0.1}};
  return limits;
}
/// A floor that rises towards B by 0.05 rad, its normal away from the vertical.
PathLimits slanting_floor() {
  PathLimits limits;
  limits.half_planes = {{{1.5, 1.25}, -0.5 * kPi - 0.05}};
  return limits;
}
PathLimits valley_of_track(double K) {
  PathLimits limits;
  limits.curvature = {{}, K, CurvatureLimit::Of::Track};
  return limits;
}
PathLimits margin_and_valley(double margin, double K) {
  PathLimits limits = bends({}, K);
  limits.fold_margin = margin;
  return limits;
}
PathLimits hump_and_force(double K, double R_n) {
  PathLimits limits = bends(K, {});
  limits.normal_max = R_n;
  return limits;
}

/// Friction holds the control along the arc on which the floor is reached.
Scene touching_its_floor() {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 0.8, -0.5, 0.3);
  scene.L = 5.0;
  scene.H = 1.0;
  PathLimits limits = friction(0.9);
  limits.floor = 1.59;
  return under(scene, limits);
}

/// The load reaches its bound at one point of a hump that another limit keeps
/// as flat as it is.
Scene touching_its_load() {
  Scene scene;
  scene.body = Body::cylinder(0.3, 0.25, 0.136, 0.876);
  scene.L = 3.25;
  scene.H = 1.0;
  PathLimits limits = bends(0.003, 3.2);
  limits.normal_max = 2.08;
  return under(scene, limits, Contact::Optimal);
}

/// Limits hold everywhere: the path is given by its junctions.
Scene held_everywhere() {
  Scene scene;
  scene.body = Body::cylinder(0.585, 0.09, -0.69, 0.86);
  scene.L = 3.23;
  scene.H = 1.0;
  PathLimits limits = least_force(0.386);
  limits.normal_max = 1.123;
  limits.floor = 1.276;
  return under(scene, limits);
}

/// With a little less friction than 0.47, at 0.46973, the free arc vanishes
/// that lies between all of it forwards and all of it backwards: τ has a kink.
Scene small_cylinder(double mu) {
  Scene scene;
  scene.body = Body::cylinder(0.04, 0.4, 0.0, 0.5);
  scene.L = 1.2;
  scene.H = 0.4;
  return under(scene, friction(mu));
}

/// The same scene, λ times as large, under another gravity; limits of forces
/// have no unit.
Scene enlarged(Scene scene, double length, double gravity) {
  scene.body.radius *= length;
  scene.L *= length;
  scene.H *= length;
  scene.gravity = gravity;
  if (scene.limits.floor) *scene.limits.floor *= length;
  if (scene.limits.curvature.valley) *scene.limits.curvature.valley /= length;
  for (Disc& disc : scene.limits.discs) {
    disc.centre = {disc.centre.x * length, disc.centre.z * length};
    disc.radius *= length;
  }
  return scene;
}
constexpr double kLength = 2.5, kGravity = 1.62;

std::vector<Bound> bounds() {
  const Scene base = off_centred_scene();
  const double r = base.body.radius;
  constexpr auto kOptimal = Contact::Optimal;
  const auto optimal = [&](const PathLimits& limits) {
    return under(base, limits, kOptimal);
  };
  return {
      {"Friction1", "friction", under(base, friction(1.0)), move_friction},
      {"Friction06", "friction", under(base, friction(0.6)), move_friction},
      {"Friction03", "friction", under(base, friction(0.3)), move_friction},
      {"LeastForce", "normal_force.min", under(base, least_force(0.1)),
       move_least_force},
      {"ValleyOfTheTrack", "curvature.valley",
       under(base, valley_of_track(1.2)), move_valley},
      {"FloorOfABead", "floor", under(bead_scene(), floor_at(1.1)), move_floor},
      {"HalfPlane", "clear_of.half_plane", under(base, slanting_floor()),
       move_half_plane},
      {"OptimalFoldMargin", "fold_margin",
       under(uniform_scene(), margin_and_valley(0.75, 2.0), kOptimal),
       move_fold_margin},
      {"OptimalGreatestForce", "normal_force.max",
       optimal(hump_and_force(2.7, 8.0)), move_greatest_force},
      {"LargeFloor", "floor",
       enlarged(under(base, floor_at(0.9 + r)), kLength, kGravity), move_floor,
       1e-4 * kLength},
      {"FrictionThatTouches", "friction", touching_its_floor(), move_friction},
      {"FloorThatIsTouched", "floor", touching_its_floor(), move_floor},
      {"ForceThatIsTouched", "normal_force.max", touching_its_load(),
       move_greatest_force},
      {"ForceThatHoldsEverywhere", "normal_force.max", held_everywhere(),
       move_greatest_force},
      {"FrictionAboveAKink", "friction", small_cylinder(0.47), move_friction,
       1e-5},
      {"FrictionBelowAKink", "friction", small_cylinder(0.4696), move_friction,
       3e-6},
      {"LargeDisc", "clear_of.disc",
       enlarged(under(base, stone()), kLength, kGravity), move_disc,
       1e-4 * kLength},
  };
}

const LimitOnPath& limit_named(const Solution& solution,
                               const std::string& name) {
  const auto found = std::find_if(
      solution.limits.begin(), solution.limits.end(),
      [&](const LimitOnPath& limit) { return limit.name == name; });
  if (found == solution.limits.end()) throw std::out_of_range(name);
  return *found;
}

class Price : public ::testing::TestWithParam<Bound> {
 protected:
  static double tau_at(double by) {
    Scene scene = GetParam().scene;
    GetParam().move(scene.limits, by);
    const Solution solution = solve(scene);
    EXPECT_TRUE(solution.verified()) << solution.message;
    return solution.motion() != nullptr ? solution.motion()->tau() : 0.0;
  }
  static double difference(double step) {
    return (tau_at(step) - tau_at(-step)) / (2.0 * step);
  }
};

/// Central differences err by step² τ‴/6: what halving the step changes is
/// three quarters of that. τ is known to 1e-12, over the step 1e-8; the price's
/// own residuals are as small.
TEST_P(Price, IsTheSlopeOfTheTimeOfWholeSolves) {
  const Bound& bound = GetParam();
  constexpr double kAllowed = 1e-6;

  const Solution solution = solve(bound.scene);
  ASSERT_TRUE(solution.verified()) << solution.message;
  const LimitOnPath limit = limit_named(solution, bound.limit);
  ASSERT_FALSE(limit.active.empty());
  ASSERT_TRUE(limit.price);

  EXPECT_NEAR(*limit.price, difference(bound.step), kAllowed);
}

class OptimalPrice : public Price {};

TEST_P(OptimalPrice, IsThatAtFixedContacts) {
  const Bound& bound = GetParam();
  // Moving what is optimal is worth nothing; junctions and optimality are
  // solved to 1e-10 and their slopes are found by steps of 1e-6, whose ends
  // have rounding of some 1e-14: to 1e-8 of what moves.
  constexpr double kAllowed = 1e-8;

  const Solution solution = solve(bound.scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  for (const LimitOnPath& limit : solution.limits) {
    ASSERT_TRUE(limit.price && limit.price_at_fixed_contacts);
    EXPECT_NEAR(*limit.price, *limit.price_at_fixed_contacts,
                kAllowed * std::max(1.0, std::abs(*limit.price)))
        << limit.name;
    // A sharper bound cannot be faster where nothing else moves.
    const bool from_below =
        limit.name == "normal_force.min" || limit.name == "fold_margin";
    EXPECT_LE(from_below ? -*limit.price : *limit.price, 0.0) << limit.name;
  }
}

std::vector<Bound> optimal_bounds() {
  std::vector<Bound> some = bounds();
  std::erase_if(some, [](const Bound& bound) {
    return bound.scene.contact != Contact::Optimal;
  });
  return some;
}
INSTANTIATE_TEST_SUITE_P(Bounds, Price, ::testing::ValuesIn(bounds()),
                         [](const auto& row) { return row.param.test; });
INSTANTIATE_TEST_SUITE_P(Bounds, OptimalPrice,
                         ::testing::ValuesIn(optimal_bounds()),
                         [](const auto& row) { return row.param.test; });

/// A bead comes down half a cycloid and stays on the floor up to B. On one that
/// is lower by df it rises to B at the end, which costs no more than df^(3/2):
/// τ = π √f/2 + (L − π f/2)/√f, of which f = H = 1 leaves π/4 − L/2.
TEST(PriceOfAFloor, ThatEndsAtBIsInClosedForm) {
  for (const double L : {3.0, 5.0}) {
    Scene scene;
    scene.body = Body::bead();
    scene.L = L;
    scene.H = 1.0;
    const Solution solution = solve(under(scene, floor_at(1.0)));
    ASSERT_TRUE(solution.verified()) << solution.message;
    const LimitOnPath floor = limit_named(solution, "floor");
    EXPECT_NEAR(*floor.price, 0.25 * kPi - 0.5 * L, 1e-8);
    EXPECT_NEAR(*floor.price_at_fixed_contacts, 0.25 * kPi - 0.5 * L, 1e-8);
  }
}

/// No path next to it holds it either.
TEST(PriceOfASlackLimit, IsZero) {
  PathLimits limits = least_force(0.1);
  limits.floor = 2.0;
  const Solution solution = solve(under(off_centred_scene(), limits));
  ASSERT_TRUE(solution.verified()) << solution.message;
  const LimitOnPath floor = limit_named(solution, "floor");
  ASSERT_TRUE(floor.active.empty());
  EXPECT_EQ(floor.price, 0.0);
  EXPECT_EQ(floor.price_at_fixed_contacts, 0.0);
}

class PriceAtRest : public ::testing::TestWithParam<double> {};

/// A bound too small for an arc decides the direction at A all the same. A step
/// of a hundredth of the bound leaves a ten-thousandth of the difference, and
/// rounding of T, some 1e-14, no more of that at the smallest.
TEST_P(PriceAtRest, IsTheSlopeOfTheTimeOfWholeSolves) {
  const double bound = GetParam(), step = 0.01 * bound;
  const auto solved = [](double least) {
    return solve(under(off_centred_scene(), least_force(least)));
  };
  const Solution solution = solved(bound);
  ASSERT_TRUE(solution.verified()) << solution.message;
  const LimitOnPath limit = limit_named(solution, "normal_force.min");
  ASSERT_EQ(limit.active.size(), 1u) << "touched at A";
  EXPECT_EQ(limit.active[0].sigma.to, 0.0);
  EXPECT_NEAR(solution.motion()->at_start().normal_force, bound, 1e-12);
  const double slope = (solved(bound + step).motion()->tau() -
                        solved(bound - step).motion()->tau()) /
                       (2.0 * step);
  EXPECT_LT(slope, -0.1);
  EXPECT_NEAR(*limit.price, slope, 1e-3 * std::abs(slope));
}
INSTANTIATE_TEST_SUITE_P(Bounds, PriceAtRest, ::testing::Values(3e-5, 1e-6));

/// dτ by metre falls with the metre, dτ by its inverse grows.
TEST(PriceUnits, AreThoseOfTheBound) {
  const Scene base = off_centred_scene();
  const double r = base.body.radius;
  struct Row {
    const char* limit;
    Scene scene;
    double power;
  };
  for (const auto& [limit, scene, power] :
       {Row{"floor", under(base, floor_at(0.9 + r)), -1.0},
        Row{"curvature.valley", under(base, bends({}, 2.0)), 1.0}}) {
    const Solution small = solve(scene);
    const Solution large = solve(enlarged(scene, kLength, kGravity));
    ASSERT_TRUE(small.verified() && large.verified()) << limit;
    const LimitOnPath a = limit_named(small, limit);
    const LimitOnPath b = limit_named(large, limit);

    const double scale = std::pow(kLength, power);
    EXPECT_NEAR(*b.price, scale * *a.price, 1e-7) << limit;
    EXPECT_NEAR(*b.price_at_fixed_contacts, scale * *a.price_at_fixed_contacts,
                1e-7)
        << limit;
    EXPECT_NEAR(b.share_of_time, a.share_of_time, 1e-7) << limit;
    const double seconds = std::sqrt(kLength / (2.0 * kGravity));
    EXPECT_NEAR(large.motion()->transit_time(), small.motion()->tau() * seconds,
                1e-9 * seconds)
        << limit;
  }
}

/// A price of −0.0684 of μ = 0.3 is three numbers: what the multiplier says,
/// and what the contacts add by moving.
TEST(PriceParts, AreThoseOfTheIndirectMethod) {
  const double published[][3] = {{1.0, 0.0018, -0.0019}, {0.3, -0.068, -0.153}};
  for (const auto& [mu, total, at_fixed] : published) {
    const Solution solution = solve(under(off_centred_scene(), friction(mu)));

    ASSERT_TRUE(solution.verified());
    const double digit = mu == 1.0 ? 0.5e-4 : 0.5e-3;
    EXPECT_NEAR(*solution.limits.front().price, total, digit);
    EXPECT_NEAR(*solution.limits.front().price_at_fixed_contacts, at_fixed,
                digit);
  }
}

}  // namespace
}  // namespace brachisto
