// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto compare FILE: all methods on one scene.

#include "app/command_line.hpp"
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

void add_compare(CLI::App& app, int& exit_code) {
  auto [verb, flags] = add_verb<CompareFlags>(
      app, exit_code, "compare",
      "Solve one scene by every method: time, memory, true error", run);
  flags.add_to(verb);
  verb.add_option("--nodes", flags.options.nodes,
                  "n, of the methods on a fixed mesh")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(11, 1'000'000));
  verb.add_option("--repetitions", flags.options.repetitions,
                  "Timed solves of each method")
      ->type_name("R")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  verb.add_option("--seconds", flags.options.seconds,
                  "Wall-clock limit of each method")
      ->type_name("S")
      ->capture_default_str()
      ->check(seconds());
  verb.add_option("--residual", flags.options.residual,
                  "Residual at which the iterations of every method stop")
      ->type_name("R")
      ->capture_default_str()
      ->check(number("from 1e-14 to 1e-6", [](double value) {
        return value >= 1e-14 && value <= 1e-6;
      }));
  add_directory(verb, "--out", flags.out,
                "Write compare.txt and compare.json there");
  verb.add_flag("--force", flags.force, "Replace existing files in DIR");
  verb.footer(
      "Every method runs in a process of its own, from the cycloid. One that\n"
      "fails is a row with the reason.\n"
      "Examples:\n"
      "  brachisto compare problems/paper/fig04_reference_case.yaml\n"
      "  brachisto compare case.yaml --nodes 201 --json\n"
      "Exit codes: 0 compared, 3 bad input file, 4 no verified answer of the\n"
      "extremal method to take errors against, 6 I/O, 130/143 after\n"
      "SIGINT/SIGTERM.");
}

}  // namespace brachisto::app
