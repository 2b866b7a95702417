// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto solve FILE: the track of one scene.

#include <fmt/format.h>
#include <memory>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solve_progress.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/report/output_files.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "report/path_figure.hpp"

namespace brachisto::app {

namespace {

struct SolveFlags : CommonFlags {
  std::string out;
  std::string certify;
  bool verbose = false;
  bool force = false;
};

constexpr const char* kResultFile = "result.json";
constexpr const char* kTrajectoryFile = "trajectory.csv";
/// The picture of the path, its table and script.
constexpr std::array kPathFiles{"path.csv", "path.gp", "path.svg"};

/// All files of --out.
std::vector<std::string> file_names() {
  std::vector<std::string> names{kResultFile, kTrajectoryFile};
  names.insert(names.end(), kPathFiles.begin(), kPathFiles.end());
  return names;
}

/// The files of --out but the result; without a verified path none. A picture
/// that is missing becomes a warning of the solution. Of a million nodes this
/// takes seconds, so that a signal ends it.
std::vector<report::OutputFile> path_files(Solution& solution,
                                           const std::atomic<int>& signal) {
  if (!solution.verified()) return {};
  report::DrawnFigure picture =
      report::draw(report::path_figure(solution), report::Format::Svg, &signal);
  if (!picture.missing.empty()) {
    warn(picture.missing);
    solution.warnings.push_back(picture.missing);
  }
  picture.files.push_back({kTrajectoryFile, report::trajectory_csv(solution)});
  return std::move(picture.files);
}

/// No path of an earlier result stays beside one that has none; the result
/// comes last.
void write_results(const SolveFlags& flags,
                   std::vector<report::OutputFile> files,
                   const std::string& json) {
  std::vector<std::string> obsolete = file_names();
  files.push_back({kResultFile, json});
  for (const report::OutputFile& file : files) {
    std::erase(obsolete, file.name);
  }
  report::write_files(flags.out, files, flags.force, obsolete);
}

/// Why the exit code is not zero, for those who see nothing else.
std::string complaint(const Solution& solution) {
  if (solution.status != Status::Solved) return solution.message;
  for (const Check& check : solution.certificate.checks) {
    if (check.passed) continue;
    const std::string advice = solution.advice();
    return "not verified: failed check " + check.name +
           (advice.empty() ? "" : "; to try: " + advice);
  }
  for (const std::string& reason : solution.infeasible_because()) {
    return "verified, but infeasible: " + reason;
  }
  return {};
}

int run(const SolveFlags& flags) {
  // --certify is short for the key of that name.
  std::vector<std::string> overrides = flags.overrides;
  if (!flags.certify.empty()) {
    overrides.push_back("solver.certify=" + flags.certify);
  }
  const io::ProblemFile problem = io::read_problem_file(flags.file, overrides);
  if (!flags.out.empty()) {
    report::check_writable(flags.out, file_names(), flags.force);
  }

  const std::atomic<int>& signal = catch_signals();
  SolveProgress progress([](const std::string& line) { tell_progress(line); },
                         SolveProgress::Clock::now());
  ProgressHook hook;
  if (!flags.quiet) {
    hook = [&progress](std::string_view phase, const std::string& text) {
      progress.note(SolveProgress::Clock::now(), phase, text);
    };
  }
  for (const io::Diagnostic& warning : problem.warnings) {
    warn(io::to_string(warning));
  }
  Solution solution = [&] {
    const LastResort last_resort(problem.options.limits.seconds, flags.json);
    return solve(problem.scene, problem.options,
                 {.interrupt = &signal,
                  .verbose = flags.verbose,
                  .progress = std::move(hook)});
  }();

  for (const io::Diagnostic& warning : problem.warnings) {
    solution.warnings.push_back(io::to_string(warning));
  }
  if (flags.verbose) tell(solution.effort.log);
  std::string json;
  if (flags.out.empty()) {
    json = report::result_json(solution);
  } else {
    // What a signal has ended already is written all the same.
    std::optional<StopScope> scope;
    if (solution.verified()) {
      scope.emplace(
          StopCondition(std::numeric_limits<double>::infinity(), &signal));
    }
    std::vector<report::OutputFile> files = path_files(solution, signal);
    json = report::result_json(solution);
    write_results(flags, std::move(files), json);
  }
  if (flags.json) {
    print_data(json);
  } else if (!flags.quiet) {
    print_with_verdict(report::summary(solution),
                       !solution.verified()  ? Colour::Red
                       : solution.feasible() ? Colour::Green
                                             : Colour::Yellow);
  }
  const std::string why = complaint(solution);
  if (flags.quiet && !why.empty()) tell(fmt::format("brachisto: {}\n", why));
  return exit_code(solution, signal.load());
}

}  // namespace

Verb solve_verb() {
  const auto flags = std::make_shared<SolveFlags>();
  return {
      .name = "solve",
      .text =
          "Compute the track of one scene, by default its smooth-contact "
          "extremal",
      .flags = flags->with(
          {directory_flag("--out", flags->out,
                          "Write result.json, trajectory.csv and the picture "
                          "path.svg there"),
           {.name = "--certify",
            .value = &flags->certify,
            .text = "Cross-check: none or extremal (solver.certify)",
            .placeholder = "METHOD",
            .check = not_empty()},
           {"--force", &flags->force, "Replace existing results in DIR"},
           {"--verbose", &flags->verbose, "Print the solver's log"}}),
      .footer =
          R"(Examples:
  brachisto solve problems/paper/fig04_reference_case.yaml
  brachisto solve case.yaml --json | jq .tau
  brachisto solve case.yaml --certify extremal
  brachisto solve case.yaml --set scene.finish.L=4 --out results
Exit codes: 0 solved and verified, 3 bad input file, 4 not solved or
not verified, 5 verified but physically infeasible, 6 I/O, 7 limit
reached, 130/143 after SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
