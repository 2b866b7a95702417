// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/findings.hpp"

#include <cmath>
#include <numbers>

#include "reproduction/transit.hpp"

namespace brachisto::reproduction {

namespace {

constexpr double kPi = std::numbers::pi;

double tau_on_mesh(const Scene& scene, int degree, int nodes) {
  SolveOptions options;
  options.discretisation.degree = degree;
  options.discretisation.nodes = nodes;
  const Solution solution = solve(scene, options);
  if (!solution.verified()) {
    throw NotVerified("the grid study has no verified answer: " +
                      solution.message);
  }
  return solution.motion()->tau();
}

std::vector<GridRow> grid_study(const Scene& scene) {
  std::vector<GridRow> rows;
  for (const int n : {25, 50, 100, 200}) {
    rows.push_back({n, tau_on_mesh(scene, 1, n), tau_on_mesh(scene, 5, n + 1)});
  }
  return rows;
}

std::vector<OrientationRow> fastest_orientations(Scene scene) {
  std::vector<OrientationRow> rows;
  double guess = -kPi / 6.0;
  const double largest = std::sqrt(1.0 - scene.body.k);
  constexpr int kSteps = 14;
  for (int i = 1; i <= kSteps; ++i) {
    scene.body.eta_m = largest * i / kSteps;
    rows.push_back({scene.body.eta_m, fastest_orientation(scene, guess)});
    guess = rows.back().fastest.theta_m.value;
  }
  return rows;
}

std::vector<double> offsets(int steps, double largest) {
  std::vector<double> eta;
  for (int i = 0; i <= steps; ++i) eta.push_back(largest * i / steps);
  return eta;
}

std::vector<RadiusRow> uniform_of_radius(Scene scene) {
  std::vector<RadiusRow> rows;
  for (const double radius : {0.5, 1.0 / 3.0, 0.2, 0.1, 0.01, 0.001}) {
    scene.body.radius = radius;
    rows.push_back({radius, verified_tau(scene)});
  }
  return rows;
}

double bead_between_ends(const Motion& motion) {
  const Point start = motion.at(0.0).centre;
  const Point end = motion.at(1.0).centre;
  Scene scene;
  scene.body = Body::bead();
  scene.L = end.x - start.x;
  scene.H = end.z - start.z;
  scene.gravity = motion.scene().gravity;
  // τ refers to the H of the other scene.
  return verified_tau(scene) * std::sqrt(scene.H / motion.scene().H);
}

}  // namespace

Findings find_all(const std::filesystem::path& directory, const Hooks& hooks) {
  const auto next = [&](const std::string& what) {
    if (hooks.interrupt->load() != 0) throw Interrupted();
    hooks.announce(what);
  };
  next("cases");
  Findings out{.cases = Cases(directory, *hooks.interrupt, hooks.announce),
               .map = {},
               .grid = {},
               .orientations = {},
               .boundary = {},
               .best_boundary = {},
               .uniform = {},
               .bead_between_centres = 0.0};
  next("grid study");
  const Scene& reference = out.cases["fig04_reference_case"].scene();
  out.grid = grid_study(reference);
  next("uniform cylinders");
  out.uniform = uniform_of_radius(out.cases["fig06_uniform_cylinder"].scene());
  const Case& fast = out.cases["fig13_faster_than_bead"];
  out.bead_between_centres = bead_between_ends(fast.motion());
  next("fastest orientations");
  out.orientations = fastest_orientations(reference);
  next("bodies as fast as the bead");
  constexpr double kLargestOffset = 0.95;
  out.boundary =
      bead_boundary(fast.scene(), offsets(19, kLargestOffset), false);
  next("the same, put down best");
  out.best_boundary =
      bead_boundary(fast.scene(), offsets(10, kLargestOffset), true);
  next("map of transit times");
  out.map = solve_family(directory / "sweeps" / "fig13_map.yaml", hooks.jobs,
                         *hooks.interrupt, hooks.progress);
  next("figures");
  return out;
}

}  // namespace brachisto::reproduction
