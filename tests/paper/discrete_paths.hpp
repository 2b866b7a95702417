// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes, readings and points for tests of the paper's discrete system.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "paper/discrete_variations.hpp"
#include "support/random_points.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {

/// Of the paths of tests that solve nothing.
inline constexpr int kDiscreteNodes = 12;

struct DiscreteCase {
  std::string name;
  Scene scene;
  DiscreteReading reading;
};

/// Bodies, contacts and readings of every kind, with a start from rest.
[[nodiscard]] inline std::vector<DiscreteCase> discrete_cases() {
  using Quadrature = DiscreteReading::Quadrature;
  using Datum = DiscreteReading::Datum;
  using Slopes = DiscreteReading::Slopes;
  Scene between_centres = off_centred_scene(0.4);
  between_centres.contact = Contact::Centre;
  Scene large = off_centred_scene(-0.5);
  large.L *= 2.0;
  large.H *= 2.0;
  large.body.radius *= 2.0;
  return {
      {"release", off_centred_scene(), {}},
      {"rest", off_centred_scene(), {Quadrature::MeanSpeed, Datum::Rest}},
      {"midpoint", off_centred_scene(0.3), {Quadrature::Midpoint}},
      {"trapezoid", off_centred_scene(), {Quadrature::Trapezoid, Datum::Rest}},
      {"smooth",
       off_centred_scene(),
       {Quadrature::MeanSpeed, Datum::Release, Slopes::Smooth}},
      {"twice as large", large, {}},
      {"centre", between_centres, {}},
      {"uniform", uniform_scene(), {}},
      {"bead", bead_scene(), {}},
  };
}

/// The cycloid, shaken: no solution, but speeds are real. The first chord stays
/// steep enough for the weight to fall.
[[nodiscard]] inline std::vector<double> shaken(
    const DiscreteVariations& system, std::uint32_t seed) {
  constexpr double kShake = 5e-3;
  Random random(seed);
  std::vector<double> u = system.cycloid_guess().value();
  for (double& value : u) value += random.uniform(-kShake, kShake);
  return u;
}

}  // namespace brachisto::testing
