// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fsolve/rolling.hpp"

#include <algorithm>
#include <cmath>

#include "fsolve/mean_time.hpp"
#include "math/cpu_clock.hpp"
#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "refinement/mesh_solve.hpp"
#include "study/answer_kinds.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto::benchmarks {

namespace {

/// τ on a uniform mesh; nothing if the solver fails.
std::optional<double> solve_on(const Scene& scene, const CycloidArc& arc,
                               const Mesh& mesh, ProgramSolver method) {
  const double phi = arc.slope_angle(arc.psi_end);
  RollingTime problem(in_natural_units(scene), mesh, phi);
  MeshOptions options;
  options.newton_alone = method == ProgramSolver::NewtonKkt;
  // Newton's method needs multipliers, which the cycloid has as the extremal of
  // the axisymmetric body; Ipopt estimates its own.
  const PrimalDual start = options.newton_alone ? cycloid_extremal(problem, arc)
                                                : cycloid_guess(problem, arc);
  const MeshSolution found =
      solve_on_mesh(problem, {start, phi, -1.0}, options);
  if (!found.solved()) return std::nullopt;
  const ExtremalCurve curve(problem, found.point);
  return Trajectory(curve, scene, natural_units(scene)).tau();
}

RollingRun time_on_mesh(const Scene& scene, const Mesh& mesh,
                        ProgramSolver method, double exact_tau) {
  std::optional<double> tau;
  const MeanTime time = mean_time([&] {
    const double begin = process_cpu_seconds();
    const auto arc = axisymmetric_optimum(in_natural_units(scene));
    tau = solve_on(scene, *arc, mesh, method);
    return process_cpu_seconds() - begin;
  });
  return {.way = {Work::OnMesh, method},
          .degree = mesh.degree,
          .elements = mesh.num_elements(),
          .nodes = mesh.num_nodes(),
          .solved = tau.has_value(),
          .error = tau ? std::abs(*tau / exact_tau - 1.0) : 0.0,
          .cpu_seconds = time.seconds,
          .repetitions = time.repetitions};
}

}  // namespace

std::string name(const Way& way) {
  return std::string(way.work == Work::OnMesh ? "on the mesh" : "whole solve") +
         (way.method == ProgramSolver::Ipopt ? ", Ipopt" : ", Newton");
}

RollingRun time_whole(const Scene& scene, const SolveOptions& options,
                      double exact_tau) {
  std::optional<Solution> solution;
  const MeanTime time = mean_time([&] {
    solution.emplace(solve(scene, options));
    return solution->effort.cpu_seconds;
  });
  RollingRun run;
  run.way = {Work::Whole, options.or_default<Collocation>().solver};
  run.cpu_seconds = time.seconds;
  run.repetitions = time.repetitions;
  run.solved = solution->status == Status::Solved && trajectory_of(*solution);
  if (run.solved) {
    const Mesh& mesh = trajectory_of(*solution)->curve().mesh();
    run.degree = mesh.degree;
    run.elements = mesh.num_elements();
    run.nodes = mesh.num_nodes();
    run.error = std::abs(solution->motion()->tau() / exact_tau - 1.0);
  }
  return run;
}

SolveOptions on_mesh(ProgramSolver method, int degree, int elements) {
  SolveOptions options;
  auto& program = options.use<Collocation>();
  program.solver = method;
  program.discretisation.degree = degree;
  program.discretisation.elements = elements;
  return options;
}

std::vector<RollingRun> rolling_menu(const Scene& scene, double exact_tau) {
  std::vector<RollingRun> menu;
  for (const ProgramSolver method :
       {ProgramSolver::Ipopt, ProgramSolver::NewtonKkt}) {
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree) {
      for (const int elements :
           {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 64}) {
        menu.push_back(time_on_mesh(scene, uniform_mesh(degree, elements),
                                    method, exact_tau));
      }
      // Most of it is the same whatever the mesh.
      for (const int elements : {2, 4, 8, 16, 32}) {
        RollingRun whole =
            time_whole(scene, on_mesh(method, degree, elements), exact_tau);
        // Also of what was not solved.
        whole.degree = degree;
        whole.elements = elements;
        menu.push_back(whole);
      }
    }
  }
  return menu;
}

std::optional<RollingRun> cheapest(std::span<const RollingRun> menu, Work work,
                                   double error) {
  const auto accurate = [&](const RollingRun& run) {
    return run.solved && run.error <= error;
  };
  const auto certain = [&](const RollingRun& run) {
    return std::ranges::all_of(menu, [&](const RollingRun& other) {
      const bool refinement = other.way == run.way &&
                              other.degree == run.degree &&
                              other.elements >= run.elements;
      return !refinement || accurate(other);
    });
  };
  std::optional<RollingRun> best;
  for (const RollingRun& run : menu) {
    if (run.way.work == work && certain(run) &&
        (!best || run.cpu_seconds < best->cpu_seconds)) {
      best = run;
    }
  }
  return best;
}

}  // namespace brachisto::benchmarks
