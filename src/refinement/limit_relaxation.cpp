// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limit_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brachisto {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double between(double loose, double wanted, double share, bool geometric) {
  if (!std::isfinite(wanted) || loose == wanted) return wanted;
  return geometric ? loose * std::pow(wanted / loose, share)
                   : loose + share * (wanted - loose);
}

/// What the free extremal does that limits may forbid, for u > 0.05 U.
struct FreePath {
  double min_normal = kInfinity, max_normal = -kInfinity;
  double max_hump = 0.0;  ///< of κ_c
  double deepest = 0.0;
  std::vector<TurningPoint<double>> places;  ///< of the whole path

  explicit FreePath(const ExtremalCurve& curve) {
    constexpr int kPlaces = 400;
    for (int i = 0; i <= kPlaces; ++i) {
      const auto at = turning_point(curve, static_cast<double>(i) / kPlaces);
      places.push_back(at);
      if (i < kPlaces / 20) continue;
      const double normal = contact_force(curve.scene(), at).normal;
      min_normal = std::min(min_normal, normal);
      max_normal = std::max(max_normal, normal);
      max_hump = std::max(max_hump, at.q / at.w);
      deepest = std::max(deepest, at.z);
    }
  }
};

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
  using Kind = PathInequality::Kind;
  constexpr double kGreatFriction = 20.0;
  constexpr double kSharpValley = 60.0;  // per H
  const FreePath free(curve);
  for (const PathInequality& wanted : inequalities(scene.body, scene.limits)) {
    Way way{wanted, wanted};
    PathInequality& loose = way.loose;
    switch (wanted.kind) {
      case Kind::FrictionForward:
      case Kind::FrictionBackward:
        loose.number = std::max(wanted.number, kGreatFriction);
        way.geometric = true;
        // Where the free extremal lifts off no friction is enough.
        loose.lower =
            std::min(wanted.lower,
                     loose.number * (std::min(0.0, free.min_normal) * 1.2));
        break;
      case Kind::NormalForce:
        loose.lower = std::min(wanted.lower, free.min_normal - 0.5);
        loose.upper = std::max(wanted.upper, free.max_normal + 0.5);
        break;
      case Kind::Hump:
        if (scene.contact == Contact::Optimal) break;
        loose.number =
            std::max({wanted.number, 2.0 * free.max_hump, 1.0 / scene.H});
        way.geometric = true;
        break;
      case Kind::Valley:
        loose.number = std::max(wanted.number, kSharpValley / scene.H);
        way.geometric = true;
        break;
      case Kind::Floor:
        loose.number = std::max(wanted.number, free.deepest + 0.1 * scene.H);
        break;
      case Kind::Disc:
      case Kind::HalfPlane: {
        double nearest = kInfinity;
        Point before{free.places.front().x, free.places.front().z};
        for (TurningPoint<double> place : free.places) {
          const Point here{place.x, place.z};
          if (wanted.kind == Kind::Disc) {
            // It may be smaller than the distance of two places.
            const double share = next_to(before, here, wanted.place);
            place.x = before.x + share * (here.x - before.x);
            place.z = before.z + share * (here.z - before.z);
          }
          before = here;
          nearest =
              std::min(nearest, value_of(wanted, scene, place) + wanted.number);
        }
        loose.number = std::min(wanted.number, wanted.kind == Kind::Disc
                                                   ? 0.9 * nearest
                                                   : nearest - 0.1 * scene.H);
        break;
      }
    }
    ways_.push_back(way);
  }
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
