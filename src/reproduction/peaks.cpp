// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/peaks.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <span>

namespace brachisto::reproduction {

namespace {

using Stretch = std::span<const TrajectoryPoint>;

double kappa_b(const TrajectoryPoint& at) {
  return at.motion.kappa_b;
}

Bend bend_at(const TrajectoryPoint& at) {
  return {at.motion.contact.x, at.theta};
}

}  // namespace

double PeaksAndValleys::turn() const {
  double sum = 0.0;
  for (const Peak& peak : peaks) sum += peak.turn;
  return sum;
}

PeaksAndValleys peaks_and_valleys(const Motion& motion) {
  constexpr int kSamples = 2000;
  constexpr double kRounding = 1e-6 * std::numbers::pi / 180.0;
  const std::vector<TrajectoryPoint> path = motion.fine_sample(kSamples);
  PeaksAndValleys found;
  std::size_t end_of_last = 0;
  for (std::size_t i = 0; i + 1 < path.size();) {
    std::size_t j = i;
    while (j + 1 < path.size() && path[j + 1].beta > path[j].beta) ++j;
    const double turn = path[j].beta - path[i].beta;
    if (turn > kRounding) {
      const Stretch stretch(path.begin() + static_cast<std::ptrdiff_t>(i),
                            j - i + 1);
      found.peaks.push_back(
          {turn, bend_at(*std::ranges::max_element(stretch, {}, kappa_b))});
      if (found.peaks.size() > 1) {
        const Stretch between(
            path.begin() + static_cast<std::ptrdiff_t>(end_of_last),
            i - end_of_last + 1);
        found.valleys.push_back(
            bend_at(*std::ranges::min_element(between, {}, kappa_b)));
      }
      end_of_last = j;
    }
    i = std::max(j, i + 1);
  }
  return found;
}

}  // namespace brachisto::reproduction
