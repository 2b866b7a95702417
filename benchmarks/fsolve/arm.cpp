// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fsolve/arm.hpp"

#include <functional>
#include <span>

#include "brachisto/study/solution.hpp"
#include "fsolve/mean_time.hpp"
#include "math/cpu_clock.hpp"
#include "paper/discrete_variations.hpp"
#include "paper/newton_steps.hpp"
#include "solvers/square_system.hpp"

namespace brachisto::benchmarks {

const char* name(Arm arm) {
  switch (arm) {
    case Arm::Octave:
      return "Octave";
    case Arm::SciPy:
      return "SciPy";
    case Arm::Hybrid:
      return "hybrid";
    case Arm::Newton:
      return "newton";
    case Arm::Lifted:
      return "lifted";
    case Arm::Simplified:
      return "simplified";
  }
  return "";
}

const char* name(DiscreteReading::Datum datum) {
  switch (datum) {
    case DiscreteReading::Datum::Rest:
      return "rest";
    case DiscreteReading::Datum::Release:
      return "release";
    case DiscreteReading::Datum::Printed:
      return "printed";
  }
  return "";
}

namespace {

DiscreteReading reading_of(const DiscreteTask& task) {
  DiscreteReading reading;
  reading.datum = task.datum;
  reading.epsilon = task.epsilon;
  return reading;
}

DiscreteRun run_simplified(const Scene& scene, const DiscreteTask& task) {
  DiscreteReading reading = reading_of(task);
  const DiscreteVariations system(scene, task.nodes, reading);
  reading.epsilon = 0.0;
  const DiscreteVariations limit(scene, task.nodes, reading);
  SquareResult result;
  const MeanTime time = mean_time([&] {
    paper::LiftedNewtonStep step(limit);
    const double begin = process_cpu_seconds();
    result = solve_by_damped_newton(
        [&](std::span<const double> x, std::span<double> values) {
          return system.residual(x, values);
        },
        std::ref(step), *system.cycloid_guess(), {});
    return process_cpu_seconds() - begin;
  });
  DiscreteRun run;
  run.cpu_seconds = time.seconds;
  run.repetitions = time.repetitions;
  run.evaluations = result.evaluations;
  if (result.status == Status::Solved) {
    run.outcome = DiscreteRun::Outcome::Solved;
    run.tau = system.tau(result.x);
  } else {
    run.cause = FixedText<200>(result.message);
  }
  return run;
}

}  // namespace

DiscreteRun run_here(const Scene& scene, const DiscreteTask& task) {
  if (task.arm == Arm::Simplified) return run_simplified(scene, task);
  DiscreteSystem options;
  options.nodes = task.nodes;
  options.reading = reading_of(task);
  options.solver = task.arm == Arm::Newton   ? DiscreteSolver::Newton
                   : task.arm == Arm::Lifted ? DiscreteSolver::Lifted
                                             : DiscreteSolver::Hybrid;
  DiscreteAnswer answer;
  const MeanTime time = mean_time([&] {
    answer = solve_discrete_system(scene, options);
    return answer.cpu_seconds;
  });
  DiscreteRun run;
  run.outcome = answer.solved() ? DiscreteRun::Outcome::Solved
                                : DiscreteRun::Outcome::Failed;
  run.tau = answer.tau;
  run.cpu_seconds = time.seconds;
  run.repetitions = time.repetitions;
  run.evaluations = answer.evaluations;
  run.cause = FixedText<200>(answer.solved() ? "" : answer.message);
  return run;
}

}  // namespace brachisto::benchmarks
