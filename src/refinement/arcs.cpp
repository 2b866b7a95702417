// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "brachisto/math/index.hpp"
#include "model/start_angle.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

using nlp::Held;

/// The angle between the path and the tangent of a limit of the place; of one
/// of the speed too, its rate along the path.
double angle_to(const Scene& scene, const PathInequality& limit,
                const TurningPoint<double>& at) {
  const double h = 1e-6;
  const auto by = [&](double TurningPoint<double>::*state) {
    const auto value = [&](double step) {
      TurningPoint<double> there = at;
      there.*state += step;
      return value_of(limit, ContactForce<double>{}, there);
    };
    return (value(h) - value(-h)) / (2.0 * h);
  };
  using At = TurningPoint<double>;
  return std::asin(std::clamp(by(&At::x) * std::cos(at.beta) +
                                  by(&At::z) * std::sin(at.beta) +
                                  by(&At::w) * speed_gain(scene, at) / at.w,
                              -1.0, 1.0));
}

}  // namespace

double length_of(const std::vector<Arc>& arcs, std::size_t i) {
  return arcs[i].end - (i == 0 ? 0.0 : arcs[i - 1].end);
}

void leave_out(std::vector<Arc>& arcs, std::size_t i) {
  // What was touched between arcs of which one is gone is so no longer.
  if (i > 0) {
    arcs[i - 1].end = arcs[i].end;
    arcs[i - 1].touch.reset();
  }
  arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(i));
  for (std::size_t k = 1; k < arcs.size();) {
    if (arcs[k - 1].held == arcs[k].held && !arcs[k - 1].touch) {
      arcs[k - 1].end = arcs[k].end;
      arcs[k - 1].touch = arcs[k].touch;
      arcs[k - 1].cuts =
          equal_cuts(arcs[k - 1].elements() + arcs[k].elements());
      arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      ++k;
    }
  }
}

bool holds_control(const Arc& arc, const std::vector<PathInequality>& limits) {
  return held_of_control(arc.held, limits) >= 0;
}

