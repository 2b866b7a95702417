// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fsolve/rolling.hpp"

#include <algorithm>
#include <cmath>

#include "fsolve/mean_time.hpp"

namespace brachisto::benchmarks {

RollingRun time_rolling(const Scene& scene, const SolveOptions& options,
                        double exact_tau) {
  std::optional<Solution> solution;
  const MeanTime time = mean_time([&] {
    solution.emplace(solve(scene, options));
    return solution->effort.cpu_seconds;
  });
  RollingRun run;
  run.method = options.method;
  run.cpu_seconds = time.seconds;
  run.repetitions = time.repetitions;
  run.solved = solution->status == Status::Solved && solution->trajectory;
  if (run.solved) {
    const Mesh& mesh = solution->trajectory->curve().mesh();
    run.degree = mesh.degree;
    run.elements = mesh.num_elements();
    run.nodes = mesh.num_nodes();
    run.error = std::abs(solution->motion()->tau() / exact_tau - 1.0);
  }
  return run;
}

SolveOptions on_mesh(Method method, int degree, int elements) {
  SolveOptions options;
  options.method = method;
  options.discretisation.degree = degree;
  options.discretisation.elements = elements;
  return options;
}

std::vector<RollingRun> rolling_menu(const Scene& scene, double exact_tau) {
  std::vector<RollingRun> menu;
  for (const Method method : {Method::Ipopt, Method::NewtonKkt}) {
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree) {
      for (const int elements :
           {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 64, 100}) {
        RollingRun run =
            time_rolling(scene, on_mesh(method, degree, elements), exact_tau);
        // Also of what was not solved.
        run.degree = degree;
        run.elements = elements;
        menu.push_back(run);
      }
    }
  }
  return menu;
}

std::optional<RollingRun> cheapest(std::span<const RollingRun> menu,
                                   double error) {
  const auto accurate = [&](const RollingRun& run) {
    return run.solved && run.error <= error;
  };
  const auto certain = [&](const RollingRun& run) {
    return std::ranges::all_of(menu, [&](const RollingRun& other) {
      const bool refinement = other.method == run.method &&
                              other.degree == run.degree &&
                              other.elements >= run.elements;
      return !refinement || accurate(other);
    });
  };
  std::optional<RollingRun> best;
  for (const RollingRun& run : menu) {
    if (certain(run) && (!best || run.cpu_seconds < best->cpu_seconds)) {
      best = run;
    }
  }
  return best;
}

}  // namespace brachisto::benchmarks
