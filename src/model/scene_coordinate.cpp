// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/scene_coordinate.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto {

bool has_coordinate(const Scene& scene, SceneCoordinate coordinate) {
  return scene.body.rolls() || coordinate == SceneCoordinate::L ||
         coordinate == SceneCoordinate::H;
}

Scene moved(const Scene& scene, SceneCoordinate coordinate, double by) {
  Scene out = scene;
  Body body = as_stated(scene.body);
  const auto move_offset = [&](double x, double z) {
    const double offset_x = body.eta_m * std::cos(body.theta_m) + x;
    const double offset_z = body.eta_m * std::sin(body.theta_m) + z;
    body.eta_m = std::max(std::hypot(offset_x, offset_z), kSmallestQuantity);
    body.theta_m = std::atan2(offset_z, offset_x);
  };
  switch (coordinate) {
    case SceneCoordinate::OffsetX:
      move_offset(by, 0.0);
      break;
    case SceneCoordinate::OffsetZ:
      move_offset(0.0, by);
      break;
    case SceneCoordinate::K:
      body.k += by;
      break;
    case SceneCoordinate::Radius:
      body.radius += by;
      break;
    case SceneCoordinate::L:
      out.L += by;
      break;
    case SceneCoordinate::H:
      out.H += by;
      break;
  }
  out.body = as_it_rolls(body);
  return out;
}

double difference_step(const Scene& scene, SceneCoordinate coordinate) {
  constexpr double kStep = 2e-3;
  const Body& body = scene.body;
  switch (coordinate) {
    case SceneCoordinate::OffsetX:
    case SceneCoordinate::OffsetZ:
    case SceneCoordinate::K:
      return kStep *
             std::min(1.0, (1.0 - body.eta_m) * (1.0 - body.eta_m) + body.k);
    case SceneCoordinate::Radius:
      return kStep * body.radius;
    case SceneCoordinate::L:
      return kStep * scene.L;
    case SceneCoordinate::H:
      return kStep * scene.H;
  }
  return kStep;
}

Scene with_rotation(Scene scene) {
  if (scene.body.rolls() && scene.body.eta_m == 0.0) {
    Body body = as_stated(scene.body);
    body.eta_m = kSmallestQuantity;
    scene.body = as_it_rolls(body);
  }
  return scene;
}

Scene between(const Scene& from, const Scene& to, double share) {
  Scene scene = to;
  scene.L = std::lerp(from.L, to.L, share);
  scene.H = std::lerp(from.H, to.H, share);
  const auto mix = [&](double Body::*number) {
    scene.body.*number = std::lerp(from.body.*number, to.body.*number, share);
  };
  for (const auto number :
       {&Body::radius, &Body::eta_m, &Body::theta_m, &Body::k}) {
    mix(number);
  }
  return scene;
}

}  // namespace brachisto
