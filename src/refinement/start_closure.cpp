// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/start_closure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "model/start_angle.hpp"

namespace brachisto {

MeshSolution close_start(RollingTime& problem, const MeshStart& start,
                         const MeshOptions& options,
                         const SolveFromStart& solve, double tolerance) {
  if (!slope_at_A_is_open(problem.scene())) return solve(start);
  MeshSolution solution;
  MeshStart from = start;
  bool begun = false;
  const auto slope_at_A = [&](double alpha) -> std::optional<double> {
    problem.set_start_slope(alpha);
    MeshSolution pass =
        begun ? stay_on_mesh(problem, from, options) : solve(from);
    if (begun) {
      pass.polish.newton_steps += solution.polish.newton_steps;
      pass.tangency.passes = solution.tangency.passes + 1;
      pass.first_iterations = solution.first_iterations;
      pass.iterations = solution.iterations;
      pass.linear_solver = solution.linear_solver;
      pass.log = std::move(solution.log);
      if (pass.solved()) pass.message = std::move(solution.message);
    }
    begun = true;
    solution = std::move(pass);
    if (!solution.solved()) return std::nullopt;
    from = {solution.point, solution.tangency.phi, solution.tangency.slope};
    return ExtremalCurve(problem, solution.point).at(0.0).beta;
  };
  TangencyOptions closure;
  closure.tolerance = tolerance;
  const Tangency at_A =
      close_contact(slope_at_A, start_angle(problem.scene()), closure);
  if (solution.solved() && !at_A.closed) {
    solution.status = Status::NotConverged;
    solution.message = fmt::format(
        "no slope α at A reproduces itself: |β_start(α) − α| = {:.2e} at α = "
        "{:.6g} rad after {} passes",
        std::abs(at_A.mismatch), at_A.phi, at_A.passes);
  }
  return solution;
}

double time_per_start_slope(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  if (!slope_at_A_is_open(scene)) return 0.0;
  const ExtremalPoint start = curve.at(0.0);
  const double alpha = start_angle(scene);
  const double root = root_of_inertia(scene.body, start.theta, alpha);
  const double d_root = scene.body.eta_m * std::cos(start.theta - alpha) / root;
  const double r = scene.contact == Contact::Centre ? 0.0 : scene.body.radius;
  return r * (start.p.p_x * std::cos(alpha) + start.p.p_z * std::sin(alpha)) +
         start.p.p_w * scene.world.start_speed * d_root;
}

}  // namespace brachisto
