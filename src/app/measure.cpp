// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto measure FILE: solves a problem several times and prints processor
// times and the result in one line. For compare and work-precision, which run
// it as a process of its own; not for people.

#include <memory>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "comparison/measurement.hpp"
#include "math/wall_clock.hpp"

namespace brachisto::app {

namespace {

using Json = nlohmann::ordered_json;

struct MeasureFlags : CommonFlags {
  int repetitions = 1;
  double seconds = 60.0;
  double residual = DiscreteSystem{}.tolerance;  ///< of the discrete system
};

/// A run that takes longer is not thrown away as a warm-up: caches and page
/// faults do not show in it.
constexpr double kSlow = 2.0;  // [s]

/// Processor times of solves [s], all alike.
struct Times {
  std::vector<double> cpu, start;  ///< the latter within the former

  void add(const Effort& effort) {
    cpu.push_back(effort.cpu_seconds);
    start.push_back(effort.phases.of(Phase::Start));
  }
};

/// Those of up to so many solves. Of slow ones there are as many as fit into
/// half the time.
Times repeat(const io::ProblemFile& problem, const MeasureFlags& flags,
             const Solution& first, WallClock::time_point begin) {
  constexpr double kShare = 0.5;
  Times times;
  if (first.status != Status::Solved || first.effort.cpu_seconds > kSlow) {
    times.add(first.effort);
  }
  if (first.status != Status::Solved) return times;
  const double each = seconds_since(begin);
  const auto wanted = static_cast<std::size_t>(flags.repetitions);
  while (times.cpu.size() < wanted &&
         (times.cpu.empty() ||
          seconds_since(begin) + each < kShare * flags.seconds)) {
    times.add(solve(problem.scene, problem.options).effort);
  }
  return times;
}

/// τ, verified or not.
Json tau_of(const Solution& solution) {
  if (solution.status != Status::Solved) return nullptr;
  if (solution.discrete()) return solution.discrete()->tau;
  return solution.motion() ? Json(solution.motion()->tau()) : Json(nullptr);
}

/// Those that the method itself solves for.
Json unknowns_of(const Solution& solution) {
  if (solution.discrete()) return solution.discrete()->unknowns;
  if (solution.options.of<Shooting>() != nullptr) return nullptr;
  const ProgramSize* program = solution.program();
  return program != nullptr ? Json(program->variables) : Json(nullptr);
}

Json path_of(const Solution& solution) {
  Json path = Json::array();
  for (const Point& at : comparison::places_along(solution)) {
    path.push_back({at.x, at.z});
  }
  return path;
}

int run(const MeasureFlags& flags) {
  io::ProblemFile problem = io::read_problem_file(flags.file, flags.overrides);
  if (problem.options.of<DiscreteSystem>() != nullptr) {
    problem.options.use<DiscreteSystem>().tolerance = flags.residual;
  }
  const WallClock::time_point begin = WallClock::now();
  const Solution solution = solve(problem.scene, problem.options);
  const Times times = repeat(problem, flags, solution, begin);
  const Json line = {{"cpu", times.cpu},
                     {"start", times.start},
                     {"tau", tau_of(solution)},
                     {"unknowns", unknowns_of(solution)},
                     {"path", path_of(solution)},
                     {"result", Json::parse(report::result_json(solution))}};
  print_data(line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  return kSuccess;
}

}  // namespace

Verb measure_verb() {
  const auto flags = std::make_shared<MeasureFlags>();
  return {
      .name = "measure",
      .flags = flags->with(
          {{.name = "--repetitions",
            .value = &flags->repetitions,
            .check = positive()},
           {.name = "--seconds", .value = &flags->seconds, .check = positive()},
           {.name = "--residual",
            .value = &flags->residual,
            .check = positive()}}),
      .run = [flags] { return run(*flags); },
      .hidden = true};
}

}  // namespace brachisto::app
