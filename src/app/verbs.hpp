// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The verbs of the command, one source file each.

#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace brachisto::app {

/// Flags that every verb with a problem file shares.
struct CommonFlags {
  std::string file;
  std::vector<std::string> overrides;  ///< --set KEY=VALUE
  bool json = false;
  bool quiet = false;

  void add_to(CLI::App& verb);
};

/// A verb and where its flags are read into.
template <class Flags>
struct Verb {
  CLI::App& verb;
  Flags& flags;
};

/// Adds a verb that leaves in `exit_code` what `run` returns.
template <class Flags>
Verb<Flags> add_verb(CLI::App& app, int& exit_code, const char* name,
                     const char* text, int (*run)(const Flags&)) {
  const auto flags = std::make_shared<Flags>();
  CLI::App* const verb = app.add_subcommand(name, text);
  verb->callback([flags, run, &exit_code] { exit_code = run(*flags); });
  return {*verb, *flags};
}

/// A verb registers its flags and, in a callback, what it does; the callback
/// leaves its exit code in `exit_code`.
void add_solve(CLI::App& app, int& exit_code);
void add_validate(CLI::App& app, int& exit_code);
void add_schema(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_merge(CLI::App& app, int& exit_code);
void add_paper(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_body(CLI::App& app, int& exit_code);
void add_worker(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_work_precision(CLI::App& app, int& exit_code);
void add_measure(CLI::App& app, int& exit_code);

}  // namespace brachisto::app
