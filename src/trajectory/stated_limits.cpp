// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/stated_limits.hpp"

#include <fmt/format.h>

#include <cmath>
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
  const Body& body = scene.body;
  const double r = body.radius;
  const Units units = natural_units(scene);
  std::vector<StatedLimit> all;
  if (const auto mu = limits.friction) {
    all.push_back(
        {"friction", mu, BoundInWords{"|R_t|", "≤", *mu, "R_n"},
         [=](At p) { return *mu * p.motion.R_n - std::abs(p.motion.R_t); },
         [](Kind kind, int, bool) { return kind <= Kind::FrictionBackward; },
         [](PathLimits& l, double by) { *l.friction += by; }});
  }
  if (const auto least = limits.normal_min) {
    all.push_back({"normal_force.min", least,
                   BoundInWords{"R_n", "≥", *least, "m g"},
                   [=](At p) { return p.motion.R_n - *least; },
                   [](Kind kind, int, bool lower) {
                     return kind == Kind::NormalForce && lower;
                   },
                   [](PathLimits& l, double by) { *l.normal_min += by; }});
  }
  if (const auto most = limits.normal_max) {
    all.push_back({"normal_force.max", most,
                   BoundInWords{"R_n", "≤", *most, "m g"},
                   [=](At p) { return *most - p.motion.R_n; },
                   [](Kind kind, int, bool lower) {
                     return kind == Kind::NormalForce && !lower;
                   },
                   [](PathLimits& l, double by) { *l.normal_max += by; }});
  }
  const bool of_centre =
      limits.curvature.of == CurvatureLimit::Of::Centre && body.rolls();
  const auto curvature = [=](At p) {
    return of_centre ? (1.0 - p.motion.fold_margin) / r : p.motion.kappa_b;
  };
  const char* kappa =
      limits.curvature.of == CurvatureLimit::Of::Track ? "κ_b" : "κ_c";
  PathLimits unfolded = limits;
  unfolded.fold_margin.reset();
  const bool folds_first =
      hump_of_centre(body, limits) < hump_of_centre(body, unfolded);
  if (const auto K = limits.curvature.hump) {
    all.push_back({"curvature.hump", K, BoundInWords{kappa, "≤", *K, "1/m"},
                   [=](At p) { return *K - curvature(p); },
                   [=](Kind kind, int, bool) {
                     return kind == Kind::Hump && !folds_first;
                   },
                   [](PathLimits& l, double by) { *l.curvature.hump += by; },
                   units.length});
  }
  if (const auto K = limits.curvature.valley) {
    all.push_back({"curvature.valley", K, BoundInWords{kappa, "≥", -*K, "1/m"},
                   [=](At p) { return *K + curvature(p); },
                   [](Kind kind, int, bool) { return kind == Kind::Valley; },
                   [](PathLimits& l, double by) { *l.curvature.valley += by; },
                   units.length});
  }
  if (const auto m = limits.fold_margin) {
    all.push_back({"fold_margin", m, BoundInWords{"1 − r κ_c", "≥", *m, ""},
                   [=](At p) { return p.motion.fold_margin - *m; },
                   [=](Kind kind, int, bool) {
                     return kind == Kind::Hump && folds_first;
                   },
                   [](PathLimits& l, double by) { *l.fold_margin += by; }});
  }
  if (const auto D = limits.floor) {
    all.push_back({"floor", D, BoundInWords{"floor at z", "=", *D, "m"},
                   [=](At p) { return *D - r - p.centre.z; },
                   [](Kind kind, int, bool) { return kind == Kind::Floor; },
                   [](PathLimits& l, double by) { *l.floor += by; },
                   1.0 / units.length});
  }
  for (std::size_t i = 0; i < limits.discs.size(); ++i) {
    const Disc disc = limits.discs[i];
    all.push_back({numbered("clear_of.disc", i, limits.discs.size()),
                   disc.radius, std::nullopt,
                   [=](At p) {
                     return std::hypot(p.centre.x - disc.centre.x,
                                       p.centre.z - disc.centre.z) -
                            disc.radius - r;
                   },
                   [=](Kind kind, int index, bool) {
                     return kind == Kind::Disc && index == static_cast<int>(i);
                   },
                   [=](PathLimits& l, double by) { l.discs[i].radius += by; },
                   1.0 / units.length});
  }
  for (std::size_t i = 0; i < limits.half_planes.size(); ++i) {
    const HalfPlane plane = limits.half_planes[i];
    const Point n{std::cos(plane.normal), std::sin(plane.normal)};
    all.push_back(
        {numbered("clear_of.half_plane", i, limits.half_planes.size()),
         std::nullopt, std::nullopt,
         [=](At p) {
           return (p.centre.x - plane.point.x) * n.x +
                  (p.centre.z - plane.point.z) * n.z - r;
         },
         [=](Kind kind, int index, bool) {
           return kind == Kind::HalfPlane && index == static_cast<int>(i);
         },
         [=](PathLimits& l, double by) {
           l.half_planes[i].point.x += n.x * by;
           l.half_planes[i].point.z += n.z * by;
         },
         1.0 / units.length});
  }
  return all;
}

}  // namespace brachisto
