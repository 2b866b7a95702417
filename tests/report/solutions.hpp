// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Solutions to report on, each found once per process.

#pragma once

#include "brachisto/study/solve.hpp"
#include "support/reference_values.hpp"

namespace brachisto::testing {

[[nodiscard]] inline const Solution& off_centred_solution() {
  static const Solution kSolution = solve(reference("theta_-30").scene());
  return kSolution;
}
[[nodiscard]] inline const Solution& uniform_solution() {
  static const Solution kSolution = solve(reference("uniform_L3").scene());
  return kSolution;
}
[[nodiscard]] inline const Solution& bead_solution() {
  static const Solution kSolution = solve(reference("bead_L3").scene());
  return kSolution;
}
/// Solved, but not to the wanted tolerance.
[[nodiscard]] inline const Solution& unverified_solution() {
  static const Solution kSolution = [] {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = 2;
    mesh.elements = 8;
    mesh.tolerance = 1e-9;
    return solve(reference("reference_case").scene(), options);
  }();
  return kSolution;
}
/// Of the paper's discrete system.
[[nodiscard]] inline const Solution& discrete_solution() {
  static const Solution kSolution = [] {
    SolveOptions options;
    auto& system = options.use<DiscreteSystem>();
    system.solver = DiscreteSolver::Lifted;
    system.reading.datum = DiscreteReading::Datum::Rest;
    return solve(reference("reference_case").scene(), options);
  }();
  return kSolution;
}
/// Not solved at all.
[[nodiscard]] inline const Solution& impossible_solution() {
  static const Solution kSolution = [] {
    Scene scene = reference("uniform_L3").scene();
    scene.body.radius = 2.0;
    return solve(scene);
  }();
  return kSolution;
}

}  // namespace brachisto::testing
