// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "support/numbers.hpp"

namespace brachisto {
namespace {

using testing::kPi;
using enum BodyKey;

const Body kBody = Body::cylinder(0.4, 0.5, -0.3, 0.3);

DesignPlan plan_of(std::vector<BodyKey> free) {
  DesignPlan plan;
  plan.free = std::move(free);
  plan.bounds[static_cast<std::size_t>(Radius)] = {0.1, 0.6};
  if (!plan.is_free(Radius)) plan.bounds = {};
  return plan;
}

/// A ring as large as the cylinder, a weight and a small disc.
DesignPlan plan_of_parts() {
  DesignPlan plan;
  plan.parts = {MassPart::ring(2.0, {}, 0.4), MassPart::point(0.7, {0.1, -0.2}),
                MassPart::disc(0.4, {-0.1, 0.05}, 0.1)};
  plan.free_parts = {{1, FreePart::Key::At, {}},
                     {2, FreePart::Key::At, {}},
                     {1, FreePart::Key::Mass, {0.2, 3.0}}};
  return plan;
}

std::vector<DesignPlan> plans() {
  DesignPlan bounded = plan_of({EtaM, ThetaM, K});
  bounded.bounds = {DesignBounds{0.1, 0.8}, DesignBounds{-0.5, 0.4},
                    DesignBounds{0.1, 0.6}, std::nullopt};
  return {plan_of({EtaM, ThetaM, K}),
          plan_of({EtaM, ThetaM, K, Radius}),
          plan_of({EtaM}),
          plan_of({ThetaM, Radius}),
          plan_of({K}),
          bounded,
          plan_of_parts()};
}

TEST(Traits, SayAllOfABody) {
  const Body there = body_of(traits_of(kBody), kBody);

  // A product with a cosine, and back by a root: a few roundings.
  constexpr double kRounding = 1e-15;
  EXPECT_NEAR(there.eta_m, kBody.eta_m, kRounding);
  EXPECT_NEAR(there.theta_m, kBody.theta_m, kRounding);
  EXPECT_EQ(there.k, kBody.k);
  EXPECT_EQ(there.radius, kBody.radius);
}

TEST(Traits, TakeTheAngleNextToAnother) {
  Body turned = kBody;
  turned.theta_m = 3.1;
  Body like = kBody;
  like.theta_m = -3.0;

  EXPECT_NEAR(body_of(traits_of(turned), like).theta_m, 3.1 - 2.0 * kPi,
              1e-15 * 10.0);
}

TEST(DesignSpace, HasTheDerivativesOfItsFunctions) {
  // Central differences of functions whose third derivatives are below 100.
  constexpr double kStep = 1e-5;
  constexpr double kError = 100.0 * kStep * kStep;
  for (const DesignPlan& plan : plans()) {
    const std::unique_ptr<DesignSpace> space = design_space(plan, kBody);
    const Eigen::VectorXd y = space->first();
    const Eigen::MatrixXd traits = space->traits_jacobian(y);
    const Eigen::MatrixXd rows = space->row_jacobian(y);
    ASSERT_EQ(rows.rows(), static_cast<Eigen::Index>(space->rows().size()));
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      Eigen::VectorXd above = y, below = y;
      above[i] += kStep;
      below[i] -= kStep;
      const Eigen::VectorXd of_traits =
          (space->traits(above) - space->traits(below)) / (2.0 * kStep);
      EXPECT_LT((of_traits - traits.col(i)).norm(), kError)
          << space->names()[static_cast<std::size_t>(i)];
      const Eigen::VectorXd of_rows =
          (space->row_values(above) - space->row_values(below)) / (2.0 * kStep);
      EXPECT_LT((of_rows - rows.col(i)).norm(), kError)
          << space->names()[static_cast<std::size_t>(i)];
    }
  }
}

TEST(DesignSpace, SlopesAreByTheNumbersThatItTells) {
  // f = c · traits: its slopes over η_m, θ_m, k and r by differences.
  const Traits c{0.3, -0.7, 1.1, 0.4};
  const DesignPlan plan = plan_of({EtaM, ThetaM, K, Radius});
  const std::unique_ptr<DesignSpace> space = design_space(plan, kBody);
  constexpr double kStep = 1e-5;
  double Body::*const members[] = {&Body::eta_m, &Body::theta_m, &Body::k,
                                   &Body::radius};

  const NamedNumbers slopes = space->slopes(space->first(), c);

  ASSERT_EQ(slopes.size(), 4U);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    Body above = kBody, below = kBody;
    above.*members[i] += kStep;
    below.*members[i] -= kStep;
    EXPECT_NEAR(slopes[i].value,
                c.dot(traits_of(above) - traits_of(below)) / (2.0 * kStep),
                kStep * kStep)
        << slopes[i].name;
  }
}

