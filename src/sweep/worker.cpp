// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/worker.hpp"

#include <exception>
#include <iostream>
#include <istream>
#include <optional>
#include <ostream>
#include <string>

#include "brachisto/study/solve.hpp"
#include "sweep/job.hpp"
#include "sweep/message.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {

namespace {

/// Solves one scene; `neighbour` becomes what the next may start from.
Answer solve_scene(const io::SweepFile& file, std::size_t scene,
                   std::optional<Neighbour>& neighbour) {
  Answer answer;
  answer.scene = scene;
  const bool warm = file.warm_start() && neighbour.has_value();
  try {
    const io::ProblemFile problem = file.problem(scene);
    const Solution solution =
        solve(problem.scene, problem.options,
              {.neighbour = warm ? &*neighbour : nullptr});
    answer.result = outcome_json(solution);
    neighbour.reset();
    if (solution.verified()) neighbour = solution.as_neighbour();
  } catch (const std::exception& error) {
    answer.result = failure_json("internal_error", error.what());
    neighbour.reset();
  }
  if (file.warm_start() && neighbour) answer.state = to_state(*neighbour);
  return answer;
}

}  // namespace

void run_worker(std::istream& in, std::ostream& out) {
  std::string line;
  if (!std::getline(in, line)) return;
  const Job job = job_from_line(line);
  while (std::getline(in, line)) {
    const Request request = request_from_line(line);
    std::optional<Neighbour> neighbour;
    if (!request.state.empty() && request.first > 0) {
      try {
        neighbour = neighbour_from_state(
            request.state, job.file.problem(request.first - 1).scene);
      } catch (const std::exception& error) {
        std::cerr << "brachisto worker: a state cannot be read, so scene "
                  << request.first << " starts cold: " << error.what() << '\n';
      }
    }
    for (std::size_t i = request.first; i < request.last; ++i) {
      out << to_line(solve_scene(job.file, i, neighbour)) << std::flush;
    }
  }
}

}  // namespace brachisto::sweep
