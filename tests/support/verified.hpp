// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whole solves, and those that have to be verified.

#pragma once

#include <gtest/gtest.h>

#include "brachisto/study/solve.hpp"

namespace brachisto::testing {

/// By the indirect method.
[[nodiscard]] inline SolveOptions by_shooting() {
  SolveOptions options;
  options.method = Shooting{};
  return options;
}

/// Solves `scene`; a check that fails is a failure of the test that names it.
[[nodiscard]] inline Solution verified(const Scene& scene,
                                       const SolveOptions& options = {}) {
  Solution solution = solve(scene, options);
  EXPECT_TRUE(solution.verified())
      << solution.message
      << ::testing::PrintToString(solution.not_verified_because());
  return solution;
}

}  // namespace brachisto::testing
