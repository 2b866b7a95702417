// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/track.hpp"

#include <cmath>

namespace brachisto::fit {

PlaneCurvePtr held_path(const Motion& motion) {
  constexpr int kPlaces = 1000;
  const std::vector<TrajectoryPoint> sample = motion.fine_sample(kPlaces);
  const TrajectoryPoint& first = sample.front();
  const double S = sample.back().s, slope = first.beta;
  std::vector<double> q;
  std::vector<Point> offsets;
  for (const TrajectoryPoint& at : sample) {
    if (!(at.s > 0.0)) continue;
    // From rest the slope is a smooth function of the speed, and so of √s.
    const double place = &at == &sample.back() ? 1.0 : std::sqrt(at.s / S);
    if (!q.empty() && !(place > q.back())) continue;
    q.push_back(place);
    offsets.push_back(
        {at.centre.x - first.centre.x, at.centre.z - first.centre.z});
  }
  return curve_from_rest(
      first.centre, {S * std::cos(slope), S * std::sin(slope)}, q, offsets);
}

}  // namespace brachisto::fit
