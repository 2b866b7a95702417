// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random scenes in other worlds.

#pragma once

#include <cstdint>
#include <string>

#include "brachisto/model/scene.hpp"

namespace brachisto::benchmarks {

/// Scene number `index` of a campaign (random_scene(), with L below 4) with one
/// or more of: a start speed up to 3 m/s; linear drag up to 0.2/s and quadratic
/// drag up to 0.1/m; the field of a sphere, of g at A, whose centre is 6 m to
/// 30 m away and up to 0.4 rad off the vertical, with A inside or outside and B
/// lower in potential. Drag may keep the body from reaching B all the same.
[[nodiscard]] Scene random_world_scene(std::uint64_t seed, int index);

/// "speed 1.2, sphere outside".
[[nodiscard]] std::string described_world(const Scene& scene);

}  // namespace brachisto::benchmarks
