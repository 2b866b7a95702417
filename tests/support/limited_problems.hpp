// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// limited_time problems with every kind of limit, and points to evaluate them
/// at.

#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "support/limited_scenes.hpp"
#include "support/random_points.hpp"
#include "transcription/limited_time.hpp"

namespace brachisto::testing {

/// One limit of each kind, as far as the body has it: two of friction, a normal
/// force with both bounds, hump, valley, floor, disc and half-plane.
[[nodiscard]] inline std::vector<PathInequality> limits_of_all_kinds(
    const Body& body) {
  PathLimits limits = bends(2.0, 3.0);
  if (body.rolls()) limits.friction = 0.4;
  limits.normal_min = 0.1;
  limits.normal_max = 5.0;
  limits.floor = 1.7;
  limits.discs = {{{4.0, 4.5}, 0.5}};
  limits.half_planes = {{{5.0, 1.0}, 2.5}};
  return inequalities(body, limits);
}

/// Every limit held on an element of its own, with `between` free ones before
/// each; the first, if it is one of forces, at rest too.
[[nodiscard]] inline HeldLimits held_in_turn(
    const Mesh& mesh, const std::vector<PathInequality>& limits,
    int between = 0) {
  const nlp::Held free = nlp::Held::No;
  HeldLimits held;
  held.at_rest.assign(limits.size(), free);
  if (limits.front().bounds_force()) {
    held.at_rest.front() = nlp::Held::AtLower;
  }
  for (int e = 0; e < mesh.num_elements(); ++e) {
    std::vector<nlp::Held> here(limits.size(), free);
    const auto i = static_cast<std::size_t>(e / (between + 1));
    if (e % (between + 1) == between && i < limits.size()) {
      here[i] = std::isfinite(limits[i].upper) ? nlp::Held::AtUpper
                                               : nlp::Held::AtLower;
    }
    held.in_element.push_back(std::move(here));
  }
  return held;
}

/// States of a smooth motion, shaken; slopes of all directions, controls of
/// either sign. Speeds stay above 0.8, places below 2, so that nothing is
/// singular nearby, the disc included.
[[nodiscard]] inline std::vector<double> random_point(
    const LimitedTime& problem, Random& random) {
  using enum StateComponent;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const VariableLayout& layout = problem.layout();
  std::vector<double> x = random.vector(problem.num_variables(), -1.0, 1.0);
  for (int n = 0; n < layout.num_nodes(); ++n) {
    const double sigma = static_cast<double>(n) / layout.num_points();
    x[at(layout.state(n, W))] = 1.0 + sigma + random.uniform(-0.2, 0.2);
    x[at(layout.state(n, Beta))] = random.uniform(-0.5 * kPi, kPi);
    if (layout.has_theta()) {
      x[at(layout.state(n, Theta))] = 5.0 * sigma + random.uniform(-0.2, 0.2);
    }
  }
  x[at(layout.rolling_time())] = random.uniform(1.0, 3.0);
  return x;
}

}  // namespace brachisto::testing
