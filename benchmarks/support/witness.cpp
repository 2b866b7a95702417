// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/witness.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto::benchmarks {

ExtremalSolution ask_witness(const Scene& scene, double max_seconds) {
  ExtremalOptions options;
  options.follow_folds = true;
  options.stop = StopCondition(max_seconds, nullptr);
  return solve_extremal(scene, options);
}

Difference compare(const Trajectory& found, const ExtremalSolution& witness) {
  // A few for every element and every arc; the paths are smooth.
  constexpr int kPlaces = 1000;
  Difference difference;
  difference.tau = std::abs(found.tau() - witness.tau) / witness.tau;
  difference.angle = std::abs(found.end_angle() - witness.phi);
  const double length = std::max(found.scene().L, found.scene().H);
  const auto apart = [&](double sigma) {
    const Point a = found.at(sigma).centre;
    const ExtremalState b = witness.path.at(sigma);
    return std::hypot(a.x - b.x, a.z - b.z) / length;
  };
  for (int i = 0; i <= kPlaces; ++i) {
    const double sigma = static_cast<double>(i) / kPlaces;
    difference.path = std::max(difference.path, apart(sigma));
  }
  for (const double sigma : found.curve().mesh().boundaries) {
    difference.nodes = std::max(difference.nodes, apart(sigma));
  }
  return difference;
}

}  // namespace brachisto::benchmarks
