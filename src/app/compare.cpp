// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto compare FILE: all methods on one scene.

#include <memory>

#include "app/comparing.hpp"
#include "app/exit_code.hpp"
#include "comparison/comparison.hpp"

namespace brachisto::app {

namespace {

struct CompareFlags : ComparisonFlags {
  comparison::ComparisonOptions options;
};

int run(const CompareFlags& flags) {
  const auto made = compared(
      flags, comparison::comparison_file_names(),
      [&](const comparison::Subject& subject, const comparison::Hooks& hooks) {
        return comparison::compare_methods(subject, flags.options, hooks);
      });
  return made.reference ? kSuccess : kNotSolved;
}

}  // namespace

Verb compare_verb() {
  const auto flags = std::make_shared<CompareFlags>();
  comparison::ComparisonOptions& options = flags->options;
  return {
      .name = "compare",
      .text = "Solve one scene by every method: time, memory, true error",
      .flags = flags->with(
          {{.name = "--nodes",
            .value = &options.nodes,
            .text = "n, of the methods on a fixed mesh",
            .placeholder = "N",
            .check = integer_within(11, 1'000'000),
            .shows_default = true},
           {.name = "--repetitions",
            .value = &options.repetitions,
            .text = "Timed solves of each method",
            .placeholder = "R",
            .check = integer_within(1, 1000),
            .shows_default = true},
           {.name = "--seconds",
            .value = &options.seconds,
            .text = "Wall-clock limit of each method",
            .placeholder = "S",
            .check = seconds(),
            .shows_default = true},
           {.name = "--residual",
            .value = &options.residual,
            .text = "Residual at which the iterations of every method stop",
            .placeholder = "R",
            .check = number(
                "from 1e-14 to 1e-6",
                [](double value) { return value >= 1e-14 && value <= 1e-6; }),
            .shows_default = true}},
          "Write a page, index.html, its picture, compare.txt and compare.json "
          "there"),
      .footer =
          R"(Every method runs in a process of its own, from the cycloid. One that
fails is a row with the reason.
Examples:
  brachisto compare problems/paper/fig04_reference_case.yaml
  brachisto compare case.yaml --nodes 201 --json
Exit codes: 0 compared, 3 bad input file, 4 no verified answer to
take errors against, 6 I/O, 130/143 after
SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
