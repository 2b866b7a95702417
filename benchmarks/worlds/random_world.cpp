// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "worlds/random_world.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "campaign/random_scene.hpp"
#include "math/portable_random.hpp"
#include "model/field.hpp"

namespace brachisto::benchmarks {

Scene random_world_scene(std::uint64_t seed, int index) {
  // Another stream than that of the scene without a world.
  SplitMix64 streams(seed + 0x9e37);
  SplitMix64 random(streams.next() ^
                    SplitMix64(static_cast<std::uint64_t>(index)).next());
  Scene scene = random_scene(seed, index);
  scene.L = std::fmod(scene.L, 3.2) + 0.8;
  World& world = scene.world;
  // Of the seven choices of one or more.
  const auto kinds = static_cast<unsigned>(random.uniform(1.0, 8.0));
  if ((kinds & 1U) != 0) world.start_speed = random.uniform(0.1, 3.0);
  if ((kinds & 2U) != 0) {
    world.air = {random.uniform(0.0, 0.2), random.uniform(0.0, 0.1)};
  }
  if ((kinds & 4U) != 0) {
    // B has to lie lower in potential than A by a part of what it does in the
    // uniform field.
    constexpr double kPart = 0.3;
    do {
      const double distance = random.uniform(6.0, 30.0);
      const double tilt = random.uniform(-0.4, 0.4);
      const bool inside = random.uniform(0.0, 1.0) < 0.5;
      Sphere sphere{{distance * std::sin(tilt), distance * std::cos(tilt)},
                    inside ? distance + 2.0 * scene.L : 0.3 * distance,
                    scene.gravity};
      sphere.surface_gravity *= scene.gravity / sphere.strength_at({0.0, 0.0});
      world.sphere = sphere;
    } while (potential_fall(scene, {0.0, 0.0}, {scene.L, scene.H}) <
             kPart * scene.gravity * scene.H);
  }
  return scene;
}

std::string described_world(const Scene& scene) {
  const World& world = scene.world;
  std::vector<std::string> parts;
  if (world.start_speed > 0.0) {
    parts.push_back(fmt::format("speed {:.3g}", world.start_speed));
  }
  if (world.air.any()) {
    parts.push_back(fmt::format("air {:.3g} {:.3g}", world.air.linear,
                                world.air.quadratic));
  }
  if (world.sphere) {
    const Sphere& sphere = *world.sphere;
    const double distance = std::hypot(sphere.centre.x, sphere.centre.z);
    parts.push_back(fmt::format("{} a sphere at {:.3g}",
                                distance < sphere.radius ? "inside" : "outside",
                                distance));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace brachisto::benchmarks
