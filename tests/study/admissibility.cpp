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

namespace brachisto {
namespace {

Scene cylinder(double r, double L, double H, double eta_m = 0.0) {
  Scene scene;
  scene.body = Body::cylinder(r, eta_m, 0.0, 0.5);
  scene.L = L;
  scene.H = H;
  return scene;
}

TEST(NoAdmissiblePath, IfTheCentreWouldEndAboveItsStart) {
  // r ≥ H and L ≤ r + √(r² − H²), among them both limits.
  for (const Scene& scene : {cylinder(2.0, 1.0, 1.0), cylinder(2.0, 3.0, 1.0),
                             cylinder(1.0, 0.5, 1.0), cylinder(1.0, 1.0, 1.0),
                             cylinder(2.0, 2.0, 1.0, 0.5)}) {
    const Solution solution = solve(scene);

    EXPECT_EQ(solution.status, Status::NoAdmissiblePath);
    EXPECT_FALSE(solution.verified());
    EXPECT_FALSE(solution.trajectory);
    EXPECT_EQ(solution.effort.iterations, 0);
    EXPECT_NE(solution.message.find("above its start"), std::string::npos)
        << solution.message;
  }
}

TEST(NoAdmissiblePath, TellsTheLengthThatWouldDo) {
  const Solution solution = solve(cylinder(5.0, 6.0, 3.0));

  // r + √(r² − H²) = 5 + 4
  EXPECT_NE(solution.message.find("= 9, but L = 6"), std::string::npos)
      << solution.message;
}

TEST(NoAdmissiblePath, EndsWhereTheClosedFormHasARoot) {
  const double r = 2.0;
  const double limit = r + std::sqrt(r * r - 1.0);

  const Solution beyond = solve(cylinder(r, limit + 0.5, 1.0));

  EXPECT_TRUE(beyond.verified()) << beyond.message;
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
