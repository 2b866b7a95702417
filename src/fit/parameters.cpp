// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace brachisto::fit {

const Parameter* find_parameter(std::string_view key) {
  const auto* found = std::ranges::find(kParameters, key, &Parameter::key);
  return found == kParameters.end() ? nullptr : found;
}

std::string objection(const Parameter& parameter, const Scene& scene) {
  if (parameter.number == MotionNumber::Inertia && scene.body.ball) {
    return fmt::format(
        "{} of a ball is not fitted: its inertia is that of what it is made of",
        parameter.key);
  }
  if (parameter.of_bead == !scene.body.rolls()) return "";
  return parameter.of_bead
             ? fmt::format("{} is of a bead, and the body of the scene rolls",
                           parameter.key)
             : fmt::format(
                   "{} is of what rolls, and the body of the scene is "
                   "a bead",
                   parameter.key);
}

}  // namespace brachisto::fit
