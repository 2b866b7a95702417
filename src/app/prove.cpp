// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto prove FILE, and brachisto check-proof FILE.

#include <memory>
#include <utility>
#include <vector>

#include "app/proofs.hpp"

namespace brachisto::app {

Verb prove_verb() {
  const auto flags = std::make_shared<ProveFlags>();
  std::vector<Flag> all = flags->with(
      {{.name = "--bits",
        .value = &flags->bits,
        .text = "Precision; terms of series follow",
        .placeholder = "BITS",
        .check = integer_within(96, 1024),
        .shows_default = true},
       directory_flag(
           "--out", flags->out,
           "Write proof.json and proof.md, a page for people, there"),
       {"--force", &flags->force, "Replace existing ones"}});
  all.front().text = "Problem file, or directory of `brachisto solve --out`";
  all.front().check = not_empty();
  return {
      .name = "prove",
      .text =
          "Prove that the extremal of a scene exists, with bounds of τ, and "
          "what else can be shown",
      .flags = std::move(all),
      .footer = R"(docs/proofs.md says what is shown and what is trusted.
Examples:
  brachisto prove case.yaml
  brachisto prove case.yaml --out proof
  brachisto check-proof proof/proof.json
Exit codes: 0 existence and bounds are proven, 2 built without Arb,
3 bad input file, 4 not proven, 6 I/O.)",
      .run = [flags] { return prove(*flags); }};
}

Verb check_proof_verb() {
  const auto flags = std::make_shared<CheckFlags>();
  return {.name = "check-proof",
          .text = "Show again what a proof says, with another precision",
          .flags = {{.name = "FILE",
                     .value = &flags->file,
                     .text = "proof.json of `brachisto prove --out`",
                     .check = not_empty(),
                     .required = true},
                    {.name = "--problem",
                     .value = &flags->problem,
                     .text = "Refuse it if it is not of this problem file",
                     .placeholder = "FILE",
                     .check = not_empty()},
                    json_flag(flags->json),
                    {"--quiet", &flags->quiet, "Print nothing"}},
          .footer = R"(An edited file and one of another version are refused.
Example:
  brachisto check-proof proof/proof.json --problem case.yaml
Exit codes: 0 shown again, 2 built without Arb, 4 refused or not shown
again, 6 I/O.)",
          .run = [flags] { return check_proof(*flags); }};
}

}  // namespace brachisto::app
