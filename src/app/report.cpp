// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto report DIR: a sweep as a page with figures.

#include <memory>
#include <string>

#include "app/sweep_run.hpp"
#include "app/verbs.hpp"

namespace brachisto::app {

namespace {

struct ReportFlags {
  std::string directory;
  bool force = false;
  bool quiet = false;
};

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
          .run = [flags] {
            return write_sweep_report(flags->directory, flags->force,
                                      flags->quiet);
          }};
}

}  // namespace brachisto::app
