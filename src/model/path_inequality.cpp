// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/path_inequality.hpp"

#include <algorithm>

#include "model/limit_table.hpp"

namespace brachisto {

namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

}  // namespace

double hump_of_centre(const Body& body, const PathLimits& limits) {
  double bound = limits.curvature.hump.value_or(kFree);
  if (limits.curvature.of == CurvatureLimit::Of::Track && bound < kFree) {
    bound /= 1.0 + body.radius * bound;
  }
  if (limits.fold_margin && body.rolls()) {
    bound =
        std::min(bound, (1.0 - *limits.fold_margin) / body.folding_distance());
  }
  return bound;
}

double valley_of_centre(const Body& body, const PathLimits& limits) {
  const double bound = limits.curvature.valley.value_or(kFree);
  if (limits.curvature.of == CurvatureLimit::Of::Centre) return bound;
  const double left = 1.0 - body.radius * bound;
  return left > 0.0 ? bound / left : kFree;
}

bool bound_valleys(const std::vector<PathInequality>& limits) {
  return std::any_of(limits.begin(), limits.end(),
                     [](const PathInequality& limit) {
                       return limit.kind == PathInequality::Kind::Valley;
                     });
}

std::vector<PathInequality> inequalities(const Body& body,
                                         const PathLimits& limits) {
  using Kind = PathInequality::Kind;
  std::vector<PathInequality> all;
  for (const LimitEntry& limit : limit_table()) {
    if (limit.pose != nullptr) limit.pose(body, limits, all);
  }
  for (const Disc& disc : limits.discs) {
    all.push_back({.kind = Kind::Disc,
                   .number = disc.radius + body.outer_radius(),
                   .place = disc.centre});
  }
  for (const HalfPlane& plane : limits.half_planes) {
    all.push_back({.kind = Kind::HalfPlane,
                   .number = body.outer_radius(),
                   .place = plane.point,
                   .normal = {std::cos(plane.normal), std::sin(plane.normal)}});
  }
  return all;
}

PathLimits in_units_of(const Units& units, PathLimits limits) {
  const double length = units.length;
  for (const LimitEntry& limit : limit_table()) {
    std::optional<double>& bound = limit.bound_in(limits);
    if (bound) *bound = units.measured(*bound, limit.dimension);
  }
  for (Disc& disc : limits.discs) {
    disc = {{disc.centre.x / length, disc.centre.z / length},
            disc.radius / length};
  }
  for (HalfPlane& plane : limits.half_planes) {
    plane.point = {plane.point.x / length, plane.point.z / length};
  }
  return limits;
}

double next_to(Point a, Point b, Point c) {
  const Point along{b.x - a.x, b.z - a.z};
  const double length2 = along.x * along.x + along.z * along.z;
  if (!(length2 > 0.0)) return 0.0;
  return std::clamp(((c.x - a.x) * along.x + (c.z - a.z) * along.z) / length2,
                    0.0, 1.0);
}

Excess worst_excess(const std::vector<PathInequality>& limits,
                    const Scene& scene, const TurningPoint<double>& place) {
  const bool forces =
      std::ranges::any_of(limits, &PathInequality::bounds_force);
  const ContactForce<double> force =
      forces ? contact_force(scene, place) : ContactForce<double>{};
  Excess worst;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double value = value_of(limits[i], force, place);
    const double below = limits[i].lower - value;
    const double above = value - limits[i].upper;
    if (std::isnan(value)) {
      return {std::numeric_limits<double>::quiet_NaN(), static_cast<int>(i),
              false};
    }
    if (std::max(below, above) <= worst.value) continue;
    worst = {std::max(below, above), static_cast<int>(i), above > below};
  }
  return worst;
}

}  // namespace brachisto
