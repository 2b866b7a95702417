// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solution.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <new>
#include <optional>

#include "math/cpu_clock.hpp"
#include "paper/discrete_variations.hpp"
#include "paper/newton_steps.hpp"
#include "solvers/square_system.hpp"

namespace brachisto {

namespace {

DiscreteReading reading_of(const DiscreteSystem& options) {
  DiscreteReading reading = options.reading;
  if (options.solver != DiscreteSolver::Hybrid) reading.epsilon = 0.0;
  return reading;
}

/// Runs the solver that the options name; fills in what it costs.
SquareResult run(const DiscreteVariations& system, DiscreteSolver solver,
                 std::vector<double> start, const SquareOptions& square,
                 DiscreteAnswer& out) {
  const SquareResidual residual = [&](std::span<const double> x,
                                      std::span<double> values) {
    return system.residual(x, values);
  };
  switch (solver) {
    case DiscreteSolver::Hybrid:
      out.memory_bytes = hybrid_memory_bytes(out.unknowns);
      return solve_by_hybrid(residual, std::move(start), square);
    case DiscreteSolver::Newton: {
      const paper::DenseNewtonStep step(system);
      out.memory_bytes = paper::DenseNewtonStep::memory_bytes(out.nodes);
      return solve_by_damped_newton(residual, step, std::move(start), square);
    }
    case DiscreteSolver::Lifted: {
      paper::LiftedNewtonStep step(system);
      out.unknowns = paper::LiftedNewtonStep::num_unknowns(out.nodes);
      SquareResult result = solve_by_damped_newton(residual, std::ref(step),
                                                   std::move(start), square);
      out.memory_bytes = step.memory_bytes();
      return result;
    }
  }
  return {};
}

void describe_path(const DiscreteVariations& system, const Scene& scene,
                   const std::vector<double>& unknowns, DiscreteAnswer& out) {
  const auto n = static_cast<std::size_t>(system.num_nodes());
  const double length = scene.H;
  out.tau = system.tau(unknowns);
  out.transit_time = out.tau * std::sqrt(length / (2.0 * scene.gravity));
  out.centre_path_length = unknowns[2 * n] * length;
  for (std::size_t j = 0; j < n; ++j) {
    out.centre.push_back({unknowns[j] * length, unknowns[n + j] * length});
  }
  const auto slope = [&](std::size_t j) {
    return std::atan2(out.centre[j + 1].z - out.centre[j].z,
                      out.centre[j + 1].x - out.centre[j].x);
  };
  out.start_angle = slope(0);
  out.end_angle = slope(n - 2);
}

}  // namespace

DiscreteAnswer solve_discrete_system(const Scene& scene,
                                     const DiscreteSystem& options,
                                     int max_iterations,
                                     const StopCondition& stop) {
  const DiscreteVariations system(scene, options.nodes, reading_of(options));
  DiscreteAnswer out;
  out.nodes = options.nodes;
  out.unknowns = system.num_unknowns();
  out.residual = std::numeric_limits<double>::quiet_NaN();
  std::optional<std::vector<double>> start = system.cycloid_guess();
  if (!start) {
    out.status = scene.body.off_centred() ? Status::NotReached
                                          : Status::NoAdmissiblePath;
    out.message =
        "B lies inside the uniform cylinder at its start: there is no cycloid "
        "to start from";
    return out;
  }
  const double begin = process_cpu_seconds();
  try {
    const SquareResult result =
        run(system, options.solver, std::move(*start),
            {options.tolerance, max_iterations, stop}, out);
    out.status = result.status;
    out.message = result.message;
    out.iterations = result.iterations;
    out.evaluations = result.evaluations;
    out.jacobians = result.jacobians;
    out.refused_points = result.refused_points;
    out.residual = result.residual;
    if (out.solved()) {
      describe_path(system, scene, result.x, out);
    } else if (!result.first_refused.empty()) {
      out.message += ". Points were refused; at the first of them " +
                     system.refusal(result.first_refused);
    }
  } catch (const std::bad_alloc&) {
    out.status = Status::OutOfMemory;
    out.message = "a matrix of this size does not fit into memory";
  }
  out.cpu_seconds = process_cpu_seconds() - begin;
  return out;
}

}  // namespace brachisto
