// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/path_error.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto::comparison {

namespace {

constexpr int kParts = 64;

/// Where the arc length is `wanted`: halving tells doubles apart.
Point place_at(const Motion& motion, double wanted) {
  double low = 0.0, high = 1.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    const TrajectoryPoint at = motion.at(middle);
    if (middle <= low || middle >= high) return at.centre;
    (at.s < wanted ? low : high) = middle;
  }
}

}  // namespace

std::vector<Point> places_along(const Solution& solution) {
  std::vector<Point> places;
  if (solution.status != Status::Solved) return places;
  const DiscreteAnswer* discrete = solution.discrete();
  for (int i = 0; i <= kParts; ++i) {
    const double share = static_cast<double>(i) / kParts;
    if (discrete != nullptr) {
      const std::vector<Point>& nodes = discrete->centre;
      const double at = share * static_cast<double>(nodes.size() - 1);
      const std::size_t below =
          std::min(static_cast<std::size_t>(at), nodes.size() - 2);
      const double part = at - static_cast<double>(below);
      places.push_back({std::lerp(nodes[below].x, nodes[below + 1].x, part),
                        std::lerp(nodes[below].z, nodes[below + 1].z, part)});
    } else if (const Motion* motion = solution.motion()) {
      places.push_back(place_at(*motion, share * motion->centre_path_length()));
    }
  }
  return places;
}

std::optional<double> path_error(const std::vector<Point>& places,
                                 const std::vector<Point>& reference,
                                 double length) {
  if (places.empty() || places.size() != reference.size()) return std::nullopt;
  double largest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    largest = std::max(largest, std::hypot(places[i].x - reference[i].x,
                                           places[i].z - reference[i].z));
  }
  return largest / length;
}

}  // namespace brachisto::comparison
