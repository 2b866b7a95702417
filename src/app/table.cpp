// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto table FILE…: many scenes, a row each.

#include <memory>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "comparison/scene_table.hpp"

namespace brachisto::app {

namespace {

using comparison::SolvedScene;
using report::TableForm;

struct TableFlags {
  std::vector<std::string> files, overrides;
  double seconds = 60.0;
  bool json = false, quiet = false, markdown = false;
};

int run(const TableFlags& flags) {
  const std::vector<SolvedScene> scenes =
      comparison::solve_scenes(flags.files, flags.overrides, flags.seconds,
                               {&catch_signals(), progress_lines(flags.quiet)});
  if (flags.json) {
    print_data(comparison::to_json(scenes));
  } else {
    print(comparison::summary(
        scenes, flags.markdown ? TableForm::Markdown : TableForm::Text));
  }
  return kSuccess;
}

}  // namespace

Verb table_verb() {
  const auto flags = std::make_shared<TableFlags>();
  return {
      .name = "table",
      .text = "Solve many scenes, a row each: time, verdict, cost",
      .flags = {{.name = "FILE",
                 .value = &flags->files,
                 .text = "Problem files (YAML)",
                 .check = not_empty(),
                 .required = true},
                {.name = "--set",
                 .value = &flags->overrides,
                 .text = "Replace a value of all files, such as "
                         "solver.guess=straight",
                 .placeholder = "KEY=VALUE"},
                {.name = "--seconds",
                 .value = &flags->seconds,
                 .text = "Wall-clock limit of each scene",
                 .placeholder = "S",
                 .check = seconds(),
                 .shows_default = true},
                {"--json", &flags->json, "Print one JSON document"},
                markdown_flag(flags->markdown),
                {"--quiet", &flags->quiet, "Do not tell what is solved next"}},
      .footer =
          R"(Every scene is solved in a process of its own, by the method that its
file asks for. One that fails or is refused is a row, with the reason
below the table.
Example:
  brachisto table problems/hard/*.yaml
Exit codes: 0 if there is a table, whatever stands in it, 6 I/O, 130/143
after SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
