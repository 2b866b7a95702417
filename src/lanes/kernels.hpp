// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What goes into shooting and comes out of it, for each set of instructions.

#pragma once

#include <array>
#include <cstddef>

#include "lanes/many_scenes.hpp"

namespace brachisto::lanes {

/// The most steps on the way to a scene that there is room for.
inline constexpr int kMostOnTheWay = kFine.offsets + kFine.into_world;

/// What takes part in the rates of bodies, beside their fall in the uniform
/// field from rest or pushed.
struct Surroundings {
  bool air = false, field = false;
};

/// A scene as shooting has it, in natural units.
struct Milestone {
  double eta_m = 0.0, theta_m = 0.0, k = 0.0;
  double contact_radius = 0.0;  ///< by which the centre is off the track
  double rotation_per_length = 0.0;
  double L = 0.0, H = 0.0;
  double start_angle = 0.0;  ///< from rest
  double start_speed = 0.0;
  Air air;
  // Of a field in place of the uniform one, and how much of it there is.
  double body_radius = 0.0;
  Sphere sphere;
  double field_share = 1.0;
};
/// What is shot for, from one that is known.
struct Target {
  std::array<Milestone, kMostOnTheWay + 1> way;
  int steps = 0;  ///< of the way, as many for all that are shot together
  /// Of the extremal before the first step.
  std::array<double, Extremal::kUnknowns> unknowns{};
  double sign = 0.0;  ///< see Extremal; 0: that of the first step
  /// Whose law the field has, the same for all that are shot together.
  FieldSide side = FieldSide::Outside;
};

/// Numbers in a register of a set of instructions: with more at once they do
/// not fit into all of its registers, and every second one is read and written
/// in memory.
[[nodiscard]] constexpr std::size_t lanes_of(Instructions set) {
  return set == Instructions::Avx512 ? 8 : set == Instructions::Avx2 ? 4 : 2;
}
inline constexpr std::size_t kMostLanes = lanes_of(Instructions::Avx512);

using Targets = std::array<Target, kMostLanes>;
using Extremals = std::array<Extremal, kMostLanes>;
using Landings = std::array<Landing, kMostLanes>;
using Responses = std::array<Response, kMostLanes>;

/// The first scenes with one set of instructions, as many as it has lanes. Its
/// functions are not inline: those who call them must not compile them too.
template <Instructions Set, Surroundings In>
struct Kernel {
  static void shoot(const Targets& targets, const Fineness& fineness,
                    Extremals& out);
  /// With nothing sought.
  static void land(const Targets& targets, const Fineness& fineness,
                   Landings& out);
  static void respond(const Targets& targets, const Fineness& fineness,
                      Responses& out);
};

}  // namespace brachisto::lanes
