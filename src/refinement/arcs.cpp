// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/index.hpp"

namespace brachisto {

namespace {

using nlp::Held;

/// Which limits hold at a place.
struct Sighting {
  double sigma;
  std::vector<Held> held;
  std::optional<Touch> touch = {};  ///< ends the arc here
  double excess = 0.0;              ///< of the limit that is touched
};

bool is_free(const std::vector<Held>& held) {
  return std::all_of(held.begin(), held.end(),
                     [](Held h) { return h == Held::No; });
}

/// Arcs from what holds at places in order; junctions lie half-way between two.
std::vector<Arc> arcs_from(const std::vector<Sighting>& sightings,
                           int elements) {
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
    arcs.push_back({sightings[i].held, end,
                    equal_cuts(std::max(kFewest, static_cast<int>(share))),
                    last || same ? touch : std::nullopt});
    begin = end;
  }
  return arcs;
}

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
    seen.held[i] = multiplier > 0.0 ? Held::AtUpper : Held::AtLower;
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

/// The limit that holds the control; −1 if none does.
int held_of_control(const std::vector<Held>& held,
                    const std::vector<PathInequality>& limits) {
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i] != Held::No && limits[i].bounds_control()) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// Whether a limit at a bound keeps the control from growing.
bool holds_from_above(const LimitedTime& problem, int limit, Held where,
                      TurningPoint<double> place) {
  const auto value = [&](double q) {
    place.q = q;
    return value_of(problem.limits()[at(limit)], problem.scene().body,
                    problem.scene().gravity, place);
  };
  const bool grows = value(1.0) > value(0.0);
  return grows == (where == Held::AtUpper);
}

/// Whether what holds the control at two places does so from opposite sides.
bool opposite(const LimitedTime& problem, const std::vector<Held>& one,
              const std::vector<Held>& other,
              const TurningPoint<double>& place) {
  const int l = held_of_control(one, problem.limits());
  const int r = held_of_control(other, problem.limits());
  return l >= 0 && r >= 0 &&
         holds_from_above(problem, l, one[at(l)], place) !=
             holds_from_above(problem, r, other[at(r)], place);
}

/// Whether the limit that holds the control of an arc keeps it from what
/// another one, which is exceeded there, asks for.
bool gives_no_way(const LimitedTime& problem, const Arc& arc,
                  std::size_t exceeded, Held where,
                  const TurningPoint<double>& place) {
  const int held = held_of_control(arc.held, problem.limits());
  if (held < 0) return false;
  return !problem.limits()[exceeded].bounds_control() ||
         holds_from_above(problem, held, arc.held[at(held)], place) !=
             holds_from_above(problem, static_cast<int>(exceeded), where,
                              place);
}

/// Of a run of places at which a limit is exceeded it is touched where it is so
/// most.
void touch_once(std::vector<Sighting>& seen) {
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
    for (std::size_t i = first; i < end; ++i) {
      if (i != worst) seen[i].touch.reset();
    }
    seen[worst].touch->multiplier = multiplier;
    first = end;
  }
}

/// The angle between the path and the tangent of a limit of the place.
double angle_to(const PathInequality& limit, const TurningPoint<double>& at) {
  const double h = 1e-6;
  const auto value = [&](double dx, double dz) {
    TurningPoint<double> there = at;
    there.x += dx;
    there.z += dz;
    return value_of(limit, {}, 1.0, there);
  };
  const double by_x = (value(h, 0.0) - value(-h, 0.0)) / (2.0 * h);
  const double by_z = (value(0.0, h) - value(0.0, -h)) / (2.0 * h);
  return std::asin(std::clamp(
      by_x * std::cos(at.beta) + by_z * std::sin(at.beta), -1.0, 1.0));
}

/// An arc that is missing is longer than the stretch where its limit is
/// exceeded without it: β has to be back on the free arc behind it, so that the
/// excess of q over the one that the limit allows has no integral. Of a
/// parabola the part above zero is 1/√3 of that.
void widen_new(const std::vector<std::vector<Held>>& before,
               std::vector<Sighting>& seen) {
  const std::size_t n = seen.size();
  std::vector<Sighting> wider = seen;
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first + 1;
    while (end < n && seen[end].held == seen[first].held) ++end;
    if (is_free(before[first]) && !is_free(seen[first].held)) {
      const auto more = static_cast<std::size_t>(
          std::ceil(0.37 * static_cast<double>(end - first)));
      for (std::size_t k = 1; k <= more; ++k) {
        if (first >= k && is_free(seen[first - k].held)) {
          wider[first - k].held = seen[first].held;
        }
        if (end + k <= n && is_free(seen[end + k - 1].held)) {
          wider[end + k - 1].held = seen[first].held;
        }
      }
    }
    first = end;
  }
  seen = std::move(wider);
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

