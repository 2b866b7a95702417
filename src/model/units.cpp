// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/units.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto {

Units natural_units(const Scene& scene) {
  const double length = std::max(scene.L, scene.H);
  return {length, std::sqrt(length / (2.0 * scene.gravity))};
}

Scene in_natural_units(const Scene& scene) {
  const double length = natural_units(scene).length;
  Scene natural = scene;
  natural.body.radius /= length;
  natural.L /= length;
  natural.H /= length;
  natural.gravity = 0.5;
  return natural;
}

}  // namespace brachisto
