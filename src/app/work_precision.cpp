// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto work-precision FILE: what accuracy costs, method by method.

#include <algorithm>
#include <memory>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/result.hpp"
#include "comparison/methods.hpp"
#include "comparison/pages.hpp"
#include "comparison/work_precision.hpp"

namespace brachisto::app {

namespace {

struct WorkPrecisionFlags : CommonFlags {
  std::string out;
  bool force = false;
  bool quick = false;
  bool markdown = false;
};

/// A first look: the coarsest meshes that all methods take, once.
WorkPrecisionPlan quick(WorkPrecisionPlan plan) {
  constexpr std::size_t kMeshes = 3;
  int smallest = 1;
  for (const ComparedMethod& method : plan.methods) {
    smallest = std::max(smallest, comparison::smallest_mesh(method));
  }
  std::erase_if(plan.meshes, [&](int mesh) { return mesh < smallest; });
  plan.meshes.resize(std::min(plan.meshes.size(), kMeshes));
  plan.repetitions = 1;
  return plan;
}

int run(const WorkPrecisionFlags& flags) {
  const comparison::Subject subject =
      comparison::read_subject(flags.file, flags.overrides);
  const WorkPrecisionPlan& stated = subject.problem.work_precision;
  const std::vector<std::string> names =
      comparison::work_precision_file_names();
  if (!flags.out.empty()) {
    report::check_writable(flags.out, names, flags.force);
  }
  const comparison::Hooks hooks{&catch_signals(), progress_lines(flags.quiet)};
  const comparison::WorkPrecision found = comparison::run_work_precision(
      subject, flags.quick ? quick(stated) : stated, hooks);
  if (!flags.out.empty()) {
    const report::DrawnFiles made =
        comparison::files_of(found, hooks.interrupt);
    warn(made.missing);
    report::write_files(flags.out, made.files, flags.force, names);
  }
  if (flags.json) {
    print_data(comparison::to_json(found));
  } else if (!flags.quiet) {
    print(comparison::summary(found, flags.markdown
                                         ? report::TableForm::Markdown
                                         : report::TableForm::Text));
    if (!flags.out.empty()) print_paths(flags.out, {{names.back(), ""}});
  }
  return kSuccess;
}

}  // namespace

Verb work_precision_verb() {
  const auto flags = std::make_shared<WorkPrecisionFlags>();
  return {
      .name = "work-precision",
      .text = "Processor time against true error, method by method",
      .flags = flags->with(
          {directory_flag(
               "--out", flags->out,
               "Write a page, index.html, diagrams with their tables "
               "and scripts, and work_precision.json there"),
           {"--force", &flags->force, "Replace existing files in DIR"},
           {"--quick", &flags->quick,
            "The three coarsest meshes that all methods take, one "
            "repetition"},
           markdown_flag(flags->markdown)}),
      .footer =
          R"(The section work_precision of the file says which methods run on which
meshes; it has defaults.
Examples:
  brachisto work-precision problems/work_precision/base.yaml --out wp
  brachisto work-precision case.yaml --quick
Exit codes: 0 done, 3 bad input file, 4 no verified answer to
take errors against, 6 I/O, 130/143 after
SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
