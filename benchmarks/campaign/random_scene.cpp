// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "campaign/random_scene.hpp"

#include <cmath>

#include "math/portable_random.hpp"

namespace brachisto::benchmarks {

Scene random_scene(std::uint64_t seed, int index, double largest_angle) {
  // The stream of a scene starts at a scrambled state of its own.
  SplitMix64 streams(seed);
  SplitMix64 random(streams.next() ^
                    SplitMix64(static_cast<std::uint64_t>(index)).next());
  Scene scene;
  scene.H = 1.0;
  scene.L = random.uniform(0.8, 8.0);
  const double r = random.uniform(0.05, 0.6);
  const double k = random.uniform(0.02, 0.95);
  const double eta = random.uniform(0.0, std::sqrt(1.0 - k));
  const double theta_m = random.uniform(-largest_angle, largest_angle);
  scene.body = Body::cylinder(r, eta, theta_m, k);
  return scene;
}

}  // namespace brachisto::benchmarks
