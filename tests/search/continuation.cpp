// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/continuation.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "model/units.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;

Continuation follow(const testing::ReferenceValue& row,
                    const StopCondition& stop = {}) {
  const Scene scene = in_natural_units(row.scene());
  return continue_from_cycloid(scene, *axisymmetric_optimum(scene),
                               uniform_mesh(5, 16), stop);
}

TEST(Continuation, EndsNextToTheExtremalOfTheScene) {
  // A mesh of 16 elements has φ to five digits.
  constexpr double kCoarse = 1e-4;
  for (const auto* row :
       {&reference("reference_case"), &reference("fast"),
        &reference("theta_-90"), &reference("theta_90"), &reference("L4")}) {
    const Continuation found = follow(*row);

    ASSERT_EQ(found.status, Status::Solved) << row->name << found.message;
    ASSERT_TRUE(found.curve) << row->name;
    EXPECT_NEAR(found.phi, row->end_angle, kCoarse) << row->name;
    EXPECT_EQ(found.steps.front().eta_m, 0.0) << row->name;
    EXPECT_DOUBLE_EQ(found.steps.back().eta_m, row->eta_m) << row->name;
    int steps = 0;
    for (const ContinuationStep& step : found.steps) steps += step.newton_steps;
    EXPECT_LE(steps, found.newton_steps) << row->name;
  }
}

TEST(Continuation, OfACentredBodyIsTheCycloid) {
  for (const auto* row : {&reference("bead_L3"), &reference("uniform_L4")}) {
    const Continuation found = follow(*row);

    ASSERT_EQ(found.status, Status::Solved) << row->name << found.message;
    EXPECT_NEAR(found.phi, row->end_angle, 1e-8) << row->name;
    EXPECT_EQ(found.rejected_steps, 0) << row->name;
  }
}

TEST(Continuation, StopsWhenAskedTo) {
  const std::atomic<int> flag{15};

  const Continuation interrupted =
      follow(reference("fast"), StopCondition(3600.0, &flag));
  const Continuation late =
      follow(reference("fast"), StopCondition(0.0, nullptr));

  EXPECT_EQ(interrupted.status, Status::Interrupted);
  EXPECT_EQ(late.status, Status::TimeLimit);
  for (const Continuation* one : {&interrupted, &late}) {
    EXPECT_FALSE(one->curve);
    EXPECT_LE(one->newton_steps, 1);
  }
}

TEST(Continuation, SaysHowFarItCameWhereTheBranchTurnsBack) {
  // This branch has a fold at η = 0.746 on its way to 0.8.
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 0.8, 0.5 * std::acos(-1.0), 0.01);
  scene.L = 3.0;
  scene.H = 1.0;
  scene = in_natural_units(scene);

  const Continuation found = continue_from_cycloid(
      scene, *axisymmetric_optimum(scene), uniform_mesh(5, 20), {});

  EXPECT_EQ(found.status, Status::NotConverged);
  EXPECT_FALSE(found.curve);
  EXPECT_LE(found.steps.back().eta_m, 0.7464);
  EXPECT_NE(found.message.find("was followed to η_m = 0.746"),
            std::string::npos)
      << found.message;
}

}  // namespace
}  // namespace brachisto
