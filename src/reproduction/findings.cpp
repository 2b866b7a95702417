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

PaperEquations solve_paper_equations(const Scene& scene, int nodes) {
  using Datum = DiscreteReading::Datum;
  const auto tau = [&](Datum datum) -> std::optional<double> {
    FsolveOptions options;
    options.variant = FsolveVariant::Lifted;
    options.reading.datum = datum;
    const FsolveAnswer answer = fsolve_answer(scene, nodes, options);
    if (!answer.solved()) return std::nullopt;
    return answer.tau;
  };
  return {tau(Datum::Rest), tau(Datum::Release)};
}

std::vector<GridRow> grid_study(const Scene& scene) {
  std::vector<GridRow> rows;
  for (const int n : {25, 50, 100, 200}) {
    rows.push_back({n, tau_on_mesh(scene, 1, n), tau_on_mesh(scene, 5, n + 1),
                    solve_paper_equations(scene, n)});
  }
  return rows;
}

std::vector<OrientationRow> fastest_orientations(Scene scene,
                                                 const Interrupt& interrupt) {
  std::vector<OrientationRow> rows;
  double guess = -kPi / 6.0;
  const double largest = std::sqrt(1.0 - scene.body.k);
  constexpr int kSteps = 14;
  for (int i = 1; i <= kSteps; ++i) {
    scene.body.eta_m = largest * i / kSteps;
    rows.push_back(
        {scene.body.eta_m, fastest_orientation(scene, guess, interrupt)});
    guess = rows.back().fastest.theta_m.value;
  }
  return rows;
}

std::vector<double> offsets(int steps, double largest) {
  std::vector<double> eta;
  for (int i = 0; i <= steps; ++i) eta.push_back(largest * i / steps);
  return eta;
}

std::vector<RadiusRow> uniform_of_radius(Scene scene,
                                         const Interrupt& interrupt) {
  std::vector<RadiusRow> rows;
  for (const double radius : {0.5, 1.0 / 3.0, 0.2, 0.1, 0.01, 0.001}) {
    scene.body.radius = radius;
    rows.push_back({radius, verified_tau(scene, interrupt)});
  }
  return rows;
}

double bead_between_ends(const Motion& motion, const Interrupt& interrupt) {
  const Point start = motion.at(0.0).centre;
  const Point end = motion.at(1.0).centre;
  Scene scene;
  scene.body = Body::bead();
  scene.L = end.x - start.x;
  scene.H = end.z - start.z;
  scene.gravity = motion.scene().gravity;
  // τ refers to the H of the other scene.
  return verified_tau(scene, interrupt) * std::sqrt(scene.H / motion.scene().H);
}

/// What comparison, statements and figures refer to by name.
std::vector<std::string> needed_cases() {
  return {"check_uniform_half_arch",
          "fig03_incline",
          "fig04_circular_arc",
          "fig04_cycloid",
          "fig04_parabola",
          "fig04_reference_case",
          "fig04_straight",
          "fig06_bead",
          "fig06_uniform_cylinder",
          "fig08_eta_m_0",
          "fig08_eta_m_1_2",
          "fig08_eta_m_1_3",
          "fig08_eta_m_1_6",
          "fig08_eta_m_1_sqrt2",
          "fig09_theta_m_m30deg",
          "fig09_theta_m_m60deg",
          "fig09_theta_m_m90deg",
          "fig09_theta_m_p30deg",
          "fig09_theta_m_p60deg",
          "fig09_theta_m_p90deg",
          "fig10_k_0.1",
          "fig10_k_0.3",
          "fig10_k_5_9",
          "fig11_r_0.2",
          "fig11_r_0.25",
          "fig11_r_0.25_eta_m_1_3",
          "fig11_r_0.2_eta_m_1_3",
          "fig11_r_0.4",
          "fig11_r_0.4_eta_m_1_3",
          "fig11_r_0.5",
          "fig11_r_0.5_eta_m_1_3",
          "fig11_r_1_3_eta_m_1_3",
          "fig12_L_2",
          "fig12_L_4",
          "fig13_faster_than_bead"};
}

}  // namespace

Findings find_all(const std::filesystem::path& directory, const Hooks& hooks) {
  const Interrupt& interrupt = *hooks.interrupt;
  // What is wrong with it is told before the work begins.
  const sweep::Job map =
      sweep::read_job(directory / "sweeps" / "fig13_map.yaml", {});
  Findings out{
      .cases = Cases(directory, needed_cases(), interrupt, hooks.announce),
      .map = {},
      .grid = {},
      .equations = {},
      .orientations = {},
      .boundary = {},
      .best_boundary = {},
      .uniform = {},
      .bead_between_centres = 0.0};
  const Scene& reference = out.cases["fig04_reference_case"].scene();
  const Case& fast = out.cases["fig13_faster_than_bead"];
  hooks.announce("grid study");
  out.grid = grid_study(reference);
  constexpr int kNodes = 100;
  for (const char* name :
       {"fig06_uniform_cylinder", "fig04_reference_case", "fig12_L_2",
        "fig12_L_4", "fig13_faster_than_bead"}) {
    out.equations[name] =
        solve_paper_equations(out.cases[name].scene(), kNodes);
  }
  hooks.announce("uniform cylinders");
  out.uniform =
      uniform_of_radius(out.cases["fig06_uniform_cylinder"].scene(), interrupt);
  out.bead_between_centres = bead_between_ends(fast.motion(), interrupt);
  hooks.announce("fastest orientations");
  out.orientations = fastest_orientations(reference, interrupt);
  hooks.announce("bodies as fast as the bead");
  constexpr int kSteps = 20;
  const std::vector<double> eta_m = offsets(kSteps, 1.0 - 1.0 / kSteps);
  out.boundary = bead_boundary(fast.scene(), eta_m, false, interrupt);
  hooks.announce("the same, put down best");
  out.best_boundary = bead_boundary(fast.scene(), eta_m, true, interrupt);
  hooks.announce("map of transit times");
  out.map = solve_family(map, hooks.jobs, interrupt, hooks.progress);
  hooks.announce("figures");
  return out;
}

}  // namespace brachisto::reproduction
