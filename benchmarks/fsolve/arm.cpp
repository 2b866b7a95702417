// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fsolve/arm.hpp"

#include "brachisto/study/fsolve_answer.hpp"
#include "fsolve/mean_time.hpp"

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

DiscreteRun run_here(const Scene& scene, const DiscreteTask& task) {
  FsolveOptions options;
  options.reading.datum = task.datum;
  options.reading.epsilon = task.epsilon;
  options.variant = task.arm == Arm::Newton   ? FsolveVariant::Newton
                    : task.arm == Arm::Lifted ? FsolveVariant::Lifted
                                              : FsolveVariant::Hybrid;
  FsolveAnswer answer;
  const MeanTime time = mean_time([&] {
    answer = fsolve_answer(scene, task.nodes, options);
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
