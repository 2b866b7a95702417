// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/contour_labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachisto::report {

namespace {

constexpr double kHalfLabel = 18.0;
constexpr double kShortestLine = 4.0 * kHalfLabel;
constexpr double kBetweenLabels = 46.0;
/// Chord over arc under a label, at least.
constexpr double kStraight = 0.97;

double distance(Pixel a, Pixel b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The point at an arc length, by the arc lengths up to each vertex.
Pixel point_at(const std::vector<Pixel>& line, const std::vector<double>& arc,
               double length) {
  const auto after = std::upper_bound(arc.begin() + 1, arc.end() - 1, length);
  const auto i = static_cast<std::size_t>(after - arc.begin());
  const double t = (length - arc[i - 1]) / (arc[i] - arc[i - 1]);
  return {std::lerp(line[i - 1].x, line[i].x, t),
          std::lerp(line[i - 1].y, line[i].y, t)};
}

}  // namespace

bool LabelPlaces::free(Pixel at) const {
  if (at.x < area_.left + kHalfLabel || at.x > area_.right - kHalfLabel ||
      at.y < area_.top + kHalfLabel || at.y > area_.bottom - kHalfLabel) {
    return false;
  }
  return std::none_of(taken_.begin(), taken_.end(), [&](const Taken& taken) {
    return distance(at, taken.at) < taken.distance;
  });
}

std::optional<LabelPlace> LabelPlaces::find(const std::vector<Pixel>& line) {
  std::vector<double> arc{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    arc.push_back(arc.back() + distance(line[i - 1], line[i]));
  }
  if (arc.back() < kShortestLine) return std::nullopt;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
    const double middle = share * arc.back();
    if (middle < kHalfLabel || arc.back() - middle < kHalfLabel) continue;
    const Pixel at = point_at(line, arc, middle);
    const Pixel from = point_at(line, arc, middle - kHalfLabel);
    const Pixel to = point_at(line, arc, middle + kHalfLabel);
    if (distance(from, to) < 2.0 * kStraight * kHalfLabel || !free(at))
      continue;
    avoid(at, kBetweenLabels);
    const double slope =
        std::atan2(to.y - from.y, to.x - from.x) * 180.0 / std::numbers::pi;
    return LabelPlace{at, slope - 180.0 * std::round(slope / 180.0)};
  }
  return std::nullopt;
}

}  // namespace brachisto::report