std::string in_words(const std::vector<Arc>& arcs,
                     const std::vector<PathInequality>& limits) {
  std::string words;
  for (const Arc& arc : arcs) {
    std::string held;
    for (std::size_t i = 0; i < arc.held.size(); ++i) {
      if (arc.held[i] == Held::No) continue;
      held += fmt::format("{}{}", held.empty() ? "" : " and ",
                          name(limits[i].kind));
    }
    words += held.empty() ? "free" : held;
    if (&arc == &arcs.back()) break;
    words += fmt::format(" to {:.6f}", arc.end);
    if (arc.touch) {
      words += fmt::format(" where {} is touched",
                           name(limits[arc.touch->limit].kind));
    }
    words += ", ";
  }
  return words;
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

HeldLimits held_limits(const std::vector<Arc>& arcs,
                       const std::optional<StartCorner>& corner) {
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
  if (corner) held.at_rest[corner->limit] = corner->at;
  return held;
}

std::vector<double> graded_cuts(int elements) {
  std::vector<double> cuts;
  for (int e = 0; e <= elements; ++e) {
    const double half = 0.5 * std::numbers::pi * e / elements;
    cuts.push_back(std::sin(half) * std::sin(half));
  }
  return cuts;
}

bool kinks_at_rest(const LimitedCurve& curve, const std::vector<Arc>& arcs) {
  constexpr double kKink = 1e-4;
  const Scene& scene = curve.problem().scene();
  return scene.contact == Contact::Optimal &&
         !bound_valleys(curve.problem().limits()) &&
         is_free(arcs.front().held) &&
         curve.at(0.0).state.beta - start_angle(scene) > kKink;
}

std::optional<std::vector<Arc>> held_from_rest(const LimitedCurve& curve,
                                               const std::vector<Arc>& arcs) {
  constexpr double kJustBehind = 1e-6;  // σ, for there is no motion at rest
  constexpr double kWider = 1.3;
  constexpr double kAtBound = 1e-9, kBeyond = 1e-7;
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  if (!problem.ends().start_slope_fixed || problem.pushed() ||
      !is_free(arcs.front().held)) {
    return std::nullopt;
  }
  const TurningPoint<double> rest = curve.state_at(0, 0.0);
  const auto beyond_rest = [&](double sigma) {
    const LimitedPoint here = curve.at(sigma);
    return minimising_slope(scene, moving(here.state), here.p, rest.beta) -
           rest.beta;
  };
  const double leaning = beyond_rest(kJustBehind);
  TurningPoint<double> beyond = rest;
  beyond.beta += leaning;
  const auto excess = [&](const PathInequality& limit, Held where,
                          const TurningPoint<double>& place) {
    const double over = value_of(limit, scene, place) - bound_of(limit, where);
    return where == Held::AtUpper ? over : -over;
  };
  std::vector<Held> held = arcs.front().held;
  for (std::size_t i = 0; i < held.size() && is_free(held); ++i) {
    const PathInequality& limit = problem.limits()[i];
    if (!limit.bounds_force()) continue;
    for (const Held where : {Held::AtLower, Held::AtUpper}) {
      if (std::abs(excess(limit, where, rest)) <= kAtBound &&
          excess(limit, where, beyond) > kBeyond) {
        held[i] = where;
      }
    }
  }
  if (is_free(held)) return std::nullopt;
  for (double end = kJustBehind; end < arcs.front().end; end *= kWider) {
    if (beyond_rest(end) * leaning > 0.0) continue;
    std::vector<Arc> out = arcs;
    out.insert(out.begin(), {.held = held, .end = end, .cuts = equal_cuts(2)});
    return out;
  }
  return std::nullopt;
}

std::optional<std::vector<Arc>> turned_from_rest(const LimitedCurve& curve,
                                                 std::vector<Arc> arcs) {
  constexpr double kWrong = 1e-7;
  constexpr double kShort = 1e-3;  // of the first arc
  const LimitedTime& problem = curve.problem();
  // Otherwise nothing is held at rest.
  if (!problem.free_contacts() || problem.ends().start_slope_fixed ||
      problem.pushed()) {
    return std::nullopt;
  }
  const std::vector<Held>& held = arcs.front().held;
  std::vector<Held> turning(held.size(), Held::No);
  bool held_back = false;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const PathInequality& limit = problem.limits()[i];
    if (limit.kind == PathInequality::Kind::Hump) turning[i] = Held::AtLower;
    if (held[i] == Held::No || !limit.bounds_force()) continue;
    const int row = problem.layout().start_row(static_cast<int>(i));
    const double multiplier = curve.point().lambda[at(row)];
    held_back |= (held[i] == Held::AtLower ? multiplier : -multiplier) > kWrong;
  }
  if (!held_back || is_free(turning)) return std::nullopt;
  arcs.insert(arcs.begin(), {.held = turning,
                             .end = kShort * arcs.front().end,
                             .cuts = equal_cuts(1)});
  return arcs;
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
      return value_of(problem.limits()[before.touch->limit], scene,
                      curve.state_at(element, t));
    };
    const auto across = [&](double by) {
      return value(1.0 + by) - value(1.0 - by);
    };
    return (8.0 * across(kStep) - across(2.0 * kStep)) / (12.0 * kStep);
  }
  const int r = held_of_control(after.held, problem.limits());
  const auto off_singular = [&](const Costates& p) {
    return left.state.beta -
           minimising_slope(scene, moving(left.state), p, left.state.beta);
  };
  for (std::size_t i = 0; i < before.held.size(); ++i) {
    if (problem.limits()[i].bounds_control()) continue;
    if (before.held[i] == after.held[i]) continue;
    if (after.held[i] != Held::No) {
      return angle_to(scene, problem.limits()[i], left.state);
    }
    const LimitedPoint right = curve.at(element + 1, 0.0);
    return r < 0 ? off_singular(right.p) : right.p_beta;
  }
  if (!holds_control(before, problem.limits()) || r < 0) {
    return off_singular(left.p);
  }
  if (opposite(problem, before.held, after.held, left.state)) {
    return left.p_beta;
  }
  const PathInequality& limit = problem.limits()[at(r)];
  return value_of(limit, scene, left.state) -
         (after.held[at(r)] == Held::AtUpper ? limit.upper : limit.lower);
}

}  // namespace brachisto
