// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random numbers that are the same everywhere, and random bodies.

#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "brachisto/model/body.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::testing {

/// Uniform random numbers, a function of the seed alone: unlike the
/// distributions of the standard library, the same with every compiler.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double low, double high) {
    constexpr double kRange = 4294967296.0;  // 2³²
    const double unit = (static_cast<double>(engine_()) + 0.5) / kRange;
    return low + (high - low) * unit;
  }
  [[nodiscard]] std::vector<double> vector(int size, double low, double high) {
    std::vector<double> values(static_cast<std::size_t>(size));
    std::ranges::generate(values, [&] { return uniform(low, high); });
    return values;
  }

 private:
  std::mt19937 engine_;
};

/// A valid cylinder with η_m below the given bound.
[[nodiscard]] inline Body random_cylinder(Random& random,
                                          double largest_eta = 0.95) {
  const double radius = random.uniform(0.1, 2.0);
  const double eta = random.uniform(0.0, largest_eta);
  const double theta_m = random.uniform(-std::numbers::pi, std::numbers::pi);
  return Body::cylinder(radius, eta, theta_m,
                        random.uniform(0.0, (1.0 - eta) * (1.0 + eta)));
}

/// A point at which `problem` is defined: states of a smooth motion, shaken;
/// slope angles of all directions.
///
/// \param start_speed  factor on w in the first element: 1, or tiny for a
///                     point next to the start
[[nodiscard]] inline std::vector<double> random_point(
    const RollingTime& problem, Random& random, double start_speed = 1.0) {
  using enum StateComponent;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const VariableLayout& layout = problem.layout();
  const int degree = problem.mesh().degree;
  std::vector<double> x = random.vector(problem.num_variables(), -1.0, 1.0);
  // Interpolation amplifies what shakes the nodes by less than 3 for degrees
  // up to 8, so w stays positive.
  for (int n = 0; n < layout.num_nodes(); ++n) {
    const double sigma = static_cast<double>(n) / layout.num_points();
    x[at(layout.state(n, W))] = 1.0 + sigma + random.uniform(-0.2, 0.2);
    if (n <= degree) x[at(layout.state(n, W))] *= start_speed;
    if (layout.has_theta()) {
      x[at(layout.state(n, Theta))] = 5.0 * sigma + random.uniform(-0.2, 0.2);
    }
  }
  for (int c = 0; c < layout.num_points(); ++c) {
    x[at(layout.beta(c))] =
        random.uniform(-0.5 * std::numbers::pi, std::numbers::pi);
  }
  x[at(layout.rolling_time())] = random.uniform(1.0, 3.0);
  return x;
}

}  // namespace brachisto::testing
