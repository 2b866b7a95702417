// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto paper: every figure and every number of the paper.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/diagnostics.hpp"
#include "brachisto/report/output_files.hpp"
#include "io/visible_text.hpp"
#include "reproduction/findings.hpp"
#include "reproduction/page.hpp"
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
};

/// The problem files as installed with this program, else those it was built
/// from.
fs::path default_problems() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = fs::weakly_canonical(
        program.parent_path() / BRACHISTO_PROBLEMS_FROM_BINARY / "paper",
        error);
    if (!error && fs::is_directory(installed, error)) return installed;
  }
  return fs::path(BRACHISTO_SOURCE_PROBLEMS) / "paper";
}

int run(const PaperFlags& flags) {
  constexpr const char* kPage = "index.html";
  report::check_writable(flags.out, {kPage}, flags.force);
  const std::atomic<int>& signal = catch_signals();
  // Its clock starts with the sweep.
  std::optional<sweep::Progress> progress;
  reproduction::Hooks hooks;
  hooks.jobs =
      flags.jobs > 0
          ? flags.jobs
          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  hooks.interrupt = &signal;
  hooks.announce = [&](const std::string& what) {
    if (!flags.quiet) tell_progress(what);
  };
  hooks.progress = [&](const sweep::Counts& now) {
    if (!progress) {
      progress.emplace(flags.quiet ? sweep::Progress::Form::None
                                   : sweep::Progress::form_of_stderr());
    }
    progress->show(now);
  };
  const reproduction::Findings found = reproduction::find_all(
      flags.problems.empty() ? default_problems() : fs::path(flags.problems),
      hooks);
  const reproduction::Reproduction made = reproduction::reproduce(found);
  report::write_files(flags.out, reproduction::files(found, made), flags.force);
  if (flags.json) {
    print_data(reproduction::to_json(found, made));
  } else if (!flags.quiet) {
    print(fmt::format("{}\n{}\n", reproduction::summary(made),
                      io::visible((fs::path(flags.out) / kPage).string())));
  }
  return kSuccess;
}

}  // namespace

void add_paper(CLI::App& app, int& exit_code) {
  auto flags = std::make_shared<PaperFlags>();
  CLI::App* verb = app.add_subcommand(
      "paper", "Reproduce every figure and every number of the paper");
  verb->add_option("--out", flags->out,
                   "Write index.html, figures and tables there")
      ->type_name("DIR")
      ->check(not_empty())
      ->required();
  verb->add_option("--problems", flags->problems,
                   "Directory of the problem files; default: those that came "
                   "with the program")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--jobs", flags->jobs,
                   "Worker processes; default: one per core")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  verb->add_flag("--json", flags->json, "Print one JSON document to stdout");
  verb->add_flag("--quiet", flags->quiet, "Print no results and no progress");
  verb->add_flag("--force", flags->force, "Replace existing files in DIR");
  verb->footer(
      "Example:\n"
      "  brachisto paper --out paper && xdg-open paper/index.html\n"
      "Exit codes: 0 all verified, 3 a problem file is wrong, 4 something has\n"
      "no verified answer and nothing was written, 6 I/O, 130/143 after\n"
      "SIGINT/SIGTERM.");
  verb->callback([flags, &exit_code] { exit_code = run(*flags); });
}

}  // namespace brachisto::app
