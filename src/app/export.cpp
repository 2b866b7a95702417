// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto export DIR: the results of a sweep as a flat table.

#include <fmt/format.h>
#include <memory>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "io/visible_text.hpp"
#include "sweep/table.hpp"

namespace brachisto::app {

namespace {

struct ExportFlags {
  std::string directory;
  bool csv = false;
  bool json = false;
};

int run(const ExportFlags& flags) {
  sweep::Store store =
      sweep::Store::open(flags.directory, sweep::Database::Access::ReadOnly);
  const sweep::Job job = store.job();
  const sweep::ExportedTable table = flags.json ? sweep::export_json(store, job)
                                                : sweep::export_csv(store, job);
  print_data(table.text);
  if (table.rows < job.file.num_scenes()) {
    tell(fmt::format("{}: {} of {} scenes are finished\n",
                     io::visible(flags.directory), table.rows,
                     job.file.num_scenes()));
  }
  return exit_code(store);
}

}  // namespace

void add_export(Command& command) {
  const auto flags = std::make_shared<ExportFlags>();
  CLI::App& verb =
      command.add("export", "Print the results of a sweep as a flat table",
                  R"(Examples:
  brachisto export map --csv > map.csv
  brachisto export map --json | jq '.rows[0].tau'
Exit codes: 0 the table has all that is there, 6 I/O, or results are
damaged, which are named and not in the table.)",
                  [flags] { return run(*flags); });
  add_sweep_directory(verb, flags->directory);
  CLI::App* const form = verb.add_option_group("form");
  form->require_option(1);
  form->add_flag("--csv", flags->csv, "Comma-separated values");
  form->add_flag("--json", flags->json, "One JSON document");
}

}  // namespace brachisto::app
