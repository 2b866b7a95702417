// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What compare and work-precision have alike: they run methods on one scene,
// and write and print what comes of it.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "comparison/pages.hpp"

namespace brachisto::app {

struct ComparisonFlags : CommonFlags {
  std::string out;
  bool force = false;
  bool markdown = false;

  /// \param written  what there is in the directory
  [[nodiscard]] std::vector<Flag> with(std::vector<Flag> own,
                                       const char* written) {
    own.push_back(directory_flag("--out", out, written));
    own.push_back({"--force", &force, "Replace existing files in DIR"});
    own.push_back(markdown_flag(markdown));
    return CommonFlags::with(std::move(own),
                             "Problem file (YAML), by its name");
  }
};

/// \param names  of the files that there may be, the page last
/// \param run    makes a comparison of a subject
template <class Run>
[[nodiscard]] auto compared(const ComparisonFlags& flags,
                            const std::vector<std::string>& names,
                            const Run& run) {
  const comparison::Subject subject =
      comparison::read_subject(flags.file, flags.overrides);
  if (!flags.out.empty()) {
    report::check_writable(flags.out, names, flags.force);
  }
  const comparison::Hooks hooks{&catch_signals(), progress_lines(flags.quiet)};
  auto made = run(subject, hooks);
  if (!flags.out.empty()) {
    const report::DrawnFiles files =
        comparison::files_of(made, hooks.interrupt);
    warn(files.missing);
    report::write_files(flags.out, files.files, flags.force, names);
  }
  if (flags.json) {
    print_data(comparison::to_json(made));
  } else if (!flags.quiet) {
    print(comparison::summary(made, flags.markdown ? report::TableForm::Markdown
                                                   : report::TableForm::Text));
    if (!flags.out.empty()) print_paths(flags.out, {{names.back(), ""}});
  }
  return made;
}

}  // namespace brachisto::app
