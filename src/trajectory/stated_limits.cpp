// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/stated_limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "model/units.hpp"

namespace brachisto {

namespace {

std::string numbered(std::string_view name, std::size_t index,
                     std::size_t count) {
  return count == 1 ? std::string(name) : fmt::format("{}.{}", name, index + 1);
}

}  // namespace

std::vector<StatedLimit> stated_limits(const Scene& scene) {
  using At = const TrajectoryPoint&;
  using Kind = PathInequality::Kind;
  const PathLimits& limits = scene.limits;
  const double R = scene.body.outer_radius();
  const Units units = natural_units(scene);
  const auto kept = std::make_shared<const Scene>(scene);
  std::vector<StatedLimit> all;
  for (const LimitEntry& limit : limit_table()) {
    const std::optional<double>& stated = limit.bound(limits);
    if (!stated) continue;
    const double bound = *stated;
    all.push_back(
        {std::string(limit.name()), bound, limit.words(limits, bound),
         [=, &limit](At p) {
           return limit.slack(*kept, bound, p.centre, p.motion);
         },
         [=, &limit](Kind kind, int, bool lower) {
           return limit.is(*kept, kind, lower);
         },
         [&limit](PathLimits& l, double by) { *limit.bound_in(l) += by; },
         units.measured(1.0, limit.dimension), limit.looser});
  }
  for (std::size_t i = 0; i < limits.discs.size(); ++i) {
    const Disc disc = limits.discs[i];
    all.push_back({numbered("clear_of.disc", i, limits.discs.size()),
                   disc.radius,
                   std::nullopt,
                   [=](At p) {
                     return std::hypot(p.centre.x - disc.centre.x,
                                       p.centre.z - disc.centre.z) -
                            disc.radius - R;
                   },
                   [=](Kind kind, int index, bool) {
                     return kind == Kind::Disc && index == static_cast<int>(i);
                   },
                   [=](PathLimits& l, double by) { l.discs[i].radius += by; },
                   1.0 / units.length,
                   {}});
  }
  for (std::size_t i = 0; i < limits.half_planes.size(); ++i) {
    const HalfPlane plane = limits.half_planes[i];
    const Point n{std::cos(plane.normal), std::sin(plane.normal)};
    all.push_back(
        {numbered("clear_of.half_plane", i, limits.half_planes.size()),
         std::nullopt,
         std::nullopt,
         [=](At p) {
           return (p.centre.x - plane.point.x) * n.x +
                  (p.centre.z - plane.point.z) * n.z - R;
         },
         [=](Kind kind, int index, bool) {
           return kind == Kind::HalfPlane && index == static_cast<int>(i);
         },
         [=](PathLimits& l, double by) {
           l.half_planes[i].point.x += n.x * by;
           l.half_planes[i].point.z += n.z * by;
         },
         1.0 / units.length,
         {}});
  }
  for (StatedLimit& limit : all) {
    if (limit.looser.empty()) limit.looser = "more room at " + limit.name;
  }
  return all;
}

}  // namespace brachisto
