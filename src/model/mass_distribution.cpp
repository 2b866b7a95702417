// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace brachisto {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double distance(Point p) {
  return std::hypot(p.x, p.z);
}

void require_positive(std::string_view what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(
      fmt::format("{} {} is not allowed: it is finite and > 0", what, value));
}

void require_finite(std::initializer_list<Point> points) {
  for (const Point& p : points) {
    if (std::isfinite(p.x) && std::isfinite(p.z)) continue;
    throw std::invalid_argument("a place is not finite");
  }
}

void check(std::span<const MassPart> parts, double radius) {
  // A place on the rim may be beyond it by the rounding of its coordinates.
  const double largest = radius * (1.0 + 4.0 * kEpsilon);
  require_positive("the radius of the cylinder,", radius);
  if (parts.empty()) throw std::invalid_argument("a body has parts");
  for (const MassPart& part : parts) {
    require_positive("the mass", part.mass);
    if (part.reach <= largest) continue;
    throw std::invalid_argument(fmt::format(
        "{}it reaches {:.12g} from the axis, beyond the cylinder of radius "
        "{:.6g}; a part lies within",
        part.name.empty() ? "" : part.name + ": ", part.reach, radius));
  }
}

}  // namespace

MassPart MassPart::point(double mass, Point at) {
  require_positive("the mass", mass);
  require_finite({at});
  return {mass, at, 0.0, distance(at)};
}

MassPart MassPart::ring(double mass, Point at, double radius) {
  require_positive("the mass", mass);
  require_positive("the radius", radius);
  require_finite({at});
  return {mass, at, radius * radius, distance(at) + radius};
}

MassPart MassPart::disc(double mass, Point at, double radius, double hole) {
  MassPart part = ring(mass, at, radius);
  if (!(hole >= 0.0 && hole < radius)) {
    throw std::invalid_argument(fmt::format(
        "the hole {} is not allowed: 0 ≤ hole < radius = {}", hole, radius));
  }
  part.own_inertia = 0.5 * (radius * radius + hole * hole);
  return part;
}

MassPart MassPart::rod(double mass, Point from, Point to) {
  require_positive("the mass", mass);
  require_finite({from, to});
  const double length = distance({to.x - from.x, to.z - from.z});
  return {mass,
          {0.5 * (from.x + to.x), 0.5 * (from.z + to.z)},
          length * length / 12.0,
          std::max(distance(from), distance(to))};
}

MassProperties mass_properties(std::span<const MassPart> parts, double radius) {
  check(parts, radius);
  // Wider numbers, so that the sums do not add to the rounding of the parts.
  using Sum = long double;
  Sum mass = 0.0, x = 0.0, z = 0.0, reach = 0.0;
  for (const MassPart& part : parts) mass += part.mass;
  for (const MassPart& part : parts) {
    const Sum share = part.mass / mass;
    x += share * part.centre.x;
    z += share * part.centre.z;
    reach += share * part.reach;
  }
  if (std::hypot(x, z) <= 4.0 * kEpsilon * reach) x = z = 0.0;

  Sum inertia = 0.0;  // over m
  for (const MassPart& part : parts) {
    const Sum dx = part.centre.x - x;
    const Sum dz = part.centre.z - z;
    inertia += part.mass / mass * (part.own_inertia + dx * dx + dz * dz);
  }

  MassProperties found;
  found.mass = static_cast<double>(mass);
  found.r_m = std::min(radius, static_cast<double>(std::hypot(x, z)));
  found.eta_m = found.r_m / radius;
  found.theta_m = static_cast<double>(std::atan2(z, x));
  // Mass on the rim may be beyond it by rounding; the law holds all the same.
  found.k = std::min(static_cast<double>(inertia / radius / radius),
                     found.largest_k());
  return found;
}

}  // namespace brachisto
