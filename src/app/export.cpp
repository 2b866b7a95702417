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
  bool markdown = false;
};

int run(const ExportFlags& flags) {
  sweep::Store store =
      sweep::Store::open(flags.directory, sweep::Database::Access::ReadOnly);
  const sweep::Job job = store.job();
  const sweep::ExportedTable table = flags.json ? sweep::export_json(store, job)
                                     : flags.markdown
                                         ? sweep::export_markdown(store, job)
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

Verb export_verb() {
  const auto flags = std::make_shared<ExportFlags>();
  return {.name = "export",
          .text = "Print the results of a sweep as a flat table",
          .flags = {sweep_directory(flags->directory),
                    {.name = "--csv",
                     .value = &flags->csv,
                     .text = "Comma-separated values",
                     .choice = "form"},
                    {.name = "--json",
                     .value = &flags->json,
                     .text = "One JSON document",
                     .choice = "form"},
                    {.name = "--markdown",
                     .value = &flags->markdown,
                     .text = "A table in Markdown",
                     .choice = "form"}},
          .footer =
              R"(Examples:
  brachisto export map --csv > map.csv
  brachisto export map --json | jq '.rows[0].tau'
Exit codes: 0 the table has all that is there, 6 I/O, or results are
damaged, which are named and not in the table.)",
          .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
