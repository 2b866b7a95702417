// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// solve() with its default options against values of other methods.

#include "support/reference_values.hpp"
#include "paper/names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {
namespace {

using testing::kReferenceValues;
using testing::ReferenceValue;
using testing::Source;

// By default the mesh is refined until T agrees to 1e-10 with one degree more;
// ten times that leaves room for what the agreement does not see.
constexpr double kTimeTolerance = 1e-9;
// A cycloid is smooth: the first mesh already solves it to rounding, and what
// is left is the KKT tolerance of 1e-12.
constexpr double kClosedFormTolerance = 1e-11;
// Lengths and angles converge with the order of T but with constants of their
// own, at worst some ten times greater (tests of convergence); 100 for room.
constexpr double kPathTolerance = 100.0 * kTimeTolerance;
// The table gives 12 digits of τ; what it lacks is no error of ours.
constexpr double kReferenceDigits = 1e-12;

class ReferenceValues : public ::testing::TestWithParam<ReferenceValue> {};

INSTANTIATE_TEST_SUITE_P(AllRows, ReferenceValues,
                         ::testing::ValuesIn(kReferenceValues),
                         testing::row_name);

TEST_P(ReferenceValues, AreReproducedAndVerified) {
  const ReferenceValue& expected = GetParam();

  const Solution solution = solve(expected.scene());

  ASSERT_TRUE(solution.verified()) << solution.message;
  const Trajectory& path = *trajectory_of(solution);
  const double tolerance = expected.source == Source::ClosedForm
                               ? kClosedFormTolerance
                               : kTimeTolerance;
  EXPECT_NEAR(path.tau(), expected.tau, tolerance * expected.tau);
  EXPECT_NEAR(path.start_angle(), expected.start_angle, kPathTolerance);
  EXPECT_NEAR(path.end_angle(), expected.end_angle, kPathTolerance);
  EXPECT_NEAR(path.centre_path_length(), expected.centre_path_length,
              kPathTolerance * expected.centre_path_length);
  EXPECT_NEAR(path.rail_length(), expected.rail_length,
              kPathTolerance * expected.rail_length);
}

TEST_P(ReferenceValues, TheEstimatedErrorIsNeitherTooSmallNorFarTooGreat) {
  const ReferenceValue& expected = GetParam();
  constexpr double kGreatestRatio = 100.0;

  const Solution solution = solve(expected.scene());

  ASSERT_TRUE(trajectory_of(solution) && solution.estimated_error);
  const double error = std::abs(solution.motion()->tau() / expected.tau - 1.0);
  EXPECT_GE(*solution.estimated_error, error - kReferenceDigits);
  EXPECT_LE(*solution.estimated_error,
            std::max(kGreatestRatio * error, kReferenceDigits));
}

TEST(HalfAnArchOfTheCycloid, TakesTheTimeOfTheClosedForm) {
  // The centre runs from the cusp (r, 0) to the lowest point (r + π, 2) of a
  // cycloid with a = 1, ψ_end = π: T = ψ_end √(a/g) √(1 + k) = π √(3/(2g)).
  using std::numbers::pi;
  for (const double r : {0.1, 1.0 / 3.0, 1.0}) {
    Scene scene;
    scene.body = Body::cylinder(r, 0.0, 0.0, 0.5);
    scene.L = r + pi;
    scene.H = r + 2.0;
    const double expected = pi * std::sqrt(1.5 / scene.gravity);

    const Solution solution = solve(scene);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_NEAR(solution.motion()->transit_time(), expected,
                kClosedFormTolerance * expected)
        << "r = " << r;
    EXPECT_NEAR(solution.motion()->end_angle(), 0.0, kClosedFormTolerance)
        << "r = " << r;
  }
}

TEST(AVanishingCylinder, IsABeadWithMoreInertia) {
  // As r → 0 the centre's path becomes the bead's and A = 1 + k stays:
  // τ → τ_bead √(1 + k), with a difference of the order of r.
  const ReferenceValue& bead = testing::reference("bead_L3");
  const double k = 0.5;
  const double limit = bead.tau * std::sqrt(1.0 + k);
  Scene scene = bead.scene();
  double previous = 0.0;
  for (const double r : {1e-3, 1e-4, 1e-5}) {
    scene.body = Body::cylinder(r, 0.0, 0.0, k);

    const Solution solution = solve(scene);

    ASSERT_TRUE(solution.verified()) << solution.message;
    const double slope = (solution.motion()->tau() - limit) / r;
    // The slope of τ over r tends to a constant, with an error of O(r).
    if (previous != 0.0) {
      EXPECT_NEAR(slope / previous, 1.0, 1e-2);
    }
    previous = slope;
  }
}

}  // namespace
}  // namespace brachisto
