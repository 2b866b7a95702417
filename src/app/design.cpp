// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto design FILE: the body that is the quickest on its track.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/solve_progress.hpp"
#include "app/sweep_run.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/output_files.hpp"
#include "design/gather_designs.hpp"
#include "report/design_map.hpp"
#include "sweep/directory_lock.hpp"
#include "sweep/manager.hpp"
#include "sweep/outcome.hpp"
#include "sweep/scratch_directory.hpp"
#include "sweep/table.hpp"

namespace brachisto::app {

namespace {

struct DesignFlags : CommonFlags, SweepRun {
  bool verbose = false;
  int map = 0;  ///< values of each of its axes; 0: none
};

constexpr std::array kMapFiles{"design_map.csv", "design_map.gp",
                               "design_map.svg"};

/// The least τ that a store has of a body that a design may choose.
std::optional<double> least_tau(sweep::Store& store) {
  std::optional<double> least;
  store.for_each_result([&](std::size_t, const std::string& document) {
    const SweepOutcome found = sweep::read_outcome(document);
    if (found.state != SweepOutcome::State::Verified) return;
    least = std::min(found.tau, least.value_or(found.tau));
  });
  return least;
}

/// Tells those who wait how many searches have ended; on a terminal, and where
/// it is asked for.
sweep::ProgressSink search_progress(const DesignFlags& flags,
                                    sweep::Store& store) {
  if (flags.quiet || (!flags.verbose && ::isatty(STDERR_FILENO) != 1)) {
    return [](const sweep::Counts&) {};
  }
  const auto lines = std::make_shared<SolveProgress>(
      [](const std::string& line) { tell_progress(line); },
      SolveProgress::Clock::now());
  // Asked for often, read from the store only when there is more of it.
  const auto known = std::make_shared<std::pair<std::size_t, std::string>>();
  return [=, &store](const sweep::Counts& now) {
    if (now.finished() != known->first) {
      const std::optional<double> tau = least_tau(store);
      *known = {now.finished(),
                tau ? fmt::format(", least τ so far {:.9g}", *tau) : ""};
    }
    lines->note(SolveProgress::Clock::now(), "design",
                fmt::format("{} of {} searches have ended{}", now.finished(),
                            now.scenes, known->second));
  };
}

/// The searches of a design by worker processes, as far as they got.
/// \param lost  gets those that a worker died of
std::vector<DesignSearch> searches(const DesignFlags& flags,
                                   const sweep::Job& job,
                                   const std::atomic<int>& signal,
                                   std::vector<LostSearch>& lost) {
  // Without --out the searches are kept for this run alone.
  std::optional<sweep::ScratchDirectory> own;
  SweepRun run = flags;
  if (run.out.empty()) run.out = own.emplace().path().string();
  const sweep::DirectoryLock lock(run.out);
  sweep::Store store =
      open_store(run, job, sweep::store_info(job, sweep::Shard{}.name()));
  run_manager(job, store, manager_options(run, job, signal),
              search_progress(flags, store));
  std::vector<DesignSearch> found;
  store.for_each_result([&](std::size_t scene, const std::string& document) {
    try {
      found.push_back(sweep::read_design_search(document));
    } catch (const std::exception&) {
      const int number = job.file.problem(scene).design.start.value_or(1);
      lost.push_back({number, sweep::read_outcome(document).message});
    }
  });
  return found;
}

/// τ over two numbers of the body, the ways of the searches over it. A picture
/// that is missing becomes a warning.
std::vector<report::OutputFile> draw_map(const DesignFlags& flags,
                                         const DesignAnswer& answer,
                                         const Body& best,
                                         const std::atomic<int>& signal,
                                         std::vector<std::string>& warnings) {
  const sweep::Job job =
      sweep::read_design_map_job(flags.file, flags.overrides, best, flags.map);
  const sweep::ScratchDirectory scratch;
  sweep::Store store = sweep::Store::create(
      scratch.path(), sweep::store_info(job, sweep::Shard{}.name()));
  run_manager(job, store, manager_options(flags, job, signal),
              [](const sweep::Counts&) {});
  report::DrawnFigure drawn = report::draw(
      report::design_map_figure(sweep::read_table(store, job), answer.paths),
      report::Format::Svg, &signal);
  if (!drawn.missing.empty()) warnings.push_back(drawn.missing);
  return std::move(drawn.files);
}

/// The quickest body that may be shown: the best, or where none is feasible the
/// quickest there is.
const DesignMinimum* shown(const DesignAnswer& answer) {
  if (answer.best) return &*answer.best;
  for (const DesignMinimum& minimum : answer.minima) {
    if (minimum.verified) return &minimum;
  }
  return nullptr;
}

int run(const DesignFlags& flags) {
  const io::ProblemFile problem =
      io::read_problem_file(flags.file, flags.overrides);
  const sweep::Job job = sweep::read_design_job(flags.file, flags.overrides);
  if (!flags.out.empty()) {
    std::vector<std::string> names = solution_files();
    if (flags.map > 0)
      names.insert(names.end(), kMapFiles.begin(), kMapFiles.end());
    report::check_writable(flags.out, names, flags.force || flags.resume);
  }
  for (const io::Diagnostic& warning : problem.warnings) {
    warn(io::to_string(warning));
  }
  const std::atomic<int>& signal = catch_signals();
  std::vector<LostSearch> lost;
  DesignAnswer answer =
      gather_designs(problem.design, searches(flags, job, signal, lost));
  std::ranges::move(lost, std::back_inserter(answer.lost));

  Solution solution;
  solution.scene = problem.scene;
  solution.options = problem.options;
  if (signal.load() != 0) {
    solution.status = Status::Interrupted;
    solution.message = "stopped before all searches had ended";
    if (!flags.out.empty()) solution.message += "; --resume goes on";
  } else if (const DesignMinimum* minimum = shown(answer)) {
    Scene scene = problem.scene;
    scene.body = minimum->body;
    solution = solve(scene, problem.options, {.interrupt = &signal});
  } else {
    solution.status = Status::NotConverged;
    solution.message =
        answer.minima.empty()
            ? "no search came to a minimum"
            : "no search came to a minimum on the principal branch";
  }
  std::vector<report::OutputFile> further;
  if (flags.map > 0 && solution.verified() && signal.load() == 0) {
    further =
        draw_map(flags, answer, solution.scene.body, signal, solution.warnings);
  }
  solution.design = std::move(answer);
  return hand_out(solution,
                  {flags.out, flags.force || flags.resume, flags.json,
                   flags.quiet, std::move(further)},
                  signal);
}

}  // namespace

Verb design_verb() {
  const auto flags = std::make_shared<DesignFlags>();
  return {
      .name = "design",
      .text = "Find the body that is the quickest on its own extremal",
      .flags = flags->with(
          {directory_flag("--out", flags->out,
                          "Write the files of `solve` for the best body there, "
                          "and keep the searches in DIR/sweep.sqlite"),
           jobs_flag(flags->jobs),
           {.name = "--map",
            .value = &flags->map,
            .text = "Draw τ of N × N bodies over the first two numbers that "
                    "are free, with the ways of the searches: design_map.svg",
            .placeholder = "N",
            .check = integer_within(2, 1000),
            .needs = "--out"},
           {"--verbose", &flags->verbose,
            "Tell of the progress also where stderr is no terminal"},
           {.name = "--resume",
            .value = &flags->resume,
            .text = "Go on with the searches in DIR, if there are any",
            .needs = "--out"},
           {.name = "--force",
            .value = &flags->force,
            .text = "Replace the results in DIR",
            .excludes = "--resume"},
           {.name = "--worker",
            .value = &flags->program,
            .text = "Program to run as worker, for tests",
            .placeholder = "PROGRAM",
            .check = existing_file(),
            .hidden = true}}),
      .footer =
          R"(The section design of the file says what is free and within what
bounds; the body of its scene is the first start.
Examples:
  brachisto design problems/design/quickest.yaml
  brachisto design problems/design/quickest.yaml --set design.bounds.k=[0.1,1]
  brachisto design problems/design/ring_with_weight.yaml --out weight
Exit codes: 0 the best body and its track are verified, 3 bad input
file, 4 no minimum found or not verified, 5 no feasible body found,
6 I/O, 7 limit reached, 130/143 after SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
