// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A scene whose body is designed, and what tests ask of designs.

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "brachisto/study/solution.hpp"
#include "brachisto/study/solve.hpp"
#include "design/design_search.hpp"

namespace brachisto::testing {

[[nodiscard]] inline Scene base() {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

[[nodiscard]] inline std::map<std::string, double> by_name(
    const NamedNumbers& numbers) {
  std::map<std::string, double> out;
  for (const auto& [name, value] : numbers) out[name] = value;
  return out;
}

/// τ of the closed solution, contacts where they belong.
[[nodiscard]] inline double tau(Scene scene, const Body& body) {
  scene.body = body;
  const Solution found = solve(scene);
  EXPECT_TRUE(found.verified());
  return found.verified() ? found.motion()->tau() : NAN;
}

/// The estimated error of an inner solve, relative, and what of it two solves
/// on different meshes may differ by.
inline constexpr double kInner = 1e-10;
/// Half of the last digit that is known, and the error of a solve.
inline constexpr double kOfTau = 5e-10 + 5.0 * kInner;

}  // namespace brachisto::testing
