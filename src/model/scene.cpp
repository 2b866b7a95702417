// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/model/mass_distribution.hpp"

namespace brachisto {

namespace {

/// Collects violations; each check says the value, the bound and the reason.
class Checker {
 public:
  bool finite(const char* key, double value) {
    if (std::isfinite(value)) return true;
    add(key, fmt::format("{} is not a finite number", value));
    return false;
  }
  void positive(const char* key, double value, const char* unit,
                const char* reason) {
    if (!finite(key, value) || value > 0.0) return;
    add(key, fmt::format("{}{} is not allowed: it must be > 0, {}", value, unit,
                         reason));
  }
  void add(std::string key, std::string message) {
    errors_.push_back({std::move(key), std::move(message)});
  }
  [[nodiscard]] std::vector<SceneError> take() { return std::move(errors_); }

 private:
  std::vector<SceneError> errors_;
};

void check_bead(const Body& body, Checker& check) {
  const auto absent = [&](const char* key, double value) {
    if (value == 0.0) return;
    check.add(key, "a bead is a point mass and has no such property");
  };
  absent("scene.body.radius", body.radius);
  absent("scene.body.eta_m", body.eta_m);
  absent("scene.body.theta_m", body.theta_m);
  absent("scene.body.k", body.k);
}

void check_cylinder(const Body& body, Checker& check) {
  check.positive("scene.body.radius", body.radius, " m",
                 "for the radius of a cylinder is a length");
  check.finite("scene.body.theta_m", body.theta_m);
  const double eta = body.eta_m;
  if (check.finite("scene.body.eta_m", eta)) {
    if (eta < 0.0 || eta > 1.0) {
      check.add("scene.body.eta_m",
                fmt::format("{} is not allowed: 0 ≤ η_m ≤ 1, for the centre of "
                            "mass lies inside the cylinder",
                            eta));
    } else if (eta == 1.0) {
      check.add("scene.body.eta_m",
                "1 is not allowed: all mass would sit in one point of the rim "
                "(k = 0), whose speed, and with it the inertia factor A, "
                "vanishes whenever that point touches the track");
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

void check_path(const Scene& scene, Checker& check) {
  const GivenPath& path = *scene.path;
  using Shape = GivenPath::Shape;
  const bool of_track = path.curve == GivenPath::Curve::Track;
  if (of_track && scene.contact == Contact::Centre) {
    check.add("scene.path.curve",
              "track is not allowed with contact: centre, which says where the "
              "centre starts and ends, not the track");
  }
  if (path.start_angle) {
    check.finite("scene.path.start_angle", *path.start_angle);
    if (!path.has_start_angle()) {
      check.add("scene.path.start_angle",
                "only a parabola and a circular_arc leave the choice");
    }
  }
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
  // To the digits in which files hold points.
  constexpr double kClose = 1e-6;
  const auto apart = [&](const Point& p, double x, double z) {
    return std::hypot(p.x - x, p.z - z) > kClose * std::max(scene.L, scene.H);
  };
  if (apart(path.points.front(), 0.0, 0.0)) {
    check.add("scene.path.file", "the first point has to be A = (0, 0)");
  }
  if (apart(path.points.back(), scene.L, scene.H)) {
    check.add("scene.path.file",
              fmt::format("the last point has to be B = ({:g}, {:g})", scene.L,
                          scene.H));
  }
}

}  // namespace

std::vector<SceneError> validate(const Scene& scene) {
  Checker check;
  if (scene.body.rolls()) {
    check_cylinder(scene.body, check);
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
  return check.take();
}

}  // namespace brachisto
