// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto compare FILE: all methods on one scene.

#include <memory>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/output_files.hpp"
#include "comparison/comparison.hpp"

namespace brachisto::app {

namespace {

struct CompareFlags : CommonFlags {
  comparison::ComparisonOptions options;
  std::string out;
  bool force = false;
};

int run(const CompareFlags& flags) {
  constexpr const char* kTable = "compare.txt";
  constexpr const char* kDocument = "compare.json";
  const comparison::Subject subject =
      comparison::read_subject(flags.file, flags.overrides);
  if (!flags.out.empty()) {
    report::check_writable(flags.out, {kTable, kDocument}, flags.force);
  }
  const comparison::Hooks hooks{&catch_signals(), progress_lines(flags.quiet)};
  const comparison::MethodComparison made =
      comparison::compare_methods(subject, flags.options, hooks);
  const std::string json = comparison::to_json(made);
  const std::string table = comparison::summary(made);
  if (!flags.out.empty()) {
    report::write_files(flags.out, {{kTable, table}, {kDocument, json}},
                        flags.force);
  }
  if (flags.json) {
    print_data(json);
  } else if (!flags.quiet) {
    print(table);
  }
  return made.reference ? kSuccess : kNotSolved;
}

}  // namespace

void add_compare(Command& command) {
  const auto flags = std::make_shared<CompareFlags>();
  comparison::ComparisonOptions& options = flags->options;
  CLI::App& verb = command.add(
      "compare", "Solve one scene by every method: time, memory, true error",
      R"(Every method runs in a process of its own, from the cycloid. One that
fails is a row with the reason.
Examples:
  brachisto compare problems/paper/fig04_reference_case.yaml
  brachisto compare case.yaml --nodes 201 --json
Exit codes: 0 compared, 3 bad input file, 4 no verified answer of the
extremal method to take errors against, 6 I/O, 130/143 after
SIGINT/SIGTERM.)",
      [flags] { return run(*flags); });
  flags->add_to(verb);
  add_value(verb, "--nodes", options.nodes, "N",
            "n, of the methods on a fixed mesh")
      ->check(CLI::Range(11, 1'000'000))
      ->capture_default_str();
  add_value(verb, "--repetitions", options.repetitions, "R",
            "Timed solves of each method")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_value(verb, "--seconds", options.seconds, "S",
            "Wall-clock limit of each method")
      ->check(seconds())
      ->capture_default_str();
  add_value(verb, "--residual", options.residual, "R",
            "Residual at which the iterations of every method stop")
      ->check(number("from 1e-14 to 1e-6", 1e-14, 1e-6))
      ->capture_default_str();
  add_directory(verb, "--out", flags->out,
                "Write compare.txt and compare.json there");
  verb.add_flag("--force", flags->force, "Replace existing files in DIR");
}

}  // namespace brachisto::app
