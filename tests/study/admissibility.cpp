// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Scenes that have no answer, and scenes that are none.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <ostream>
#include <stdexcept>
#include <string>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {
namespace {

Scene cylinder(double r, double L, double H, double eta_m = 0.0) {
  Scene scene;
  scene.body = Body::cylinder(r, eta_m, 0.0, 0.5);
  scene.L = L;
  scene.H = H;
  return scene;
}

TEST(NoAdmissiblePath, IfBLiesInsideTheBodyAtItsStart) {
  // (L − r)² + H² ≤ r², among them B on the rim.
  for (const Scene& scene :
       {cylinder(2.0, 1.0, 1.0), cylinder(2.0, 3.0, 1.0),
        cylinder(1.0, 1.0, 1.0), cylinder(5.0, 2.0, 3.0)}) {
    const Solution solution = solve(scene);

    EXPECT_EQ(solution.status, Status::NoAdmissiblePath);
    EXPECT_FALSE(solution.verified());
    EXPECT_FALSE(trajectory_of(solution));
    EXPECT_EQ(solution.effort.iterations, 0);
    EXPECT_NE(solution.message.find("inside"), std::string::npos)
        << solution.message;
  }
}

TEST(NoAdmissiblePath, TellsTheNumbersThatForbidIt) {
  const Solution solution = solve(cylinder(5.0, 6.0, 3.0));

  EXPECT_NE(solution.message.find("r = 5, L = 6, H = 3"), std::string::npos)
      << solution.message;
}

TEST(NoAdmissiblePath, IsNotSaidOnEitherSideOfTheBody) {
  // r = 2, H = 1: the rim at the height of B spans L = 2 ± √3.
  const double half_gap = std::sqrt(3.0);

  const Solution beyond = solve(cylinder(2.0, 2.0 + half_gap + 0.5, 1.0));
  const Solution before = solve(cylinder(2.0, 0.5 * (2.0 - half_gap), 1.0));

  EXPECT_TRUE(beyond.verified()) << beyond.message;
  EXPECT_TRUE(before.verified()) << before.message;
  EXPECT_GT(before.motion()->end_angle(), 0.0);
}

// ---- Off-centred bodies whose uniform cylinder covers B. ----

/// r = 1.2, η = 0.3, θ_m = 30°, k = ½, H = 1: the uniform cylinder has a smooth
/// contact from L = r + √(r² − H²) = 1.863 on, this body from about 1.602 on
/// (docs/theory.md, section 8).
Scene beneath_its_cylinder(double L) {
  Scene scene = cylinder(1.2, L, 1.0);
  scene.body = Body::cylinder(1.2, 0.3, std::numbers::pi / 6.0, 0.5);
  return scene;
}

TEST(NotReached, IsAllThatIsSaidWithoutAProof) {
  // The proof is of the uniform cylinder with slopes of its own.
  Scene limited = cylinder(2.0, 2.0, 1.0);
  limited.limits.floor = 6.0;
  for (const Scene& scene : {cylinder(2.0, 2.0, 1.0, 0.5), limited}) {
    const Solution solution = solve(scene);

    EXPECT_EQ(solution.status, Status::NotReached) << solution.message;
    EXPECT_FALSE(solution.verified());
    EXPECT_NE(
        solution.message.find("does not show that this scene has no path"),
        std::string::npos)
        << solution.message;
  }
}

TEST(NotReached, IsTheStatusOfShootingWhichHasNoOtherStart) {
  SolveOptions options;
  options.method = Shooting{};

  const Solution solution = solve(beneath_its_cylinder(1.8), options);

  EXPECT_EQ(solution.status, Status::NotReached) << solution.message;
  EXPECT_NE(solution.message.find("method: ipopt"), std::string::npos)
      << solution.message;
}

TEST(ALongerScene, IsContinuedFromWhereTheUniformCylinderHasNoPath) {
  SolveOptions options;
  auto program = options.or_default<Collocation>();
  program.certify = Certify::Extremal;
  options.method = program;

  const Solution solution = solve(beneath_its_cylinder(1.8), options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), 1.0171, 0.5e-4);
  ASSERT_TRUE(solution.continued_from_L);
  EXPECT_GT(*solution.continued_from_L, 1.2 + std::sqrt(1.44 - 1.0));
  ASSERT_TRUE(solution.extremal && solution.extremal->solved);
  // Both methods estimate errors below 1e-9.
  EXPECT_LT(std::abs(solution.extremal->difference), 2e-9);
}

TEST(ALongerScene, IsNotAskedWhereTheCycloidIsThere) {
  const Solution solution = solve(beneath_its_cylinder(1.9));

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_FALSE(solution.continued_from_L);
}

TEST(ANeighbour, IsFollowedPastTheEndOfTheCycloids) {
  std::shared_ptr<const Neighbour> neighbour;
  double before = std::numeric_limits<double>::infinity();
  for (const double L : {2.2, 2.0, 1.9, 1.85, 1.8, 1.75, 1.7}) {
    const Solution solution =
        solve(beneath_its_cylinder(L), {}, {.neighbour = neighbour.get()});

    ASSERT_TRUE(solution.verified()) << L << ": " << solution.message;
    EXPECT_FALSE(solution.continued_from_L) << L;
    // T → 0 towards L = 1.602.
    EXPECT_LT(solution.motion()->tau(), before) << L;
    before = solution.motion()->tau();
    neighbour = solution.as_neighbour();
  }
}

TEST(InvalidScenes, AreRefusedWithTheKeyInTheMessage) {
  const auto message = [](const Scene& scene) -> std::string {
    try {
      static_cast<void>(solve(scene));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message(cylinder(-1.0, 3.0, 1.0)).find("scene.body.radius"),
            std::string::npos);
  EXPECT_NE(message(cylinder(0.3, nan, 1.0)).find("scene.finish.L"),
            std::string::npos);
  EXPECT_NE(message(cylinder(0.3, 3.0, 0.0)).find("scene.finish.H"),
            std::string::npos);
  EXPECT_NE(message(cylinder(0.3, 3.0, 1.0, 0.9)).find("scene.body.k"),
            std::string::npos);
  EXPECT_NE(message(Scene{}), "");
}

}  // namespace
}  // namespace brachisto
