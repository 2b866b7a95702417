// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The arcs that an interior-point method's solution tells of.

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/index.hpp"
#include "refinement/sightings.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

using nlp::Held;

/// What holds at a collocation point, as inequalities have it. Of two limits of
/// the control one is touched: the one that did not hold at the point before.
Sighting sighting_at(const LimitedCurve& curve, int point,
                     const std::vector<Held>& last) {
  const LimitedTime& problem = curve.problem();
  const Mesh& mesh = problem.mesh();
  const int e = point / mesh.degree;
  Sighting seen{
      mesh.sigma(e, problem.scheme().rule.points[at(point % mesh.degree)]),
      std::vector<Held>(problem.limits().size(), Held::No)};
  std::size_t of_control = seen.held.size();  // none
  for (std::size_t i = 0; i < seen.held.size(); ++i) {
    const auto limit = static_cast<int>(i);
    if (!curve.active(point, limit)) continue;
    const double multiplier =
        curve.point().lambda[at(problem.layout().limit(point, limit))];
    seen.held[i] = curve.held(point, limit);
    if (!problem.limits()[i].bounds_control()) continue;
    if (of_control < seen.held.size()) {
      const bool other = !last.empty() && last[i] != Held::No;
      const std::size_t touched = other ? of_control : i;
      const double impulse = curve.point().lambda[at(
          problem.layout().limit(point, static_cast<int>(touched)))];
      seen.touch = {touched, seen.held[touched], impulse};
      seen.excess = std::abs(multiplier);
      seen.held[touched] = Held::No;
      if (!other) continue;
    }
    of_control = i;
  }
  return seen;
}

/// A limit of the place holds along a run of points if at one of them none of
/// the control does; it is touched if one of the control always does.
void part_from_control(const LimitedCurve& curve, std::vector<Sighting>& seen) {
  const LimitedTime& problem = curve.problem();
  const std::vector<PathInequality>& limits = problem.limits();
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (limits[i].bounds_control()) continue;
    for (std::size_t first = 0; first < seen.size(); ++first) {
      if (seen[first].held[i] == Held::No) continue;
      std::size_t end = first;
      bool alone = false;
      const auto of_control = [&](std::size_t k) {
        return limits[k].bounds_control();
      };
      for (; end < seen.size() && seen[end].held[i] != Held::No; ++end) {
        bool any = false;
        for (std::size_t k = 0; k < limits.size(); ++k) {
          any = any || (of_control(k) && seen[end].held[k] != Held::No);
        }
        alone = alone || !any;
      }
      for (std::size_t n = first; n < end; ++n) {
        if (!alone) {
          seen[n].touch = {i, seen[n].held[i],
                           curve.point().lambda[at(problem.layout().limit(
                               static_cast<int>(n), static_cast<int>(i)))]};
          seen[n].held[i] = Held::No;
          seen[n].excess = n == (first + end) / 2 ? 1.0 : 0.0;
          continue;
        }
        for (std::size_t k = 0; k < limits.size(); ++k) {
          if (of_control(k)) seen[n].held[k] = Held::No;
        }
      }
      first = end;
    }
  }
}

/// Between limits that bound the control from opposite sides it jumps, which a
/// polynomial does not: few places without either are no free arc. What holds
/// goes on half-way through them.
void close_gaps(const LimitedCurve& curve, std::vector<Sighting>& seen) {
  const LimitedTime& problem = curve.problem();
  const std::size_t most = at(problem.mesh().degree) / 2;
  for (std::size_t first = 1; first < seen.size(); ++first) {
    std::size_t end = first;
    while (end < seen.size() && is_free(seen[end].held)) ++end;
    const bool few = end > first && end - first <= most && end < seen.size();
    if (few && opposite(problem, seen[first - 1].held, seen[end].held,
                        curve.at(seen[first].sigma).state)) {
      for (std::size_t i = first; i < end; ++i) {
        seen[i].held = seen[2 * i < first + end - 1 ? first - 1 : end].held;
      }
    }
    first = end;
  }
}

}  // namespace

std::vector<Arc> arcs_of(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const Mesh& mesh = problem.mesh();
  std::vector<Sighting> seen;
  for (int c = 0; c < problem.layout().num_points(); ++c) {
    seen.push_back(sighting_at(
        curve, c, seen.empty() ? std::vector<Held>() : seen.back().held));
  }
  part_from_control(curve, seen);
  touch_once(seen, problem.limits());
  close_gaps(curve, seen);
  for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
    // Between two limits there is a junction; only where they bound the control
    // from opposite sides, and leave it no choice there, is it more.
    if (seen[i].held != seen[i + 1].held &&
        !(touches_before_it_holds(seen, i, problem.limits()) &&
          opposite(problem, seen[i].held, seen[i + 1].held,
                   curve.at(seen[i].sigma).state))) {
      seen[i].touch.reset();
    }
    if (i > 0 && seen[i - 1].held == seen[i + 1].held) {
      seen[i].held = seen[i - 1].held;
    }
  }
  leave_end(problem, seen);
  return arcs_from(seen, mesh.num_elements(), problem.limits());
}

}  // namespace brachisto
