// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto schema [KIND]: JSON Schemas of what the program reads and writes.

#include <memory>
#include <string>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/result.hpp"
#include "io/key_spec.hpp"

namespace brachisto::app {

Verb schema_verb() {
  const auto kind = std::make_shared<std::string>("problem");
  return {.name = "schema",
          .text = "Print a JSON Schema, by which editors check files",
          .flags = {{.name = "KIND",
                     .value = kind.get(),
                     .text = "problem: of problem files, sweeps included; "
                             "result: of result documents",
                     .check = one_of({"problem", "result"}),
                     .shows_default = true}},
          .footer =
              R"(Examples:
  brachisto schema > brachisto.schema.json
and as the first line of a problem file, as `brachisto new` writes it:
  # yaml-language-server: $schema=brachisto.schema.json)",
          .run = [kind] {
            print_data(*kind == "result" ? report::result_schema()
                                         : io::problem_schema());
            return static_cast<int>(kSuccess);
          }};
}

}  // namespace brachisto::app
