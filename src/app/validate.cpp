// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto validate FILE: reads a problem file and says what it means.

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "app/exit_code.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result_json.hpp"

namespace brachisto::app {

void add_validate(CLI::App& app, int& exit_code) {
  auto flags = std::make_shared<CommonFlags>();
  CLI::App* verb = app.add_subcommand(
      "validate", "Check a problem file and print its effective input");
  flags->add_to(*verb);
  verb->footer(
      "Examples:\n"
      "  brachisto validate case.yaml\n"
      "  brachisto validate case.yaml --set scene.body.k=1/4 --json");
  verb->callback([flags, &exit_code] {
    const io::ProblemFile problem =
        io::read_problem_file(flags->file, flags->overrides);
    const std::string effective =
        report::input_json(problem.scene, problem.options);
    if (flags->json) {
      fmt::print("{}", effective);
    } else if (!flags->quiet) {
      fmt::print("{}: valid. Effective input, defaults filled in:\n{}",
                 flags->file, effective);
    }
    exit_code = kSuccess;
  });
}

}  // namespace brachisto::app
