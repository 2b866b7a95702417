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

void add_schema(Command& command) {
  const auto kind = std::make_shared<std::string>("problem");
  CLI::App& verb =
      command.add("schema", "Print a JSON Schema, by which editors check files",
                  R"(Examples:
  brachisto schema > brachisto.schema.json
and as the first line of a problem file:
  # yaml-language-server: $schema=brachisto.schema.json)",
                  [kind] {
                    print_data(*kind == "result" ? report::result_schema()
                                                 : io::problem_schema());
                    return static_cast<int>(kSuccess);
                  });
  add_value(verb, "KIND", *kind, "TEXT",
            "problem: of problem files, sweeps included; result: of result "
            "documents")
      ->check(CLI::IsMember({"problem", "result"}))
      ->capture_default_str();
}

}  // namespace brachisto::app
