// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The verbs of brachisto_evidence in a command that was built without it.

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"

namespace brachisto::app {

namespace {

Verb left_out(const char* name, bool hidden = false) {
  return {.name = name,
          .text = "Left out of this build",
          .footer = "Configure with -DBRACHISTO_EVIDENCE=ON to have it.",
          .run =
              [] {
                tell_error(
                    "brachisto: this verb is left out of this build; configure "
                    "with -DBRACHISTO_EVIDENCE=ON\n");
                return kUsage;
              },
          .hidden = hidden,
          .takes_anything = true};
}

}  // namespace

Verb paper_verb() {
  return left_out("paper");
}
Verb table_verb() {
  return left_out("table");
}
Verb compare_verb() {
  return left_out("compare");
}
Verb work_precision_verb() {
  return left_out("work-precision");
}
Verb measure_verb() {
  return left_out("measure", true);
}

}  // namespace brachisto::app
