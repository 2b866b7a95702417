// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The fitted paths of reference scenes.

#pragma once

#include <stdexcept>
#include <string>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/limited_scenes.hpp"

namespace brachisto::testing {

/// In natural units.
/// \throws std::runtime_error if it is not verified
[[nodiscard]] inline LimitedCurve solved_curve(const Scene& scene) {
  const Solution solution = solve(scene);
  const auto* answer = answer_as<LimitedPathAnswer>(solution.answer);
  if (!solution.verified() || answer == nullptr) {
    throw std::runtime_error(solution.message);
  }
  return answer->motion.curve();
}

}  // namespace brachisto::testing
