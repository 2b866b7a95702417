// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto nlp FILE: the nonlinear program of a scene, for other solvers, and
// what they answer.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "program_files/foreign_answer.hpp"
#include "program_files/program_directory.hpp"

namespace brachisto::app {

namespace {

using program_files::ProgramFormat;
using program_files::ProgramOutput;
using program_files::ProgramStart;

struct NlpFlags : CommonFlags {
  std::string format = "nl";
  std::string out;
  std::string start = "guess";
  std::string check;
  bool force = false;

  [[nodiscard]] ProgramOutput output() const {
    return {format == "nl" ? ProgramFormat::Nl : ProgramFormat::Matrices, out,
            start == "answer" ? ProgramStart::Answer : ProgramStart::Guess,
            force};
  }
};

void tell_of(const nlohmann::ordered_json& program, const ProgramOutput& output,
             const Solution& solution) {
  std::string names;
  for (const std::string& name : output.names()) names += " " + name;
  print(fmt::format(
      "{} variables, {} constraints, {} elements of degree {}\n"
      "T = {:.12g} in natural units, {:.12g} s; τ = {:.12g}\n"
      "written to {}:{}\n",
      program["variables"].get<int>(), program["constraints"].get<int>(),
      program["elements"].get<int>(), program["degree"].get<int>(),
      program["objective"].get<double>(), program["transit_time"].get<double>(),
      solution.motion()->tau(), output.directory().string(), names));
}

/// The answer of another solver, as it was found against that of the program.
int tell_of_check(const NlpFlags& flags,
                  const program_files::CheckedAnswer& checked) {
  if (flags.json) {
    print_json(checked.to_json());
  } else if (!flags.quiet) {
    print(checked.in_words());
  }
  return checked.certificate.verified() ? kSuccess : kNotSolved;
}

int run(const NlpFlags& flags) {
  if (flags.out.empty() == flags.check.empty()) {
    throw UsageError("brachisto nlp",
                     "--out PATH to write the program, or --check FILE.sol to "
                     "check an answer to it: one of them");
  }
  const io::ProblemFile problem =
      io::read_problem_file(flags.file, flags.overrides);
  program_files::require_program(problem, flags.file);
  const ProgramOutput output = flags.output();
  std::optional<program_files::SolFile> theirs;
  if (flags.check.empty()) {
    report::check_writable(output.directory(), output.names(), flags.force);
  } else {
    theirs = program_files::read_sol(flags.check);
  }
  warn_of(problem);

  const std::atomic<int>& signal = catch_signals();
  const Solution solution =
      solve_in_time(problem, flags.json, {.interrupt = &signal});
  const auto program = program_files::solved_program(solution);
  if (theirs && program && solution.verified()) {
    return tell_of_check(flags, program_files::check_answer(
                                    solution, *program, *theirs, flags.check));
  }
  nlohmann::ordered_json described;
  if (program && !theirs) {
    const StopScope scope{StopCondition(&signal)};
    described = program_files::write_program(*program, output);
  }

  if (flags.json) {
    nlohmann::ordered_json told = {{"status", name(solution.status)},
                                   {"verified", solution.verified()},
                                   {"message", solution.message}};
    if (!theirs) told["program"] = described;
    print_json(told);
  } else if (!described.is_null() && !flags.quiet) {
    tell_of(described, output, solution);
  }
  if (!solution.verified()) {
    tell(fmt::format("brachisto: {}{}\n",
                     theirs ? "nothing to check the answer against: " : "",
                     solution.message));
  }
  for (const std::string& reason : solution.infeasible_because()) {
    warn(fmt::format("the answer is verified, but infeasible: {}", reason));
  }
  return exit_code(solution, signal.load());
}

}  // namespace

Verb nlp_verb() {
  const auto flags = std::make_shared<NlpFlags>();
  return {
      .name = "nlp",
      .text =
          "Write the nonlinear program of one scene for other solvers, or "
          "check their answer",
      .flags = flags->with(
          {{.name = "--out",
            .value = &flags->out,
            .text = "Write there: the .nl file, or a directory for matrices",
            .placeholder = "PATH",
            .check = not_empty()},
           {.name = "--format",
            .value = &flags->format,
            .text = "nl: an .nl file, as AMPL's solvers read it; matrices: "
                    "Jacobian, Hessian and KKT matrix at the answer, as Matrix "
                    "Market files",
            .placeholder = "FORMAT",
            .check = one_of({"nl", "matrices"}),
            .shows_default = true,
            .needs = {"--out"}},
           {.name = "--start",
            .value = &flags->start,
            .text = "Where a solver begins: guess (solver.guess), or the "
                    "answer with its multipliers",
            .placeholder = "POINT",
            .check = one_of({"guess", "answer"}),
            .shows_default = true,
            .needs = {"--out"}},
           {.name = "--check",
            .value = &flags->check,
            .text = "Check the answer that a solver wrote of the .nl file: its "
                    "residuals, limits between nodes, second order, and T "
                    "against that of the program",
            .placeholder = "FILE.sol",
            .check = not_empty()},
           {.name = "--force",
            .value = &flags->force,
            .text = "Replace files that exist",
            .needs = {"--out"}}}),
      .footer =
          R"(The scene is solved first: the mesh is the one it ends on, which
discretisation.elements fixes, and so are the fixed ends of the path.
Numbers are in natural units; docs/nlp.md says what variables mean.
Examples:
  brachisto nlp case.yaml --out case.nl
  brachisto nlp case.yaml --set discretisation.elements=40 --out case.nl
  brachisto nlp case.yaml --format matrices --out case
  brachisto nlp case.yaml --check case.sol
Exit codes: those of solve; nothing is written if it has no answer.
With --check 0 if every check passed, 4 if not.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
