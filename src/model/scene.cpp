// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brachisto/model/body.hpp"
#include "math/angle.hpp"
#include "model/contact.hpp"
#include "model/plane_curve.hpp"
#include "model/scene_checker.hpp"

namespace brachisto {

namespace {

void check_bead(const Body& body, SceneChecker& check) {
  const auto absent = [&](const char* key, double value) {
    if (value == 0.0) return;
    check.add(key, "a bead is a point mass and has no such property");
  };
  absent("scene.body.radius", body.radius);
  absent("scene.body.eta_m", body.eta_m);
  absent("scene.body.theta_m", body.theta_m);
  absent("scene.body.k", body.k);
}

/// Of a cylinder, or of a ball in its own numbers.
void check_rolling(const Body& body, SceneChecker& check) {
  const char* kind = body.ball ? "ball" : "cylinder";
  check.positive(
      "scene.body.radius", body.radius, " m",
      fmt::format("for the radius of a {} is a length", kind).c_str());
  check.angle("scene.body.theta_m", body.theta_m);
  const double eta = body.eta_m;
  if (check.finite("scene.body.eta_m", eta)) {
    if (eta < 0.0 || eta > 1.0) {
      check.add("scene.body.eta_m",
                fmt::format("{} is not allowed: 0 ≤ η_m ≤ 1, for the centre of "
                            "mass lies inside the {}",
                            eta, kind));
    } else if (eta == 1.0) {
      check.add("scene.body.eta_m",
                "1 is not allowed: all mass would sit in one point of the rim "
                "(k = 0), whose speed, and with it the inertia factor A, "
                "vanishes whenever that point touches the track");
    } else if (eta > 0.0 && eta < kSmallestQuantity) {
      check.add("scene.body.eta_m",
                fmt::format("{} is not allowed: 0, or from {:g} on, for "
                            "products with such a number have to be normal "
                            "numbers of 64 bits",
                            eta, kSmallestQuantity));
    }
  }
  if (!check.finite("scene.body.k", body.k)) return;
  if (body.k < 0.0) {
    check.add(
        "scene.body.k",
        fmt::format("{} is not allowed: 0 ≤ k, for a moment of inertia is "
                    "not negative",
                    body.k));
  }
  if (eta >= 0.0 && eta < 1.0 && body.k > largest_k(eta) + kBoundSlack) {
    check.add("scene.body.k",
              fmt::format("{} is not allowed: k ≤ 1 − η_m² = {} for η_m = {}, "
                          "reached when all mass sits on the rim",
                          body.k, largest_k(eta), eta));
  }
}

/// What a ball runs in, and whether it rolls there as is laid down for it.
void check_ball(const Ball& ball, SceneChecker& check) {
  constexpr const char* kGauge = "scene.body.rails.gauge";
  constexpr const char* kRailRadius = "scene.body.rails.radius";
  constexpr const char* kGroove = "scene.body.groove";
  constexpr const char* kAngle = "scene.body.groove.angle";
  if (ball.rail_radius) {
    if (!ball.gauge) check.add(kGauge, "missing: how far the rails are apart");
    check.positive(kRailRadius, *ball.rail_radius, " m",
                   "for the radius of round rails is a length; thin ones have "
                   "none");
  }
  if (ball.gauge) {
    check.positive(kGauge, *ball.gauge, " m", "for it is between two rails");
    if (ball.groove) {
      check.add(kGroove,
                "not allowed beside rails: a ball runs in one of them");
    }
  }
  if (ball.groove && check.finite(kAngle, *ball.groove) &&
      !(*ball.groove > 0.0 && *ball.groove < std::numbers::pi)) {
    check.add(
        kAngle,
        fmt::format("{} rad is not allowed: it must be between 0 and π (180 "
                    "deg), from wall to wall",
                    *ball.groove));
  }
  if (!check.sound()) return;
  const double r = ball.rolling_radius();
  if (ball.gauge && !(r > 0.0)) {
    check.add(
        kGauge,
        ball.rail_radius
            ? fmt::format(
                  "{} m is not allowed: it must be less than 2 (R + ρ) = {} "
                  "m, or the ball falls between the rails",
                  *ball.gauge, 2.0 * (ball.radius + *ball.rail_radius))
            : fmt::format(
                  "{} m is not allowed: it must be less than 2 R = {} m, or "
                  "the ball falls between the rails",
                  *ball.gauge, 2.0 * ball.radius));
  } else if (ball.eta_m * ball.radius >= r) {
    check.add(
        "scene.body.eta_m",
        fmt::format(
            "{} is not allowed: it must be less than r_e/R = {}, for what "
            "follows is laid down for a centre of mass that "
            "stays above the line through the contacts",
            ball.eta_m, r / ball.radius));
  } else if (ball.rail_radius && *ball.gauge <= 2.0 * *ball.rail_radius) {
    check.add(
        kGauge,
        fmt::format("{} m is not allowed: it must be more than 2 ρ = {} m, "
                    "for round rails are apart by more than they "
                    "are thick",
                    *ball.gauge, 2.0 * *ball.rail_radius));
  }
}

/// Those of a path that only the library is told of.
void check_slopes(const Scene& scene, SceneChecker& check) {
  constexpr const char* kKey = "scene.path.slopes";
  const SlopesAlong& slopes = scene.path->slopes;
  check.positive(kKey, slopes.length, " m", "for it is the length of the path");
  const std::vector<double>& q = slopes.q;
  if (q.size() < 2 || q.size() != slopes.beta.size() || q.front() != 0.0 ||
      q.back() != 1.0 || !(q[1] > 0.0) || !(q[q.size() - 2] < 1.0) ||
      !std::ranges::is_sorted(q)) {
    return check.add(kKey, "places ascend from 0 to 1, with a slope for each");
  }
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (!check.finite(kKey, slopes.beta[i])) return;
    if (i == 0 || q[i] > q[i - 1]) continue;
    if (!(q[i] < q[i + 1]) || slopes.beta[i] != slopes.beta[i - 1]) {
      return check.add(kKey, "a place is given twice at most, with one slope");
    }
  }
  const double r = scene.path->curve == GivenPath::Curve::Track
                       ? 0.0
                       : contact_radius(scene);
  const PlaneCurvePtr path =
      curve_of_slopes(centre_above({}, r, slopes.beta.front()), slopes);
  const Point end =
      track_below(point_of(*path, path->at(1.0)), r, slopes.beta.back());
  if (!(distance(end, {scene.L, scene.H}) <=
        kCloseToEnds * std::hypot(scene.L, scene.H))) {
    check.add(kKey, fmt::format("the track ends at ({:.9g}, {:.9g}) and has to "
                                "end at ({:.9g}, {:.9g})",
                                end.x, end.z, scene.L, scene.H));
  }
}

/// Of the scene on whose track another's body is.
void check_other(const Scene& other, const Scene& scene, SceneChecker& check) {
  constexpr const char* kKey = "scene.path.track_of";
  if (!other.path || other.path->track_of) {
    return check.add(kKey, "that scene has to state the path of its body");
  }
  for (const SceneError& error : validate(other)) {
    check.add(kKey, fmt::format("{}: {}", error.key, error.message));
  }
  if (std::hypot(other.L - scene.L, other.H - scene.H) >
      kCloseToEnds * std::hypot(scene.L, scene.H)) {
    check.add(kKey, "both tracks have to end at the same point");
  }
}

void check_path(const Scene& scene, SceneChecker& check) {
  const GivenPath& path = *scene.path;
  using Shape = GivenPath::Shape;
  check.known("scene.path.curve", path.curve, GivenPath::Curve::Track);
  check.known("scene.path.shape", path.shape, Shape::Slopes);
  const bool of_track = path.curve == GivenPath::Curve::Track;
  if (of_track && scene.contact == Contact::Centre) {
    check.add("scene.path.curve",
              "track is not allowed with contact: centre, which says where the "
              "centre starts and ends, not the track");
  }
  if (path.start_angle) {
    check.angle("scene.path.start_angle", *path.start_angle);
    if (!path.has_start_angle()) {
      check.add("scene.path.start_angle",
                "only a parabola and a circular_arc leave the choice");
    }
  }
  if (path.shape == Shape::Slopes) check_slopes(scene, check);
  if (path.track_of) check_other(*path.track_of, scene, check);
  if (path.shape != Shape::Points) {
    if (!path.points.empty()) {
      check.add("scene.path.file", "only shape: points has points");
    }
    return;
  }
  if (!of_track && scene.contact == Contact::Smooth) {
    check.add(
        "scene.path.curve",
        "centre is not allowed for points with contact: smooth: they say "
        "themselves where the centre starts and ends; use contact: centre, "
        "or curve: track");
  }
  if (path.points.size() < 2) {
    check.add("scene.path.file", "a path needs two points or more");
    return;
  }
  for (const Point& point : path.points) {
    if (std::abs(point.x) <= kLargestQuantity &&
        std::abs(point.z) <= kLargestQuantity) {
      continue;
    }
    return check.add("scene.path.file",
                     fmt::format("the point ({:g}, {:g}) is not allowed: "
                                 "coordinates are at most {:g} m",
                                 point.x, point.z, kLargestQuantity));
  }
  // To the digits in which files hold points, of either coordinate: the time
  // may depend on H as much as on an L that is far larger.
  const auto apart = [&](const Point& p, double x, double z) {
    return !(std::abs(p.x - x) <= kCloseToEnds * scene.L &&
             std::abs(p.z - z) <= kCloseToEnds * scene.H);
  };
  const auto refuse = [&](const char* which, const Point& p, double x,
                          double z) {
    check.add(
        "scene.path.file",
        fmt::format("the {0} point is ({1:.9g}, {2:.9g}) and has to be "
                    "({3:.9g}, {4:.9g}), to {5:g} L in x and {5:g} H in z",
                    which, p.x, p.z, x, z, kCloseToEnds));
  };
  const Point& first = path.points.front();
  const Point& last = path.points.back();
  if (apart(first, 0.0, 0.0)) refuse("first", first, 0.0, 0.0);
  if (apart(last, scene.L, scene.H)) refuse("last", last, scene.L, scene.H);
}

}  // namespace

