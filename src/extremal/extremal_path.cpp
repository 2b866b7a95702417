// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/extremal_path.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <utility>

namespace brachisto {

bool Regularity::free_of_loops() const {
  // Rounding and integration errors of slopes, with a wide margin.
  constexpr double kSlack = 1e-9;
  return min_beta >= -std::numbers::pi - kSlack &&
         max_beta <= std::numbers::pi + kSlack;
}

ExtremalPath::ExtremalPath(const Scene& natural, const Units& units,
                           arcs::ArcPath path)
    : rolls_(natural.body.rolls()), units_(units), path_(std::move(path)) {}

ExtremalState ExtremalPath::at(double sigma) const {
  assert(!empty());
  const double u = std::clamp(sigma, 0.0, 1.0) * path_.rolling_time();
  return in_si(path_.knot_at(0, u), units_, rolls_);
}

ExtremalState in_si(const arcs::Knot& knot, const Units& units, bool rolls) {
  using namespace arcs::free_arc;
  const arcs::Node& y = knot.y;
  return {.x = y(kX) * units.length,
          .z = y(kZ) * units.length,
          .theta = rolls ? y(kTheta) : 0.0,
          .w = y(kW) * units.speed(),
          .p_theta = rolls ? y(kPTheta) * units.time : 0.0,
          .p_w = y(kPW) * units.time / units.speed(),
          .beta = knot.control,
          .t = knot.t * units.time,
          .p_x = y(kPX) / units.speed(),
          .p_z = y(kPZ) / units.speed()};
}

Regularity ExtremalPath::regularity() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Regularity found{.min_legendre = kInfinity,
                   .min_w = kInfinity,
                   .min_beta = kInfinity,
                   .max_beta = -kInfinity};
  const arcs::ArcPath::Stretch& arc = path_.arcs().front();
  double max_w = 0.0;
  for (const arcs::Knot& knot : arc.knots) {
    arcs::ArcPoint at;
    double beta = knot.control;
    const double legendre =
        arc.flow.find(knot.y, beta, at) ? at.legendre : -kInfinity;
    found.min_legendre = std::min(found.min_legendre, legendre);
    const double w = knot.y(arcs::free_arc::kW);
    if (&knot != &arc.knots.front()) found.min_w = std::min(found.min_w, w);
    max_w = std::max(max_w, w);
    found.min_beta = std::min(found.min_beta, knot.control);
    found.max_beta = std::max(found.max_beta, knot.control);
  }
  found.min_w /= max_w;
  return found;
}

}  // namespace brachisto
