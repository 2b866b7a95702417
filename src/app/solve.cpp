// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto solve FILE: the track of one scene.

#include <fmt/format.h>
#include <memory>

#include <string>
#include <utility>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/solve_progress.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/output_files.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto::app {

namespace {

struct SolveFlags : CommonFlags {
  std::string out;
  std::string certify;
  bool verbose = false;
  bool force = false;
  bool gif = false;
};

int run(const SolveFlags& flags) {
  // --certify is short for the key of that name.
  std::vector<std::string> overrides = flags.overrides;
  if (!flags.certify.empty()) {
    overrides.push_back("solver.certify=" + flags.certify);
  }
  const io::ProblemFile problem = io::read_problem_file(flags.file, overrides);
  if (!flags.out.empty()) {
    report::check_writable(flags.out, solution_files(), flags.force);
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
  return hand_out(solution,
                  {.out = flags.out,
                   .force = flags.force,
                   .json = flags.json,
                   .quiet = flags.quiet,
                   .gif = flags.gif},
                  signal);
}

}  // namespace

Verb solve_verb() {
  const auto flags = std::make_shared<SolveFlags>();
  return {.name = "solve",
          .text =
              "Compute the track of one scene, by default its smooth-contact "
              "extremal",
          .flags = flags->with(
              {directory_flag("--out", flags->out,
                              "Write result.json, trajectory.csv, the picture "
                              "path.svg and the page index.html there"),
               {.name = "--gif",
                .value = &flags->gif,
                .text = "Write the motion as motion.gif there too",
                .needs = "--out"},
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
