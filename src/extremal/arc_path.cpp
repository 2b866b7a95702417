// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace brachisto::arcs {

ArcPath::ArcPath(std::vector<Stretch> arcs, std::optional<Departure> leave)
    : arcs_(std::move(arcs)), leave_(std::move(leave)) {}

double ArcPath::rolling_time() const {
  double sum = 0.0;
  for (const Stretch& arc : arcs_) sum += arc.duration;
  return sum;
}

ArcPoint ArcPath::at(std::size_t arc, double u) const {
  const Stretch& here = arcs_[arc];
  ArcPoint out;
  if (blind(arc) && u < Departure::kLeftRest) {
    const State y = leave_->left_rest(u);
    double control = 0.0;
    // At rest itself there is no control.
    static_cast<void>(here.flow.find(here.flow.node_of(y), control, out));
    out.y = y;
    return out;
  }
  Knot knot = knot_at(arc, u);
  static_cast<void>(here.flow.find(knot.y, knot.control, out));
  return out;
}

Knot ArcPath::knot_at(std::size_t arc, double u) const {
  const Stretch& here = arcs_[arc];
  const auto next = std::upper_bound(
      here.knots.begin() + 1, here.knots.end(), u,
      [](double value, const Knot& knot) { return value < knot.u; });
  const Knot& from = *std::prev(next);
  if (from.u == u) return from;
  if (next == here.knots.end()) {
    return here.flow.step_from(from, from, u - from.u);
  }
  // From the nearer one, which leaves 2⁻⁹ of the error of a whole step.
  const Knot& to = *next;
  return u - from.u <= to.u - u ? here.flow.step_from(from, to, u - from.u)
                                : here.flow.step_from(to, from, u - to.u);
}

std::string ArcPath::objection(
    const std::vector<PathInequality>& limits) const {
  constexpr double kExceeded = 1e-8;
  constexpr double kWrongSign = 1e-6;
  const auto wrong_way = [](const HeldLimit& held, double multiplier) {
    return held.at_upper() ? multiplier : -multiplier;
  };
  std::string out;
  double start_of_arc = 0.0;
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    const ArcFlow& flow = arcs_[a].flow;
    double largest = 1.0, wrong = 0.0;
    // The start of an arc is the end of the one before, or rest, where a path
    // that leaves it freely may break limits at once.
    const auto rest = arcs_[a].knots.begin();
    for (auto knot = a == 0 && !blind(a) ? rest : rest + 1;
         knot != arcs_[a].knots.end(); ++knot) {
      const double u = start_of_arc + knot->u;
      ArcPoint here;
      double control = knot->control;
      if (!flow.find(knot->y, control, here)) {
        return fmt::format("its arc has no control at u = {:.6g}", u);
      }
      for (const PathInequality& limit : limits) {
        const double value = flow.value(limit, here);
        const double excess =
            std::max(limit.lower - value, value - limit.upper);
        if (excess <= kExceeded || !out.empty()) continue;
        if (a == 0 && knot == rest && leave_ && leave_->contact_keeps(limit))
          continue;
        out = fmt::format("{} is exceeded by {:.1e} at u = {:.6g}",
                          name(limit.kind), excess, u);
      }
      if (knot == rest) continue;
      if (!(here.y[kW] > 0.0)) {
        return fmt::format("the body comes to rest at u = {:.6g}", u);
      }
      if (flow.kind() == ArcFlow::Kind::Free && !(here.legendre > 0.0)) {
        out = fmt::format("its free arc is no minimum at u = {:.6g}", u);
      }
      if (!flow.held() || blind(a)) continue;
      largest = std::max(largest, std::abs(here.nu));
      wrong = std::max(wrong, wrong_way(*flow.held(), here.nu));
    }
    if (!out.empty()) return out;
    if (wrong > kWrongSign * largest) {
      return fmt::format("the multiplier of {} has the wrong sign, by {:.1e}",
                         name(flow.held()->limit.kind), wrong / largest);
    }
    const auto& along = arcs_[a].jumps_along;
    if (along && wrong_way(*along, arcs_[a].jump) > kWrongSign) {
      return fmt::format("the jump at {} has the wrong sign, by {:.1e}",
                         name(along->limit.kind), std::abs(arcs_[a].jump));
    }
    start_of_arc += arcs_[a].duration;
  }
  return out;
}

}  // namespace brachisto::arcs
