// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto work-precision FILE: what accuracy costs, method by method.

#include <algorithm>
#include <memory>

#include "app/comparing.hpp"
#include "app/exit_code.hpp"
#include "comparison/work_precision.hpp"

namespace brachisto::app {

namespace {

struct WorkPrecisionFlags : ComparisonFlags {
  bool quick = false;
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
  (void)compared(
      flags, comparison::work_precision_file_names(),
      [&](const comparison::Subject& subject, const comparison::Hooks& hooks) {
        const WorkPrecisionPlan& stated = subject.problem.work_precision;
        return comparison::run_work_precision(
            subject, flags.quick ? quick(stated) : stated, hooks);
      });
  return kSuccess;
}

}  // namespace

Verb work_precision_verb() {
  const auto flags = std::make_shared<WorkPrecisionFlags>();
  return {
      .name = "work-precision",
      .text = "Processor time against true error, method by method",
      .flags = flags->with(
          {{"--quick", &flags->quick,
            "The three coarsest meshes that all methods take, one "
            "repetition"}},
          "Write a page, index.html, diagrams with their tables and scripts, "
          "and work_precision.json there"),
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
