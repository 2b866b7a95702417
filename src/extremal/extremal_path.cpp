// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/extremal_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "extremal/arc_flow.hpp"
#include "extremal/arc_integration.hpp"
#include "model/world_hamiltonian.hpp"

namespace brachisto {

using shooting::CanonicalFlow;

bool Regularity::free_of_loops() const {
  // Rounding and integration errors of slopes, with a wide margin.
  constexpr double kSlack = 1e-9;
  return min_beta >= -std::numbers::pi - kSlack &&
         max_beta <= std::numbers::pi + kSlack;
}

ExtremalPath::ExtremalPath(const Scene& natural, const Units& units, double p_x,
                           double p_z, std::vector<Knot> knots)
    : natural_(natural),
      units_(units),
      p_x_(p_x),
      p_z_(p_z),
      knots_(std::move(knots)) {}

ExtremalState ExtremalPath::at(double sigma) const {
  assert(!empty());
  const double U = knots_.back().u;
  const double u = std::clamp(sigma, 0.0, 1.0) * U;
  const auto next = std::upper_bound(
      knots_.begin(), knots_.end(), u,
      [](double value, const Knot& knot) { return value < knot.u; });
  const Knot& knot = *std::prev(next);
  if (knot.u == u) return in_si(knot);
  if (!natural_.world.ordinary()) {
    return in_si(in_world(knot, *next, u - knot.u));
  }
  const CanonicalFlow flow(natural_.body, natural_.gravity,
                           {p_x_, p_z_, natural_.body.eta_m});
  return in_si(shooting::step_from(flow, knot, u - knot.u));
}

ExtremalPath::Knot ExtremalPath::in_world(const Knot& knot, const Knot& next,
                                          double span) const {
  const auto node_at = [](const Knot& at) {
    const auto& [x, z, theta, w, p_theta, p_w] = at.y;
    arcs::Knot out{at.u, arcs::Node(8), at.t, at.beta};
    out.y << x, z, theta, w, at.p_x, at.p_z, p_theta, p_w;
    return out;
  };
  const arcs::ArcFlow flow(natural_, std::nullopt);
  const arcs::Knot there = flow.step_from(node_at(knot), node_at(next), span);
  const auto& y = there.y;
  return {.u = there.u,
          .y = {y(0), y(1), y(2), y(3), y(6), y(7)},
          .t = there.t,
          .beta = there.control,
          .p_x = y(4),
          .p_z = y(5)};
}

ExtremalState ExtremalPath::in_si(const Knot& knot) const {
  const bool rolls = natural_.body.rolls();
  const bool ordinary = natural_.world.ordinary();
  return {.x = knot.y[shooting::kX] * units_.length,
          .z = knot.y[shooting::kZ] * units_.length,
          .theta = rolls ? knot.y[shooting::kTheta] : 0.0,
          .w = knot.y[shooting::kW] * units_.speed(),
          .p_theta = rolls ? knot.y[shooting::kPTheta] * units_.time : 0.0,
          .p_w = knot.y[shooting::kPW] * units_.time / units_.speed(),
          .beta = knot.beta,
          .t = knot.t * units_.time,
          .p_x = (ordinary ? p_x_ : knot.p_x) / units_.speed(),
          .p_z = (ordinary ? p_z_ : knot.p_z) / units_.speed()};
}

Regularity ExtremalPath::regularity() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Regularity found{.min_legendre = kInfinity,
                   .min_w = kInfinity,
                   .min_beta = kInfinity,
                   .max_beta = -kInfinity};
  const CanonicalFlow flow(natural_.body, natural_.gravity,
                           {p_x_, p_z_, natural_.body.eta_m});
  double max_w = 0.0;
  for (const Knot& knot : knots_) {
    const shooting::State& y = knot.y;
    double legendre = -kInfinity;
    CanonicalFlow::Slope slope;
    if (!natural_.world.ordinary()) {
      legendre = slope_hamiltonian(natural_,
                                   {{y[shooting::kX], y[shooting::kZ]},
                                    y[shooting::kTheta],
                                    y[shooting::kW]},
                                   {knot.p_x, knot.p_z, y[shooting::kPTheta],
                                    y[shooting::kPW]},
                                   knot.beta)
                     .d2_beta;
    } else if (flow.find_slope(y, knot.beta, slope)) {
      legendre = slope.legendre;
    }
    found.min_legendre = std::min(found.min_legendre, legendre);
    if (&knot != &knots_.front()) {
      found.min_w = std::min(found.min_w, y[shooting::kW]);
    }
    max_w = std::max(max_w, y[shooting::kW]);
    found.min_beta = std::min(found.min_beta, knot.beta);
    found.max_beta = std::max(found.max_beta, knot.beta);
  }
  found.min_w /= max_w;
  return found;
}

}  // namespace brachisto
