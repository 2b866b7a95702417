// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limit_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/limit_table.hpp"

namespace brachisto {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double between(double loose, double wanted, double share, bool geometric) {
  if (!std::isfinite(wanted) || loose == wanted || share == 1.0) return wanted;
  return geometric ? loose * std::pow(wanted / loose, share)
                   : loose + share * (wanted - loose);
}

FreePath free_path(const ExtremalCurve& curve) {
  constexpr int kPlaces = 400;
  FreePath free;
  for (int i = 0; i <= kPlaces; ++i) {
    const auto at = turning_point(curve, static_cast<double>(i) / kPlaces);
    free.places.push_back(at);
    if (i < kPlaces / 20) continue;
    const double normal = contact_force(curve.scene(), at).normal;
    free.min_normal = std::min(free.min_normal, normal);
    free.max_normal = std::max(free.max_normal, normal);
    free.max_hump = std::max(free.max_hump, at.q / at.w);
    free.deepest = std::max(free.deepest, at.z);
  }
  return free;
}

/// Of a disc or a half-plane, to what a free path keeps off.
double number_kept(const Scene& scene, const FreePath& free,
                   const PathInequality& wanted) {
  const bool is_disc = wanted.kind == PathInequality::Kind::Disc;
  double nearest = kInfinity;
  Point before{free.places.front().x, free.places.front().z};
  for (TurningPoint<double> place : free.places) {
    const Point here{place.x, place.z};
    if (is_disc) {
      // It may be smaller than the distance of two places.
      const double share = next_to(before, here, wanted.place);
      place.x = before.x + share * (here.x - before.x);
      place.z = before.z + share * (here.z - before.z);
    }
    before = here;
    nearest = std::min(nearest, value_of(wanted, scene, place) + wanted.number);
  }
  return std::min(wanted.number,
                  is_disc ? 0.9 * nearest : nearest - 0.1 * scene.H);
}

}  // namespace

TurningPoint<double> turning_point(const ExtremalCurve& curve, double sigma) {
  const ExtremalPoint at = curve.at(sigma);
  const Scene& scene = curve.scene();
  return {at.centre.x, at.centre.z,
          at.theta,    at.w,
          at.beta,     slope_rate(scene, at.state(), at.p, at.beta)};
}

LimitRelaxation::LimitRelaxation(const Scene& scene,
                                 const ExtremalCurve& curve) {
  const FreePath free = free_path(curve);
  for (const LimitEntry& limit : limit_table()) {
    if (limit.pose == nullptr) continue;
    std::vector<PathInequality> posed;
    limit.pose(scene.body, scene.limits, posed);
    for (const PathInequality& wanted : posed) {
      Way way{wanted, wanted};
      way.geometric = limit.widen(scene, free, way.loose);
      ways_.push_back(way);
    }
  }
  // Behind them stands what the body keeps off.
  const std::vector<PathInequality> all =
      inequalities(scene.body, scene.limits);
  for (std::size_t i = ways_.size(); i < all.size(); ++i) {
    Way way{all[i], all[i]};
    way.loose.number = number_kept(scene, free, all[i]);
    ways_.push_back(way);
  }
}

bool bounds_differ_alone(const std::vector<PathInequality>& from,
                         const std::vector<PathInequality>& to) {
  const auto alike = [](const PathInequality& a, const PathInequality& b) {
    const auto follows = [](double before, double after) {
      return before == after || (std::isfinite(before) && std::isfinite(after));
    };
    const bool there = (a.place.x == b.place.x && a.place.z == b.place.z) ||
                       a.kind == PathInequality::Kind::HalfPlane;
    return a.kind == b.kind && there && a.normal.x == b.normal.x &&
           a.normal.z == b.normal.z && follows(a.lower, b.lower) &&
           follows(a.upper, b.upper) && follows(a.number, b.number);
  };
  return std::ranges::equal(from, to, alike);
}

LimitRelaxation::LimitRelaxation(const std::vector<PathInequality>& from,
                                 const std::vector<PathInequality>& to) {
  for (std::size_t i = 0; i < to.size(); ++i) ways_.push_back({from[i], to[i]});
}

std::vector<PathInequality> LimitRelaxation::at(double share) const {
  std::vector<PathInequality> limits;
  for (const Way& way : ways_) {
    PathInequality limit = way.wanted;
    limit.lower = between(way.loose.lower, limit.lower, share, false);
    limit.upper = between(way.loose.upper, limit.upper, share, false);
    limit.number =
        between(way.loose.number, limit.number, share, way.geometric);
    if (limit.kind == PathInequality::Kind::HalfPlane) {
      limit.place.x = between(way.loose.place.x, limit.place.x, share, false);
      limit.place.z = between(way.loose.place.z, limit.place.z, share, false);
    }
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace brachisto
