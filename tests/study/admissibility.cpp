// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Scenes that have no answer, and scenes that are none.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
  for (const Scene& scene : {cylinder(2.0, 1.0, 1.0), cylinder(2.0, 3.0, 1.0),
                             cylinder(1.0, 1.0, 1.0), cylinder(5.0, 2.0, 3.0),
                             cylinder(2.0, 2.0, 1.0, 0.5)}) {
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