/// At B the place is given: a limit of it is not touched there.
void leave_end(const LimitedTime& problem, std::vector<Sighting>& seen) {
  std::optional<Touch>& touch = seen.back().touch;
  if (touch && !problem.free_contacts() &&
      !problem.limits()[touch->limit].bounds_control()) {
    touch.reset();
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
  touch_once(seen);
  close_gaps(curve, seen);
  for (std::size_t i = 1; i + 1 < seen.size(); ++i) {
    // Between two limits there is a junction, and no more.
    if (seen[i].held != seen[i + 1].held) seen[i].touch.reset();
    if (seen[i - 1].held == seen[i + 1].held) seen[i].held = seen[i - 1].held;
  }
  leave_end(problem, seen);
  return arcs_from(seen, mesh.num_elements());
}

std::optional<std::vector<Arc>> corrected(const LimitedCurve& curve,
                                          const std::vector<Arc>& arcs) {
  constexpr double kExceeded = 1e-7;
  constexpr double kWrongSign = 1e-3;  // of the arc's largest
  constexpr double kShort = 1e-4;
  constexpr int kPlaces = 16;
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  const Mesh& mesh = problem.mesh();
  std::vector<Sighting> seen;
  std::vector<std::vector<Held>> before;
  std::vector<double> largest;  // on each arc
  for (int e = 0; const Arc& arc : arcs) {
    largest.push_back(curve.largest_multiplier(e, e + arc.elements()));
    e += arc.elements();
  }
  const auto pulls_wrong = [&](const LimitedPoint& place, std::size_t on,
                               std::size_t limit) {
    const Held held = arcs[on].held[limit];
    const double multiplier = place.multipliers[limit];
    return held != Held::No &&
           (held == Held::AtLower ? multiplier : -multiplier) >
               kWrongSign * largest[on];
  };
  bool changed = false;
  std::size_t arc = 0;
  double begin_of_arc = 0.0;
  bool given_up = false;
  for (int e = 0, in_arc = 0; e < mesh.num_elements(); ++e, ++in_arc) {
    if (in_arc == arcs[arc].elements()) {
      begin_of_arc = arcs[arc].end;
      ++arc;
      in_arc = 0;
    }
    if (in_arc == 0) {
      // Junctions of a short arc would stay where its neighbours begin.
      given_up = false;
      const bool is_short = arcs[arc].end - begin_of_arc < kShort;
      for (int k = e; is_short && k < e + arcs[arc].elements(); ++k) {
        for (const double t : curve.places(k, kPlaces)) {
          const LimitedPoint place = curve.at(k, t);
          for (std::size_t i = 0; i < arcs[arc].held.size(); ++i) {
            given_up = given_up || pulls_wrong(place, arc, i);
          }
        }
      }
    }
    // What is touched has its multiplier at a point, and the polynomial of the
    // other one tells nothing there.
    const std::optional<Touch>& touched = arcs[arc].touch;
    const bool before_touch = touched && in_arc + 1 == arcs[arc].elements();
    for (const double t : curve.places(e, kPlaces)) {
      if (t == 0.0 || t == 1.0) continue;  // junctions belong to two arcs
      const LimitedPoint place = curve.at(e, t);
      std::vector<Held> held = arcs[arc].held;
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i] == Held::No) continue;
        if (given_up || (!before_touch && pulls_wrong(place, arc, i))) {
          held[i] = Held::No;
          changed = true;
        }
      }
      // Of the limits that are exceeded the one that is so most.
      double worst = kExceeded;
      std::size_t which = held.size();
      Held where = Held::No;
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (arcs[arc].held[i] != Held::No) continue;
        const PathInequality& limit = problem.limits()[i];
        const double value =
            value_of(limit, scene.body, scene.gravity, place.state);
        const double below = limit.lower - value;
        const double above = value - limit.upper;
        if (std::max(below, above) <= worst) continue;
        worst = std::max(below, above);
        which = i;
        where = below > above ? Held::AtLower : Held::AtUpper;
      }
      std::optional<Touch> touch;
      if (which < held.size() &&
          gives_no_way(problem, arcs[arc], which, where, place.state)) {
        touch = {which, where};
        changed = true;
      } else if (which < held.size()) {
        changed = true;
        for (std::size_t i = 0; i < held.size(); ++i) {
          if (problem.limits()[i].bounds_control() ==
              problem.limits()[which].bounds_control()) {
            held[i] = Held::No;
          }
        }
        held[which] = where;
      }
      seen.push_back({mesh.sigma(e, t), held, touch, touch ? worst : 0.0});
      before.push_back(arcs[arc].held);
    }
    if (!before_touch) continue;
    const int last = (e + 1) * mesh.degree - 1;
    const double multiplier = curve.point().lambda[at(
        problem.layout().limit(last, static_cast<int>(touched->limit)))];
    if ((multiplier > 0.0) == (touched->at == Held::AtUpper)) {
      constexpr double kKept = std::numeric_limits<double>::infinity();
      seen.push_back({mesh.boundaries[at(e + 1)], seen.back().held,
                      Touch{touched->limit, touched->at, multiplier}, kKept});
      before.push_back(before.back());
    } else {
      changed = true;
    }
  }
  if (!changed) return std::nullopt;
  touch_once(seen);
  widen_new(before, seen);
  leave_end(problem, seen);
  return arcs_from(seen, mesh.num_elements());
}

