// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto schema [KIND]: JSON Schemas of what the program reads and writes.

#include <memory>
#include <string>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/key_table.hpp"
#include "brachisto/report/result_json.hpp"

namespace brachisto::app {

void add_schema(CLI::App& app, int& exit_code) {
  auto kind = std::make_shared<std::string>("problem");
  CLI::App* verb = app.add_subcommand(
      "schema", "Print a JSON Schema, by which editors check files");
  verb->add_option("KIND", *kind,
                   "problem: of problem files, sweeps included; result: of "
                   "result documents")
      ->capture_default_str()
      ->check(CLI::IsMember({"problem", "result"}));
  verb->footer(
      "Examples:\n"
      "  brachisto schema > brachisto.schema.json\n"
      "and as the first line of a problem file:\n"
      "  # yaml-language-server: $schema=brachisto.schema.json");
  verb->callback([kind, &exit_code] {
    print_data(*kind == "result" ? report::result_schema()
                                 : io::problem_schema());
    exit_code = kSuccess;
  });
}

}  // namespace brachisto::app