TEST(DesignSpace, RandomBodiesKeepBoundsAndRows) {
  for (const DesignPlan& plan : plans()) {
    const std::unique_ptr<DesignSpace> space = design_space(plan, kBody);
    SplitMix64 random(7);
    for (int i = 0; i < 200; ++i) {
      const Eigen::VectorXd y = space->random(random);
      for (std::size_t j = 0; j < space->lower().size(); ++j) {
        const double value = y[static_cast<Eigen::Index>(j)];
        EXPECT_GE(value, space->lower()[j]) << space->names()[j];
        EXPECT_LE(value, space->upper()[j]) << space->names()[j];
      }
      // The lower bound of an offset may be hit to rounding.
      constexpr double kRounding = 1e-12;
      const Eigen::VectorXd rows = space->row_values(y);
      for (std::size_t j = 0; j < space->rows().size(); ++j) {
        const double value = rows[static_cast<Eigen::Index>(j)];
        EXPECT_GE(value, space->rows()[j].lower - kRounding);
        EXPECT_LE(value, space->rows()[j].upper + kRounding);
      }
      Scene scene;
      scene.body = space->body(y);
      scene.L = 3.0;
      scene.H = 1.0;
      EXPECT_TRUE(validate(scene).empty());
    }
  }
}

TEST(DesignSpace, MovingABoundMovesItsRowAsItSays) {
  // Where a row holds, a stated bound that moves by h moves the row's bound, or
  // its value at a body that stays, by slope · h.
  const std::vector<DesignPlan> all = plans();
  const DesignPlan& plan = all[5];
  const Body at_bounds = [] {
    Body body = kBody;
    body.eta_m = 0.8;
    body.theta_m = -0.5;
    return body;
  }();
  const std::unique_ptr<DesignSpace> space = design_space(plan, at_bounds);
  const Eigen::VectorXd y = space->first();
  constexpr double kStep = 1e-6;
  DesignPlan moved = plan;
  moved.bounds[0]->upper += kStep;
  moved.bounds[1]->lower += kStep;
  const std::unique_ptr<DesignSpace> other = design_space(moved, at_bounds);

  const auto slack = [&](const DesignSpace& of, std::size_t row, bool upper) {
    const double value = of.row_values(y)[static_cast<Eigen::Index>(row)];
    return upper ? value - of.rows()[row].upper : value - of.rows()[row].lower;
  };
  for (const auto& [row, upper] : {std::pair{0, true}, std::pair{1, false}}) {
    const auto index = static_cast<std::size_t>(row);
    const auto [bound, slope] = space->stated(index, upper, y);
    EXPECT_EQ(bound, upper ? 0.8 : -0.5);
    EXPECT_NEAR(
        (slack(*other, index, upper) - slack(*space, index, upper)) / kStep,
        -slope, 10.0 * kStep)
        << space->rows()[index].name;
  }
}

TEST(PartsSpace, ARingWithAWeightHasItsClosedForm) {
  // Ring of mass M and weight m at the distance d [radii] on +x: η = m d/(M +
  // m), k = (M + m d²)/(M + m) − η².
  DesignPlan plan;
  plan.parts = {MassPart::ring(2.0, {}, 0.4), MassPart::point(0.5, {0.1, 0.0})};
  plan.free_parts = {{1, FreePart::Key::At, {}}};
  const std::unique_ptr<DesignSpace> space = design_space(plan, kBody);
  constexpr double kRounding = 1e-15;
  for (const double d : {0.0, 0.25, 0.9, 1.0}) {
    const double eta = 0.5 * d / 2.5;

    const Traits found = space->traits(Eigen::Vector2d(d, 0.0));

    EXPECT_NEAR(found[0], eta, kRounding);
    EXPECT_NEAR(found[1], 0.0, kRounding);
    EXPECT_NEAR(found[2], (2.0 + 0.5 * d * d) / 2.5 - eta * eta,
                4.0 * kRounding);
  }
  EXPECT_TRUE(space->traits(Eigen::Vector2d(1.1, 0.0)).hasNaN())
      << "beyond the cylinder there is no body";
}

}  // namespace
}  // namespace brachisto