bool holds_control(const Arc& arc, const std::vector<PathInequality>& limits) {
  return held_of_control(arc.held, limits) >= 0;
}

std::vector<int> touched_rows(const std::vector<Arc>& arcs,
                              const LimitedTime& problem) {
  std::vector<int> rows;
  int element = 0;
  for (const Arc& arc : arcs) {
    element += arc.elements();
    if (!arc.touch) continue;
    rows.push_back(problem.layout().limit(element * problem.mesh().degree - 1,
                                          static_cast<int>(arc.touch->limit)));
  }
  return rows;
}

std::vector<double> equal_cuts(int elements) {
  std::vector<double> cuts;
  for (int e = 0; e <= elements; ++e) {
    cuts.push_back(static_cast<double>(e) / elements);
  }
  return cuts;
}

Mesh mesh_of(const std::vector<Arc>& arcs, int degree) {
  Mesh mesh{degree, {0.0}};
  for (const Arc& arc : arcs) {
    const double begin = mesh.boundaries.back();
    for (int e = 1; e < arc.elements(); ++e) {
      mesh.boundaries.push_back(begin + (arc.end - begin) * arc.cuts[at(e)]);
    }
    mesh.boundaries.push_back(arc.end);
  }
  return mesh;
}

HeldLimits held_limits(const std::vector<Arc>& arcs) {
  HeldLimits held;
  for (const Arc& arc : arcs) {
    held.in_element.insert(held.in_element.end(), at(arc.elements()), arc.held);
    held.at_end.resize(held.in_element.size());
    if (arc.touch) {
      held.at_end.back().resize(arc.held.size(), Held::No);
      held.at_end.back()[arc.touch->limit] = arc.touch->at;
    }
  }
  held.at_rest = arcs.front().held;
  return held;
}

double junction_residual(const LimitedCurve& curve,
                         const std::vector<Arc>& arcs, std::size_t arc) {
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  const Arc& before = arcs[arc];
  const Arc& after = arcs[arc + 1];
  int element = -1;
  for (std::size_t i = 0; i <= arc; ++i) element += arcs[i].elements();
  const LimitedPoint left = curve.at(element, 1.0);
  if (before.touch) {
    // Differences of order four: misplaced by δ, T errs by δ², and those of
    // order two leave 1e-5.
    constexpr double kStep = 1e-2;
    const auto value = [&](double t) {
      return value_of(problem.limits()[before.touch->limit], scene.body,
                      scene.gravity, curve.at(element, t).state);
    };
    const auto across = [&](double by) {
      return value(1.0 + by) - value(1.0 - by);
    };
    return (8.0 * across(kStep) - across(2.0 * kStep)) / (12.0 * kStep);
  }
  const auto off_singular = [&](const Costates& p) {
    return left.state.beta - minimising_slope(scene.body, scene.gravity,
                                              {left.state.theta, left.state.w},
                                              p, left.state.beta);
  };
  for (std::size_t i = 0; i < before.held.size(); ++i) {
    if (problem.limits()[i].bounds_control()) continue;
    if (before.held[i] == after.held[i]) continue;
    if (after.held[i] != Held::No) {
      return angle_to(problem.limits()[i], left.state);
    }
    const LimitedPoint right = curve.at(element + 1, 0.0);
    return holds_control(after, problem.limits()) ? right.p_beta
                                                  : off_singular(right.p);
  }
  const int r = held_of_control(after.held, problem.limits());
  if (!holds_control(before, problem.limits()) || r < 0) {
    return off_singular(left.p);
  }
  if (opposite(problem, before.held, after.held, left.state)) {
    return left.p_beta;
  }
  const PathInequality& limit = problem.limits()[at(r)];
  const double bound =
      after.held[at(r)] == Held::AtUpper ? limit.upper : limit.lower;
  return value_of(limit, scene.body, scene.gravity, left.state) - bound;
}

}  // namespace brachisto