Scene with_implied_limits(Scene scene) {
  if (scene.world.losses.sliding > 0.0 && !scene.path &&
      !scene.limits.normal_min) {
    scene.limits.normal_min = 0.0;
  }
  return scene;
}

Scene without_whole_turns(const Scene& scene) {
  Scene reduced = scene;
  reduced.body.theta_m = math::within_a_turn(scene.body.theta_m);
  return reduced;
}

std::vector<SceneError> validate(const Scene& scene) {
  SceneChecker check;
  check.known("scene.body.shape", scene.body.shape, Shape::Ball);
  check.known("scene.contact", scene.contact, Contact::EndSlope);
  if (scene.body.rolls()) {
    check_rolling(as_stated(scene.body), check);
    if (scene.body.ball) check_ball(*scene.body.ball, check);
  } else {
    check_bead(scene.body, check);
  }
  if (scene.body.mass) {
    check.positive("scene.body.mass", *scene.body.mass, " kg",
                   "for it turns forces into newtons");
  }
  check.positive("scene.finish.L", scene.L, " m",
                 "for B lies to the right of A");
  check.positive("scene.finish.H", scene.H, " m",
                 "for B lies below A (z points down)");
  check.positive("scene.gravity", scene.gravity, " m/s²",
                 "for it is what moves the body");
  if (scene.path) check_path(scene, check);
  check_world(scene, check);
  check_limits(scene, check);
  return check.take();
}

}  // namespace brachisto
