// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto paper: every figure of the paper and every number of its text.

#include <fmt/format.h>
#include <memory>

#include <filesystem>
#include <optional>

#include "app/exit_code.hpp"
#include "app/installed.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "io/visible_text.hpp"
#include "reproduction/page.hpp"
#include "reproduction/results.hpp"
#include "sweep/progress.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

struct PaperFlags {
  std::string out;
  std::string problems;
  int jobs = 0;
  bool json = false;
  bool quiet = false;
  bool force = false;
  bool markdown = false;
};

/// The problem files as installed with this program, else those it was built
/// from.
fs::path default_problems() {
  return installed("problems/paper")
      .value_or(fs::path(BRACHISTO_SOURCE_PROBLEMS) / "paper");
}

int run(const PaperFlags& flags) {
  constexpr const char* kPage = "index.html";
  report::check_writable(flags.out, {kPage}, flags.force);
  const std::atomic<int>& signal = catch_signals();
  // Its clock starts with the sweep.
  std::optional<sweep::Progress> progress;
  reproduction::Hooks hooks;
  hooks.jobs = jobs_or_cores(flags.jobs);
  hooks.interrupt = &signal;
  hooks.announce = progress_lines(flags.quiet);
  hooks.progress = [&](const sweep::Counts& now) {
    if (!progress) {
      progress.emplace(flags.quiet ? sweep::Progress::Form::None
                                   : sweep::Progress::form_of_stderr());
    }
    progress->show(now);
  };
  const reproduction::Results found = reproduction::find_all(
      flags.problems.empty() ? default_problems() : fs::path(flags.problems),
      hooks);
  const reproduction::Reproduction made = reproduction::reproduce(found);
  const report::DrawnFiles written = reproduction::files(found, made, &signal);
  if (!written.missing.empty()) {
    warn(written.missing);
  }
  report::write_files(flags.out, written.files, flags.force);
  if (flags.json) {
    print_data(reproduction::to_json(found, made));
  } else if (!flags.quiet) {
    print(fmt::format("{}\n{}\n",
                      reproduction::numbers_text(
                          made, flags.markdown ? report::TableForm::Markdown
                                               : report::TableForm::Text),
                      io::visible((fs::path(flags.out) / kPage).string())));
  }
  return kSuccess;
}

}  // namespace

Verb paper_verb() {
  const auto flags = std::make_shared<PaperFlags>();
  return {
      .name = "paper",
      .text =
          "Reproduce every figure of the paper and every number of its text",
      .flags = {directory_flag("--out", flags->out,
                               "Write index.html, figures and tables there",
                               true),
                {.name = "--problems",
                 .value = &flags->problems,
                 .text = "Directory of the problem files; default: those that "
                         "came with the program",
                 .placeholder = "DIR",
                 .check = existing_directory()},
                jobs_flag(flags->jobs),
                json_flag(flags->json),
                {"--quiet", &flags->quiet, "Print no results and no progress"},
                {"--force", &flags->force, "Replace existing files in DIR"},
                markdown_flag(flags->markdown)},
      .footer =
          R"(Example:
  brachisto paper --out paper && xdg-open paper/index.html
Exit codes: 0 all verified, 3 a problem file is wrong, 4 something has
no verified answer and nothing was written, 6 I/O, 130/143 after
SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
