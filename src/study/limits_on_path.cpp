// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/limits_on_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "refinement/limited_rates.hpp"
#include "refinement/without_arcs.hpp"
#include "trajectory/stated_limits.hpp"

namespace brachisto {

namespace {

/// Whether a stated limit is one of those that are held.
bool is_among(const std::vector<nlp::Held>& held,
              const std::vector<PathInequality>& limits,
              const StatedLimit& stated) {
  int index = 0;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    index = i > 0 && limits[i].kind == limits[i - 1].kind ? index + 1 : 0;
    if (held[i] != nlp::Held::No &&
        stated.is(limits[i].kind, index, held[i] == nlp::Held::AtLower)) {
      return true;
    }
  }
  return false;
}

/// x of the track, which starts at 0 but for rounding.
double place_of(const TrajectoryPoint& at, double L) {
  constexpr double kRounding = 1e-14;
  const double x = at.motion.contact.x;
  return std::abs(x) < kRounding * L ? 0.0 : x;
}

/// Arcs of one limit that follow each other are one, as where a body needs all
/// friction first forwards and then backwards.
std::vector<ActiveArc> active_arcs(const std::vector<Arc>& arcs,
                                   const std::vector<PathInequality>& limits,
                                   const StatedLimit& stated,
                                   const LimitedMotion& motion) {
  const double L = motion.scene().L;
  std::vector<ActiveArc> active;
  double begin = 0.0;
  for (const Arc& arc : arcs) {
    if (is_among(arc.held, limits, stated)) {
      const TrajectoryPoint from = motion.at(begin);
      const TrajectoryPoint to = motion.at(arc.end);
      if (!active.empty() && active.back().sigma.to == begin) {
        active.back().sigma.to = arc.end;
        active.back().u.to = to.u;
        active.back().t.to = to.t;
        active.back().x.to = place_of(to, L);
      } else {
        active.push_back({{begin, arc.end},
                          {from.u, to.u},
                          {from.t, to.t},
                          {place_of(from, L), place_of(to, L)}});
      }
    }
    if (arc.touch) {
      std::vector<nlp::Held> touched(limits.size(), nlp::Held::No);
      touched[arc.touch->limit] = arc.touch->at;
      if (is_among(touched, limits, stated)) {
        const TrajectoryPoint here = motion.at(arc.end);
        const double x = place_of(here, L);
        active.push_back(
            {{arc.end, arc.end}, {here.u, here.u}, {here.t, here.t}, {x, x}});
      }
    }
    begin = arc.end;
  }
  return active;
}

/// Of limits that hold nowhere.
void add_least_slacks(const std::vector<StatedLimit>& asked,
                      const LimitedMotion& motion,
                      std::vector<LimitOnPath>& limits) {
  const std::vector<TrajectoryPoint> rows = motion.fine_sample(0);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!limits[i].active.empty()) continue;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t row = 1; row < rows.size(); ++row) {
      const double slack = asked[i].slack(rows[row]);
      if (!(slack >= least)) least = slack;  // a NaN stays
    }
    limits[i].least_slack = least;
  }
}

}  // namespace

std::vector<LimitOnPath> limits_on_path(const PosedProblem& posed,
                                        const FittedPath& path,
                                        const LimitedMotion& motion) {
  // Half of what a bound is moved by, in natural units; of small ones a part.
  constexpr double kStep = 1e-5, kLeastStep = 1e-9, kPart = 0.1;
  const Scene& natural = *posed.limited;
  // τ = T √(2 g/H), times in natural units being those of 2 g = 1.
  const double tau = 1.0 / std::sqrt(natural.H);
  const std::vector<StatedLimit> asked = stated_limits(posed.asked);
  const std::vector<StatedLimit> scaled = stated_limits(natural);
  const bool known = arcs_are_known(path.curve);
  const std::vector<Arc> arcs = known ? path.arcs : arcs_of(path.curve);
  std::vector<LimitOnPath> out;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    LimitOnPath limit{asked[i].name, asked[i].bound, {}, 0.0, 0.0, {}, {}};
    limit.active =
        active_arcs(arcs, path.curve.problem().limits(), asked[i], motion);
    for (const ActiveArc& arc : limit.active) {
      limit.share_of_time += (arc.t.to - arc.t.from) / motion.transit_time();
    }
    out.push_back(std::move(limit));
  }
  if (asked.empty()) return out;
  add_least_slacks(asked, motion, out);
  if (!known) return out;
  LimitedRates rates(path);
  for (std::size_t i = 0; i < asked.size() && rates.regular(); ++i) {
    // One that holds nowhere may still decide the direction at A.
    PathLimits less = natural.limits, more = natural.limits;
    const double bound = scaled[i].bound.value_or(0.0);
    const double step =
        bound > 0.0 ? std::clamp(kPart * bound, kLeastStep, kStep) : kStep;
    scaled[i].move(less, -step);
    scaled[i].move(more, step);
    const TimeRate price =
        rates.price(inequalities(natural.body, less),
                    inequalities(natural.body, more), 2.0 * step);
    const double scale = tau * asked[i].natural;
    if (std::isfinite(price.total) && std::isfinite(price.at_fixed_contacts)) {
      out[i].price = price.total * scale;
      out[i].price_at_fixed_contacts = price.at_fixed_contacts * scale;
    }
  }
  return out;
}

}  // namespace brachisto
