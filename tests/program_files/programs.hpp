// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Programs of every kind to write down, and points where they are defined.

#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "derivatives/arc_length_problems.hpp"
#include "derivatives/problems.hpp"
#include "program_files/program_in_formulas.hpp"
#include "support/limited_problems.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {

struct ProgramCase {
  std::string name;
  std::function<std::unique_ptr<Transcription>()> make;
  std::function<std::vector<double>(const Transcription&, Random&)> point;
};

inline std::ostream& operator<<(std::ostream& out, const ProgramCase& row) {
  return out << row.name;
}

template <class Problem>
[[nodiscard]] ProgramCase program_case(
    std::string name, std::function<std::unique_ptr<Problem>()> make) {
  return {std::move(name), std::move(make),
          [](const Transcription& problem, Random& random) {
            return random_point(dynamic_cast<const Problem&>(problem), random);
          }};
}

/// All bodies and worlds in all three programs; a sphere's surface that points
/// lie on both sides of; limits of all kinds, with contacts that are fixed and
/// that are free.
[[nodiscard]] inline std::vector<ProgramCase> program_cases() {
  static constexpr int kDegree = 3;
  static constexpr int kElements = 3;
  static constexpr int kPieces = 9;
  std::vector<ProgramCase> cases;
  for (const ProblemCase& row : problem_cases(kDegree, kElements)) {
    cases.push_back(program_case<RollingTime>(row.name, [row] {
      return std::make_unique<RollingTime>(row.problem());
    }));
  }
  for (const auto& [name, body_scene] :
       {std::pair("Bead", bead_scene()),
        std::pair("OffCentred", off_centred_scene(0.4))}) {
    const Scene scene = natural(about_sphere(body_scene, in_the_way()));
    for (const bool held : {false, true}) {
      cases.push_back(program_case<RollingTime>(
          std::string(name) + (held ? "HeldToSides" : "OnBothSides"),
          [scene, held] {
            using enum FieldSide;
            auto problem = std::make_unique<RollingTime>(
                scene, uniform_mesh(kDegree, kElements), -0.2);
            if (held) problem->hold_sides({Outside, Inside, Outside});
            return problem;
          }));
    }
  }
  for (const ArcLengthCase& row : arc_length_cases()) {
    cases.push_back(program_case<ArcLength>("Pieces" + row.name, [row] {
      return std::make_unique<ArcLength>(row.scene, kPieces, -0.2);
    }));
  }
  for (const ArcLengthCase& row : arc_length_cases()) {
    for (const bool free : {false, true}) {
      if (free && !row.scene.body.rolls()) continue;
      cases.push_back(program_case<LimitedTime>(
          "Limited" + row.name + (free ? "FreeContacts" : ""), [row, free] {
            LimitedEnds ends;
            ends.free_contacts = free;
            ends.phi = -0.2;
            return std::make_unique<LimitedTime>(
                row.scene, limits_of_all_kinds(row.scene.body),
                graded_mesh(2, kElements), ends);
          }));
    }
  }
  // At rest in a field that depends on the place, pushed off through air, and
  // with losses.
  const Scene body = off_centred_scene(-kPi / 6.0);
  Scene braked = with_push(body, 1.0), bead = bead_scene();
  braked.world.losses.rolling = 0.05;
  bead.world.losses.sliding = 0.1;
  const std::pair<const char*, Scene> worlds[] = {
      {"WithRollingResistance", natural(braked)},
      {"WithSlidingFriction", natural(bead)},
      {"OnAPlanet", natural(about_sphere(body, below()))},
      {"PushedInAir", natural(in_air(with_push(body, 1.0), 0.3, 0.2))}};
  for (const auto& [name, scene] : worlds) {
    for (const bool free : {false, true}) {
      if (free && !scene.body.rolls()) continue;
      cases.push_back(program_case<LimitedTime>(
          std::string("Limited") + name + (free ? "FreeContacts" : ""),
          [scene, free] {
            LimitedEnds ends;
            ends.free_contacts = free;
            ends.phi = -0.2;
            return std::make_unique<LimitedTime>(
                scene, limits_of_all_kinds(scene.body),
                graded_mesh(2, kElements), ends);
          }));
    }
  }
  return cases;
}

/// A number computed twice by the same formula, the operations in another
/// order: sums over p + 1 nodes of products of half a dozen factors, each of
/// which was rounded. `size` is that of the largest of their like, whose terms
/// cancel in others.
[[nodiscard]] inline double rounding_of(int degree, double size) {
  constexpr double kFactors = 16.0;
  return ulps(kFactors * (degree + 1), 1.0 + size);
}

}  // namespace brachisto::testing
