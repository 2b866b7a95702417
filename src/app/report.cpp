// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto report DIR: a sweep as a page with figures.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/output_files.hpp"
#include "io/visible_text.hpp"
#include "report/sweep_page.hpp"
#include "sweep/table.hpp"

namespace brachisto::app {

namespace {

struct ReportFlags {
  std::string directory;
  bool force = false;
  bool quiet = false;
};

int run(const ReportFlags& flags) {
  sweep::Store store =
      sweep::Store::open(flags.directory, sweep::Database::Access::ReadOnly);
  const sweep::Job job = store.job();
  const report::SweepPage page =
      report::sweep_report(read_table(store, job), &catch_signals());
  if (!page.missing.empty()) {
    warn(page.missing);
  }
  const std::filesystem::path out =
      std::filesystem::path(flags.directory) / "report";
  report::write_files(out, page.files, flags.force);
  if (!flags.quiet) {
    for (const report::OutputFile& file : page.files) {
      print(io::visible((out / file.name).string()) + "\n");
    }
  }
  return exit_code(store);
}

}  // namespace

Verb report_verb() {
  const auto flags = std::make_shared<ReportFlags>();
  return {.name = "report",
          .text = "Draw the results of a sweep into DIR/report",
          .flags = {sweep_directory(flags->directory),
                    {"--force", &flags->force, "Replace an earlier report"},
                    {"--quiet", &flags->quiet, "Do not list what was written"}},
          .footer =
              R"(Example:
  brachisto report map && xdg-open map/report/index.html
Exit codes: 0 drawn, 6 I/O, or results are damaged, which are named and
not in the figures.)",
          .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
