// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto documents DIR: the manual and the schemas, laid out below DIR as
// below share of an installation. For the build, which runs it; not for people.

#include <filesystem>
#include <memory>

#include "app/exit_code.hpp"
#include "app/installed.hpp"
#include "app/manual.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/output_files.hpp"
#include "brachisto/report/result.hpp"
#include "io/key_spec.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

/// \param name  with the directories that it is below
void write_below(const fs::path& directory, const fs::path& name,
                 const std::string& text) {
  report::write_files(directory / name.parent_path(),
                      {{name.filename().string(), text}}, true);
}

int write_documents(const fs::path& share, const CommandLine& command) {
  report::write_files(share / "man/man1", command_pages(command), true);
  report::write_files(share / "man/man5", {problem_page()}, true);
  const fs::path data = share / "brachisto";
  write_below(data, kProblemSchema, io::problem_schema());
  write_below(data, kResultSchema, report::result_schema());
  return kSuccess;
}

}  // namespace

Verb documents_verb(CommandLine (*whole)()) {
  const auto directory = std::make_shared<std::string>();
  return {.name = "documents",
          .text = "",
          .flags = {directory_flag("DIR", *directory, "Where they go", true)},
          .run = [=] { return write_documents(*directory, whole()); },
          .hidden = true};
}

}  // namespace brachisto::app
