// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What goes into shooting and comes out of it, for each set of instructions.

#pragma once

#include <array>
#include <cstddef>

#include "lanes/lane.hpp"
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
using Targets = std::array<Target, kLanes>;
using Extremals = std::array<Extremal, kLanes>;
using Landings = std::array<Landing, kLanes>;
using Responses = std::array<Response, kLanes>;

/// The first so many of eight scenes with one set of instructions. Its
/// functions are not inline: those who call them must not compile them too.
template <Instructions Set, std::size_t Count, Surroundings In>
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
