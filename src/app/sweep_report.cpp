// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/sweep_report.hpp"

#include <filesystem>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "brachisto/report/output_files.hpp"
#include "io/visible_text.hpp"
#include "plot/sweep_page.hpp"
#include "sweep/table.hpp"

namespace brachisto::app {

int write_sweep_report(const std::string& directory, bool force, bool quiet) {
  sweep::Store store =
      sweep::Store::open(directory, sweep::Database::Access::ReadOnly);
  const sweep::Job job = store.job();
  const plot::SweepPage page = plot::sweep_report(
      read_table(store, job), read_tracks(store, job), &catch_signals());
  if (!page.missing.empty()) {
    warn(page.missing);
  }
  const std::filesystem::path out = std::filesystem::path(directory) / "report";
  report::write_files(out, page.files, force);
  if (!quiet) {
    for (const report::OutputFile& file : page.files) {
      print(io::visible((out / file.name).string()) + "\n");
    }
  }
  return exit_code(store);
}

}  // namespace brachisto::app
