// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto solve FILE: the track of one scene.

#include <fmt/format.h>

#include <algorithm>
#include <locale>
#include <memory>
#include <optional>
#include <sstream>
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
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "report/cutting_template.hpp"
#include "study/size.hpp"

namespace brachisto::app {

namespace {

struct SolveFlags : CommonFlags {
  std::string out;
  std::string certify;
  bool verbose = false;
  bool force = false;
  std::string track_svg, track_dxf;
  std::string sheet = "600x400";
  bool gif = false;
};

/// "WIDTHxHEIGHT" in mm; nothing if it is not that.
std::optional<report::cutting::Sheet> sheet_of(const std::string& text) {
  report::cutting::Sheet sheet;
  char x = 0;
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  if (!(in >> sheet.width >> x >> sheet.height) || x != 'x' ||
      in.peek() != std::istringstream::traits_type::eof() ||
      !(std::min(sheet.width, sheet.height) >= 50.0) ||
      !(std::max(sheet.width, sheet.height) <= 1e5)) {
    return std::nullopt;
  }
  return sheet;
}

/// What --track-svg and --track-dxf ask for.
void write_templates(const SolveFlags& flags, const Solution& solution,
                     const std::vector<MassPart>& parts) {
  if (flags.track_svg.empty() && flags.track_dxf.empty()) return;
  std::vector<report::cutting::Drawing> drawings;
  try {
    drawings = report::cutting::cutting_template(solution, parts,
                                                 *sheet_of(flags.sheet));
  } catch (const report::cutting::TemplateError& error) {
    throw UsageError("brachisto solve", error.what());
  }
  const auto write =
      [&](const std::string& directory, const char* ending,
          std::string (*in_format)(const report::cutting::Drawing&)) {
        if (directory.empty()) return;
        std::vector<report::OutputFile> files;
        for (const report::cutting::Drawing& drawing : drawings) {
          files.push_back({drawing.name + ending, in_format(drawing)});
        }
        report::write_files(directory, files, flags.force);
      };
  write(flags.track_svg, ".svg", report::cutting::as_svg);
  write(flags.track_dxf, ".dxf", report::cutting::as_dxf);
}

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
  warn_of(problem);
  if (flags.verbose) {
    if (const auto size = forecast(problem.scene, problem.options)) {
      tell(fmt::format("brachisto: to be solved: {}\n", in_words(*size)));
    }
  }
  Solution solution = solve_in_time(problem, flags.json,
                                    {.interrupt = &signal,
                                     .verbose = flags.verbose,
                                     .progress = std::move(hook)});

  for (const io::Diagnostic& warning : problem.warnings) {
    solution.warnings.push_back(io::to_string(warning));
  }
  if (flags.verbose) tell(solution.effort.log);
  const int code = hand_out(solution,
                            {.out = flags.out,
                             .force = flags.force,
                             .json = flags.json,
                             .quiet = flags.quiet,
                             .gif = flags.gif},
                            signal);
  if (code == kSuccess) write_templates(flags, solution, problem.design.parts);
  return code;
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
            .check = word_of("solver.certify")},
           directory_flag("--track-svg", flags->track_svg,
                          "Write the track there at true scale for a cutter, "
                          "if it is verified and feasible"),
           directory_flag("--track-dxf", flags->track_dxf, "The same as DXF"),
           {.name = "--sheet",
            .value = &flags->sheet,
            .text = "Size of the sheets to cut [mm]",
            .placeholder = "WIDTHxHEIGHT",
            .check = {[](const std::string& text) -> std::string {
                        return sheet_of(text)
                                   ? ""
                                   : "expected two numbers from 50 to 100000, "
                                     "as in 600x400";
                      },
                      "WIDTHxHEIGHT"},
            .shows_default = true},
           {"--force", &flags->force, "Replace existing results in DIR"},
           {"--verbose", &flags->verbose, "Print the solver's log"}}),
      .footer =
          R"(Examples:
  brachisto solve problems/paper/fig04_reference_case.yaml
  brachisto solve case.yaml --json | jq .tau
  brachisto solve case.yaml --certify extremal
  brachisto solve case.yaml --set scene.finish.L=4 --out results
  brachisto solve case.yaml --track-svg sheets --sheet 800x500
Exit codes: 0 solved and verified, 3 bad input file, 4 not solved or
not verified, 5 verified but physically infeasible, 6 I/O, 7 limit
reached, 130/143 after SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
