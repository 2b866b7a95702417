// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto solve FILE: the track of one scene.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/build_flags.hpp"
#include "app/exit_code.hpp"
#include "app/proofs.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/solve_progress.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "report/cutting_drawing.hpp"
#include "study/size.hpp"

namespace brachisto::app {

namespace {

struct SolveFlags : CommonFlags {
  std::string out;
  std::string certify;
  bool verbose = false;
  bool force = false;
  BuildFlags build;
  bool gif = false;
};

int run(const SolveFlags& flags) {
  // --certify is short for the key of that name.
  std::vector<std::string> overrides = flags.overrides;
  if (!flags.certify.empty()) {
    overrides.push_back("solver.certify=" + flags.certify);
  }
  const io::ProblemFile problem = io::read_problem_file(flags.file, overrides);
  const auto* program = problem.options.of<Collocation>();
  const bool proves = program != nullptr && program->certify == Certify::Proof;
  if (proves) {
    // Another program may have to read it again.
    if (flags.file == "-") {
      tell_error(
          "brachisto: solver.certify: a proof needs a problem file with a "
          "name, "
          "not -\n");
      return kUsage;
    }
    if (const auto code = become_prover()) return *code;
  }
  if (!flags.out.empty()) {
    report::check_writable(flags.out, solution_files(), flags.force);
  }
  flags.build.check(problem.scene, flags.force);

  const std::atomic<int>& signal = catch_signals();
  SolveProgress progress([](const std::string& line) { tell_progress(line); },
                         SolveProgress::Clock::now());
  ProgressHook hook;
  if (!flags.quiet) {
    hook = [&progress](std::string_view phase, const std::string& text) {
      progress.note(SolveProgress::Clock::now(), phase, text);
    };
  }
  warn_of(problem);
  if (flags.verbose) {
    if (const auto size = forecast(problem.scene, problem.options)) {
      tell(fmt::format("brachisto: to be solved: {}\n", in_words(*size)));
    }
  }
  Solution solution = solve_in_time(
      problem, flags.json,
      {.interrupt = &signal, .verbose = flags.verbose, .progress = hook});
  std::vector<report::OutputFile> proof;
  if (proves) {
    const StopCondition stop(
        problem.options.limits.seconds - solution.effort.seconds, &signal);
    proof = prove_answer(solution, stop, hook);
  }

  for (const io::Diagnostic& warning : problem.warnings) {
    solution.warnings.push_back(io::to_string(warning));
  }
  if (flags.verbose) tell(solution.effort.log);
  const std::vector<report::cutting::Drawing> drawings =
      flags.build.drawings(solution, problem.design.parts, flags.force);
  const int code = hand_out(solution,
                            {.out = flags.out,
                             .force = flags.force,
                             .json = flags.json,
                             .quiet = flags.quiet,
                             .further = std::move(proof),
                             .gif = flags.gif},
                            signal);
  if (code == kSuccess) flags.build.write(drawings, flags.force);
  return code;
}

}  // namespace

Verb solve_verb() {
  const auto flags = std::make_shared<SolveFlags>();
  std::vector<Flag> own{
      directory_flag("--out", flags->out,
                     "Write result.json, trajectory.csv, the picture "
                     "path.svg and the page index.html there"),
      {.name = "--gif",
       .value = &flags->gif,
       .text = "Write the motion as motion.gif there too",
       .needs = {"--out"}},
      {.name = "--certify",
       .value = &flags->certify,
       .text = "Cross-check: none, extremal or proof (solver.certify)",
       .placeholder = "METHOD",
       .check = word_of("solver.certify")}};
  std::ranges::move(flags->build.flags(), std::back_inserter(own));
  own.push_back({"--force", &flags->force, "Replace existing results in DIR"});
  own.push_back({"--verbose", &flags->verbose, "Print the solver's log"});
  return {.name = "solve",
          .text =
              "Compute the track of one scene, by default its smooth-contact "
              "extremal",
          .flags = flags->with(std::move(own)),
          .footer =
              R"(Examples:
  brachisto solve problems/paper/fig04_reference_case.yaml
  brachisto solve case.yaml --json | jq .tau
  brachisto solve case.yaml --certify extremal
  brachisto solve case.yaml --set scene.finish.L=4 --out results
  brachisto solve case.yaml --track-svg sheets --scale 1:5
Exit codes: 0 solved and verified, 3 bad input file, 4 not solved or
not verified, 5 verified but physically infeasible, 6 I/O, 7 limit
reached, 130/143 after SIGINT/SIGTERM.)",
          .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
