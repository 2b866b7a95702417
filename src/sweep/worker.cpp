// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/worker.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <iostream>
#include <istream>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>

#include "brachisto/study/solve.hpp"
#include "math/wall_clock.hpp"
#include "sweep/job.hpp"
#include "sweep/lanes.hpp"
#include "sweep/message.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {

namespace {

/// Searches from the body of a scene.
/// \param seconds  that are left, if they are limited for all scenes together
Answer search_from_scene(const io::SweepFile& file, std::size_t scene,
                         std::optional<double> seconds) {
  Answer answer;
  answer.scene = scene;
  try {
    io::ProblemFile problem = file.problem(scene);
    double& limit = problem.options.limits.seconds;
    if (seconds) limit = std::min(limit, *seconds);
    answer.result = outcome_json(
        search_design(problem.scene, problem.options, problem.design,
                      problem.design.start.value_or(1), nullptr));
  } catch (const std::exception& error) {
    answer.result = failure_json("internal_error", error.what());
  }
  return answer;
}

/// Solves one scene; `neighbour` becomes what the next may start from.
/// \param in_lanes  its solution, if it was solved with others already
Answer solve_scene(const io::SweepFile& file, std::size_t scene,
                   std::shared_ptr<const Neighbour>& neighbour,
                   const std::optional<Solution>& in_lanes) {
  Answer answer;
  answer.scene = scene;
  if (in_lanes) {
    // The next one starts from the cycloid, wherever a worker begins.
    answer.result = outcome_json(*in_lanes, file.keeps_tracks());
    if (file.warm_start()) answer.state = "";
    neighbour.reset();
    return answer;
  }
  const bool warm = file.warm_start() && neighbour != nullptr;
  try {
    const io::ProblemFile problem = file.problem(scene);
    const Solution solution =
        solve(problem.scene, problem.options,
              {.neighbour = warm ? neighbour.get() : nullptr});
    answer.result = outcome_json(solution, file.keeps_tracks());
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
  const bool side_by_side = !job.of_design && asks_for_lanes(job.file);
  while (std::getline(in, line)) {
    const Request request = request_from_line(line);
    std::shared_ptr<const Neighbour> neighbour;
    if (!request.state.empty() && request.first > 0) {
      try {
        neighbour = std::make_shared<const Neighbour>(neighbour_from_state(
            request.state, job.file.problem(request.first - 1).scene));
      } catch (const std::exception& error) {
        std::cerr << "brachisto worker: a state cannot be read, so scene "
                  << request.first << " starts cold: " << error.what() << '\n';
      }
    }
    const WallClock::time_point begin = WallClock::now();
    Lanes lanes(job.file, side_by_side, request.first, request.last);
    for (std::size_t i = request.first; i < request.last; ++i) {
      std::optional<double> left = request.seconds;
      if (left) *left -= seconds_since(begin);
      out << to_line(job.of_design
                         ? search_from_scene(job.file, i, left)
                         : solve_scene(job.file, i, neighbour, lanes.next()))
          << std::flush;
    }
  }
}

void WorkerProcess::flush() {
  while (!outbox_.empty()) {
    const ssize_t count = ::write(input(), outbox_.data(), outbox_.size());
    if (count < 0 && errno == EINTR) continue;
    // A full pipe is tried again; a broken one shows at the other end.
    if (count < 0) {
      if (errno != EAGAIN) outbox_.clear();
      return;
    }
    outbox_.erase(0, static_cast<std::size_t>(count));
  }
}

std::vector<std::string> WorkerProcess::read_lines() {
  // More than any answer: whoever writes that much without an end of line
  // writes rubbish, and the manager is to see it as such.
  constexpr std::size_t kLongestLine = std::size_t{1} << 28U;
  std::vector<std::string> lines;
  // What comes after a line waits: there may be no end of it.
  while (lines.empty()) {
    std::size_t from = inbox_.size();
    const ssize_t count = read_some(output(), inbox_);
    ended_ = count == 0;
    if (count <= 0) break;
    std::size_t begin = 0;
    for (std::size_t end; (end = inbox_.find('\n', from)) != std::string::npos;
         from = begin) {
      lines.push_back(inbox_.substr(begin, end - begin));
      begin = end + 1;
    }
    inbox_.erase(0, begin);
    if (inbox_.size() >= kLongestLine) {
      lines.push_back(std::exchange(inbox_, {}));
    }
  }
  return lines;
}

std::string WorkerProcess::finish() {
  // One that closed its output and stays is not waited for.
  constexpr double kPatience = 0.1;  // [s]
  return child_.finish(ended_ ? kPatience : 0.0).in_words();
}

}  // namespace brachisto::sweep
