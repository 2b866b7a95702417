// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto derivatives FILE: the derivatives of a scene's program, tried.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "program_files/derivative_check.hpp"
#include "program_files/solved_program.hpp"

namespace brachisto::app {

namespace {

int run(const CommonFlags& flags) {
  const io::ProblemFile problem =
      io::read_problem_file(flags.file, flags.overrides);
  program_files::require_program(problem, flags.file);
  warn_of(problem);
  const std::atomic<int>& signal = catch_signals();
  const Solution solution =
      solve_in_time(problem, flags.json, {.interrupt = &signal});
  const auto program = program_files::solved_program(solution);
  if (!program) {
    if (flags.json)
      print_json({{"agrees", false}, {"message", solution.message}});
    tell(fmt::format("brachisto: no answer to try them at: {}\n",
                     solution.message));
    return exit_code(solution, signal.load());
  }
  const program_files::ProgramCheck check =
      program_files::check_program(*program->problem, program->answer);
  if (flags.json) {
    print_json(check.to_json());
  } else if (!flags.quiet) {
    print(check.in_words());
  }
  return check.agrees() ? kSuccess : kNotSolved;
}

}  // namespace

Verb derivatives_verb() {
  const auto flags = std::make_shared<CommonFlags>();
  return {
      .name = "derivatives",
      .text =
          "Try the exact derivatives of a scene's program against "
          "differences; tell its pattern and its inertia",
      .flags = flags->with({}),
      .footer =
          R"(The scene is solved first; derivatives are tried at its answer, along
eight random directions that move all free variables at once.
Examples:
  brachisto derivatives problems/paper/fig04_reference_case.yaml
  brachisto derivatives case.yaml --set discretisation.formulation=arc_length
Exit codes: 0 they agree, 3 bad input file, 4 they do not, or there is no
answer, 6 I/O, 7 limit, 130/143 after SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
