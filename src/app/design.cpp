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
#include "brachisto/report/result.hpp"
#include "design/best_track.hpp"
#include "io/input_tree.hpp"
#include "math/wall_clock.hpp"
#include "report/design_report.hpp"
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

/// What all searches of a design came to.
struct Searched {
  std::vector<DesignSearch> searches;  ///< that workers answered for
  std::vector<LostSearch> lost;        ///< that a worker died of
  bool all = true;                     ///< that there are
};

/// The searches of a design by worker processes, as far as they get. Those that
/// the limit of time ends are not kept: --resume begins them again.
Searched search_all(const DesignFlags& flags, const sweep::Job& job,
                    const std::atomic<int>& signal, WallClock::time_point end) {
  // Without --out the searches are kept for this run alone.
  std::optional<sweep::ScratchDirectory> own;
  SweepRun run = flags;
  if (run.out.empty()) run.out = own.emplace().path().string();
  const sweep::DirectoryLock lock(run.out);
  sweep::Store store =
      open_store(run, job, sweep::store_info(job, sweep::Shard{}.name()));
  sweep::ManagerOptions options = manager_options(run, job, signal);
  options.end = end;
  run_manager(job, store, options, search_progress(flags, store));
  Searched out;
  std::vector<std::size_t> stopped;
  const std::size_t results = store.for_each_result(
      [&](std::size_t scene, const std::string& document) {
        try {
          out.searches.push_back(sweep::read_design_search(document));
          if (out.searches.back().stopped) stopped.push_back(scene);
        } catch (const std::exception&) {
          const int number = job.file.problem(scene).design.start.value_or(1);
          out.lost.push_back({number, sweep::read_outcome(document).message});
        }
      });
  out.all = results == job.file.num_scenes();
  store.forget(stopped);
  return out;
}

/// τ over two numbers of the body, the ways of the searches over it. A picture
/// that is missing becomes a warning.
std::vector<report::OutputFile> draw_map(const DesignFlags& flags,
                                         const std::string& text,
                                         DesignAnswer& answer, const Body& best,
                                         const std::atomic<int>& signal,
                                         WallClock::time_point end,
                                         std::vector<std::string>& warnings) {
  const sweep::Job job =
      sweep::design_map_job(text, flags.file, flags.overrides, best, flags.map);
  const sweep::ScratchDirectory scratch;
  sweep::Store store = sweep::Store::create(
      scratch.path(), sweep::store_info(job, sweep::Shard{}.name()));
  sweep::ManagerOptions options = manager_options(flags, job, signal);
  options.end = end;
  const sweep::Counts counts =
      run_manager(job, store, options, [](const sweep::Counts&) {});
  if (counts.finished() < counts.scenes) {
    answer.stopped = true;
    warnings.push_back(
        fmt::format("the limit of time was reached when {} of {} bodies of the "
                    "map had been solved for: it is not drawn",
                    counts.finished(), counts.scenes));
    return {};
  }
  report::DrawnFiles drawn = report::draw(
      report::design_map_figure(sweep::read_table(store, job), answer.paths),
      report::Format::Svg, &signal);
  if (!drawn.missing.empty()) warnings.push_back(drawn.missing);
  return std::move(drawn.files);
}

int run(const DesignFlags& flags) {
  const WallClock::time_point begin = WallClock::now();
  // Once: it may be standard input, or change while bodies are searched for.
  const std::string text = io::read_problem_bytes(flags.file);
  const io::ProblemFile problem =
      io::read_problem_text(text, flags.file, flags.overrides);
  const sweep::Job job = sweep::design_job(text, flags.file, flags.overrides);
  if (!flags.out.empty()) {
    std::vector<std::string> names = solution_files();
    if (flags.map > 0)
      names.insert(names.end(), kMapFiles.begin(), kMapFiles.end());
    report::check_writable(flags.out, names, flags.force || flags.resume);
  }
  warn_of(problem);
  const std::atomic<int>& signal = catch_signals();
  const double limit = problem.options.limits.seconds;
  const double used = seconds_since(begin);
  Searched searched = search_all(
      flags, job, signal, seconds_from_now(kShareOfSearches * limit - used));
  const WallClock::time_point end =
      seconds_from_now(limit - seconds_since(begin));
  const std::vector<DesignMinimum> reached = reached_by(searched.searches);
  DesignAnswer answer =
      gather_designs(problem.design, std::move(searched.searches));
  answer.stopped = answer.stopped || !searched.all;
  std::ranges::move(searched.lost, std::back_inserter(answer.lost));

  Solution solution;
  if (signal.load() != 0) {
    solution.scene = problem.scene;
    solution.options = problem.options;
    solution.status = Status::Interrupted;
    solution.message = "stopped before all searches had ended";
    if (!flags.out.empty()) solution.message += "; --resume goes on";
  } else {
    solution = solve_best(problem.scene, problem.options, reached, &signal, end,
                          answer);
    if (answer.stopped && solution.verified()) {
      solution.warnings.push_back(
          cut_short(problem.options, answer,
                    static_cast<int>(job.file.num_scenes())) +
          (flags.out.empty() ? "" : "; --resume goes on"));
    }
  }
  std::vector<report::OutputFile> further;
  if (flags.map > 0 && solution.verified() && signal.load() == 0) {
    further = draw_map(flags, text, answer, solution.scene.body, signal, end,
                       solution.warnings);
  }
  for (const std::string& warning : solution.warnings) warn(warning);
  return hand_out(solution,
                  {.out = flags.out,
                   .force = flags.force || flags.resume,
                   .json = flags.json,
                   .quiet = flags.quiet,
                   .further = std::move(further),
                   .design = &answer},
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
            .needs = {"--out"}},
           {"--verbose", &flags->verbose,
            "Tell of the progress also where stderr is no terminal"},
           {.name = "--resume",
            .value = &flags->resume,
            .text = "Go on with the searches in DIR, if there are any",
            .needs = {"--out"}},
           unless_resumed(flags->force),
           worker_flag(flags->program)}),
      .footer =
          R"(The section design of the file says what is free and within what
bounds; the body of its scene is the first start.
Examples:
  brachisto design problems/design/quickest.yaml
  brachisto design problems/design/quickest.yaml --set design.bounds.k=[0.1,1]
  brachisto design problems/design/ring_with_weight.yaml --out weight
Exit codes: 0 the best body and its track are verified, 3 bad input
file, 4 no minimum found or not verified, 5 no feasible body found,
6 I/O, 7 a limit was reached, 130/143 after SIGINT/SIGTERM.
solver.limits.seconds is the limit of all searches and of the map
together; when it is reached the quickest body so far is told.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
