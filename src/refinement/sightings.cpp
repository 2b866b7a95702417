// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/sightings.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto {

std::vector<Arc> arcs_from(const std::vector<Sighting>& sightings, int elements,
                           const std::vector<PathInequality>& limits) {
  constexpr int kFewest = 2;
  std::vector<Arc> arcs;
  double begin = 0.0;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const bool last = i + 1 == sightings.size();
    const std::optional<Touch>& touch = sightings[i].touch;
    const bool same = !last && sightings[i + 1].held == sightings[i].held;
    if (same && !touch) continue;
    const double end =
        last   ? 1.0
        : same ? sightings[i].sigma
               : 0.5 * (sightings[i].sigma + sightings[i + 1].sigma);
    const auto share = std::lround((end - begin) * elements);
    arcs.push_back(
        {sightings[i].held, end,
         equal_cuts(std::max(kFewest, static_cast<int>(share))),
         last || same || touches_before_it_holds(sightings, i, limits)
             ? touch
             : std::nullopt});
    begin = end;
  }
  return arcs;
}

bool touches_before_it_holds(const std::vector<Sighting>& seen,
                             std::size_t place,
                             const std::vector<PathInequality>& limits) {
  const std::optional<Touch>& touch = seen[place].touch;
  return touch && limits[touch->limit].bounds_control() &&
         place + 1 < seen.size() &&
         seen[place + 1].held[touch->limit] == touch->at;
}

void touch_once(std::vector<Sighting>& seen,
                const std::vector<PathInequality>& limits) {
  for (std::size_t first = 0; first < seen.size();) {
    if (!seen[first].touch) {
      ++first;
      continue;
    }
    std::size_t worst = first, end = first;
    double multiplier = 0.0;
    for (; end < seen.size() && seen[end].touch &&
           seen[end].touch->limit == seen[first].touch->limit;
         ++end) {
      if (seen[end].excess > seen[worst].excess) worst = end;
      multiplier += seen[end].touch->multiplier;
    }
    if (touches_before_it_holds(seen, end - 1, limits) &&
        std::isfinite(seen[worst].excess)) {
      worst = end - 1;
    }
    for (std::size_t i = first; i < end; ++i) {
      if (i != worst) seen[i].touch.reset();
    }
    seen[worst].touch->multiplier = multiplier;
    first = end;
  }
}

void leave_end(const LimitedTime& problem, std::vector<Sighting>& seen) {
  std::optional<Touch>& touch = seen.back().touch;
  if (touch && !problem.free_contacts() &&
      !problem.limits()[touch->limit].bounds_control()) {
    touch.reset();
  }
}

}  // namespace brachisto
