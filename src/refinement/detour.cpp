// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/detour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "brachisto/math/index.hpp"
#include "model/energy.hpp"
#include "refinement/limit_relaxation.hpp"

namespace brachisto {

namespace {

/// The places of a path of the centre, with the speeds that it falls with.
std::optional<RoughPath> rolled(const Scene& scene,
                                const std::vector<Point>& centre,
                                const TurningPoint<double>& start) {
  constexpr double kSteepest = 0.95 * std::numbers::pi;
  // Of the fall from A to B: it may pass where no body comes.
  constexpr double kLeastFall = 0.02;
  RoughPath path;
  path.rolling_time = 0.0;
  std::vector<double> u{0.0};
  std::vector<TurningPoint<double>> all{start};
  double s = 0.0;
  for (std::size_t i = 1; i < centre.size(); ++i) {
    const double dx = centre[i].x - centre[i - 1].x;
    const double dz = centre[i].z - centre[i - 1].z;
    const double ds = std::hypot(dx, dz);
    s += ds;
    TurningPoint<double> here{};
    here.x = centre[i].x;
    here.z = centre[i].z;
    here.beta = std::atan2(dz, dx);
    if (std::abs(here.beta) > kSteepest) return std::nullopt;
    const double radius = scene.body.radius;
    const double theta = scene.body.theta_m + (radius > 0.0 ? s / radius : 0.0);
    const double share = std::min(1.0, s / scene.H);
    const double E =
        energy_height(scene.body, here.z - centre.front().z, theta);
    here.theta = theta;
    here.w = std::hypot(
        start.w,
        fall_speed(scene.gravity, std::max(E, kLeastFall * share * scene.H)));
    const double du = 2.0 * ds / (here.w + all.back().w);
    here.q = (here.beta - all.back().beta) / du;
    u.push_back(u.back() + du);
    all.push_back(here);
  }
  path.rolling_time = u.back();
  // At equal times.
  std::size_t i = 1;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double wanted = path.rolling_time * static_cast<double>(k) /
                          static_cast<double>(all.size() - 1);
    while (i + 1 < u.size() && u[i] < wanted) ++i;
    const double t =
        std::clamp((wanted - u[i - 1]) / (u[i] - u[i - 1]), 0.0, 1.0);
    const auto mean = [&](double TurningPoint<double>::*state) {
      return all[i - 1].*state + t * (all[i].*state - all[i - 1].*state);
    };
    using At = TurningPoint<double>;
    path.places.push_back({mean(&At::x), mean(&At::z), mean(&At::theta),
                           mean(&At::w), mean(&At::beta), mean(&At::q)});
  }
  return path;
}

}  // namespace

TurningPoint<double> RoughPath::at(double sigma) const {
  const double place = sigma * static_cast<double>(places.size() - 1);
  const auto i = std::min(places.size() - 2, static_cast<std::size_t>(place));
  const double t = place - static_cast<double>(i);
  const auto mean = [&](double TurningPoint<double>::*state) {
    return places[i].*state + t * (places[i + 1].*state - places[i].*state);
  };
  using At = TurningPoint<double>;
  return {mean(&At::x), mean(&At::z),    mean(&At::theta),
          mean(&At::w), mean(&At::beta), mean(&At::q)};
}

std::vector<RoughPath> other_ways(const Scene& scene, const ExtremalCurve& free,
                                  const std::vector<PathInequality>& limits) {
  constexpr int kPlaces = 400;
  constexpr double kNear = 2.0, kRoom = 1.05, kSag = 0.25;
  std::vector<Point> centre;
  std::vector<double> length{0.0};
  for (int i = 0; i <= kPlaces; ++i) {
    // Places close together at rest.
    const double sigma = static_cast<double>(i) / kPlaces;
    const TurningPoint<double> at = turning_point(free, sigma);
    if (i > 0) {
      length.push_back(length.back() + distance(centre.back(), {at.x, at.z}));
    }
    centre.push_back({at.x, at.z});
  }
  std::vector<RoughPath> out;
  const auto add = [&](const std::vector<Point>& way) {
    if (auto path = rolled(scene, way, turning_point(free, 0.0))) {
      out.push_back(*std::move(path));
    }
  };
  for (const PathInequality& limit : limits) {
    if (limit.kind != PathInequality::Kind::Disc) continue;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < centre.size(); ++i) {
      if (distance(centre[i], limit.place) <
          distance(centre[nearest], limit.place)) {
        nearest = i;
      }
    }
    const Point from = centre[nearest];
    const double near = distance(from, limit.place);
    const double reach = limit.number;
    if (near > kNear * reach || nearest == 0 || nearest + 1 == centre.size()) {
      continue;
    }
    // The normal of the path there, towards the disc's centre.
    const Point before = centre[nearest - 1], after = centre[nearest + 1];
    const double chord = distance(before, after);
    Point normal{-(after.z - before.z) / chord, (after.x - before.x) / chord};
    const double along = (limit.place.x - from.x) * normal.x +
                         (limit.place.z - from.z) * normal.z;
    if (along < 0.0) normal = {-normal.x, -normal.z};
    const double shift = std::abs(along) + kRoom * reach;
    // A bump as long as the disc reaches and the shift is high, none at A and
    // B.
    const double width = 0.7 * (reach + shift);
    std::vector<Point> bent = centre;
    const double all = length.back();
    for (std::size_t i = 0; i < bent.size(); ++i) {
      const double off = (length[i] - length[nearest]) / width;
      const double room = length[i] < length[nearest]
                              ? length[i] / length[nearest]
                              : (all - length[i]) / (all - length[nearest]);
      const double bump = shift * std::exp(-off * off) * std::min(1.0, room);
      bent[i].x += bump * normal.x;
      bent[i].z += bump * normal.z;
    }
    add(bent);
  }
  const Point from = centre.front(), to = centre.back();
  for (const double sag : {0.0, kSag * distance(from, to)}) {
    std::vector<Point> bow;
    for (int i = 0; i <= kPlaces; ++i) {
      const double t = std::pow(static_cast<double>(i) / kPlaces, 2);
      bow.push_back({from.x + t * (to.x - from.x),
                     from.z + t * (to.z - from.z) + 4.0 * sag * t * (1.0 - t)});
    }
    add(bow);
  }
  return out;
}

}  // namespace brachisto
