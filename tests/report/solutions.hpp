// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Solutions to report on, each found once per process.

#pragma once

#include <numbers>

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
/// From place to place of a motion.
[[nodiscard]] inline ActiveArc arc_between(const Motion& motion, double from,
                                           double to) {
  const TrajectoryPoint a = motion.at(from);
  const TrajectoryPoint b = motion.at(to);
  return {{a.sigma, b.sigma},
          {a.u, b.u},
          {a.t, b.t},
          {a.motion.contact.x, b.motion.contact.x}};
}
/// What is told of limits, by hand: the free solution with two that are said to
/// hold, one of them twice and once together with the other, and one that has
/// no bound.
[[nodiscard]] inline const Solution& limited_solution() {
  static const Solution kSolution = [] {
    Solution solution = off_centred_solution();
    const Motion& motion = *solution.motion();
    PathLimits& limits = solution.scene.limits;
    limits.friction = 0.5;
    limits.normal_max = 5.0;
    limits.half_planes = {{{4.0, 0.0}, std::numbers::pi}};
    solution.limits = {{.name = "friction",
                        .bound = 0.5,
                        .active = {arc_between(motion, 0.125, 0.25),
                                   arc_between(motion, 0.5, 0.75)},
                        .least_slack = 0.0,
                        .share_of_time = 0.375,
                        .price = -0.0625,
                        .price_at_fixed_contacts = -0.15625},
                       {.name = "normal_force.max",
                        .bound = 5.0,
                        .active = {arc_between(motion, 0.6875, 0.8125)},
                        .least_slack = 0.0,
                        .share_of_time = 0.0625,
                        .price = {},
                        .price_at_fixed_contacts = -0.03125},
                       {.name = "clear_of.half_plane",
                        .bound = {},
                        .active = {},
                        .least_slack = 0.71875,
                        .share_of_time = 0.0,
                        .price = 0.0,
                        .price_at_fixed_contacts = 0.0}};
    return solution;
  }();
  return kSolution;
}
/// The same free solution with derivatives by hand, but by k, as if its body
/// had none.
[[nodiscard]] inline const Solution& differentiated_solution() {
  static const Solution kSolution = [] {
    Solution solution = off_centred_solution();
    solution.options.use<Collocation>().sensitivities = SensitivityOrder::First;
    Sensitivities& all = solution.sensitivities.emplace();
    double tau = 0.0;
    for (TimeDerivatives& by : all.by) {
      tau += 1.0;
      by = {tau, 0.25 * tau, 0.5 * tau, 0.125 * tau};
    }
    all.by[SceneParameter::K] = {};
    all.by_offset = {all.by[SceneParameter::EtaM],
                     all.by[SceneParameter::ThetaM]};
    return solution;
  }();
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
