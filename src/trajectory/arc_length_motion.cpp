// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/arc_length_motion.hpp"

#include <algorithm>
#include <cmath>

#include "model/contact.hpp"
#include "model/start_angle.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto {

namespace {

/// The nodes of the curve: three wide pieces at the start, the first of which
/// is continued to it, then narrow ones, the last a bit wider.
std::vector<int> nodes_of_curve(int n) {
  constexpr double kMostNarrow = 4000.0;
  const double root = std::sqrt(static_cast<double>(n));
  const int wide = std::max(1, static_cast<int>(std::lround(0.5 * root)));
  const int narrow = std::max(
      {1, static_cast<int>(std::lround(std::sqrt(root) / 1.5)),
       static_cast<int>(std::ceil(static_cast<double>(n) / kMostNarrow))});
  std::vector<int> nodes{wide, 2 * wide, 3 * wide};
  while (nodes.back() + 2 * narrow <= n) {
    nodes.push_back(nodes.back() + narrow);
  }
  if (nodes.back() < n) nodes.push_back(n);
  return nodes;
}

PlaneCurvePtr curve_through(const ArcLength& problem, std::span<const double> x,
                            const Scene& scene, const Units& units) {
  std::vector<double> sigma;
  std::vector<Point> offsets;
  for (const int node : nodes_of_curve(problem.num_intervals())) {
    const auto i = static_cast<std::size_t>(
        problem.layout().state(node, StateComponent::X));
    sigma.push_back(problem.sigma(node));
    offsets.push_back({x[i] * units.length, x[i + 1] * units.length});
  }
  return curve_from_rest(start_of_centre(scene), sigma, offsets);
}

}  // namespace

ArcLengthMotion::ArcLengthMotion(const ArcLength& problem,
                                 std::span<const double> x, double T,
                                 double end_angle, const Scene& scene,
                                 const Units& units)
    : on_curve_(scene, curve_through(problem, x, scene, units)),
      transit_time_(T * units.time),
      length_(x.back() * units.length),
      end_angle_(end_angle) {}

double ArcLengthMotion::start_angle() const {
  return brachisto::start_angle(scene().body);
}

StartLimits ArcLengthMotion::at_start() const {
  return start_limits(scene().body, start_angle(),
                      on_curve_.start_slope_rate());
}

}  // namespace brachisto
