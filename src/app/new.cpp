// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto new NAME: a problem file with comments, to begin with.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/exit_code.hpp"
#include "app/installed.hpp"
#include "app/new_problem.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/output_files.hpp"
#include "io/visible_text.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

struct NewFlags {
  std::string name;
  std::string kind = "case";
  bool quiet = false;
  bool force = false;
};

/// A file as a URI, which has no spaces (RFC 3986).
std::string uri_of(const fs::path& file) {
  constexpr std::string_view kAsTheyAre =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri = "file://";
  for (const char c : file.string()) {
    uri += kAsTheyAre.find(c) != std::string_view::npos
               ? std::string(1, c)
               : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

/// The schema of problem files: installed with the program, or made with it in
/// its build tree; nothing if there is none.
std::optional<fs::path> schema_file() {
  constexpr const char* kProblemSchema = "schemas/problem.schema.json";
  if (auto file = installed(kProblemSchema)) return file;
  std::error_code error;
  const fs::path built = fs::path(BRACHISTO_BUILT_DATA) / kProblemSchema;
  if (!fs::exists(built, error)) return std::nullopt;
  return built;
}

/// By this line the YAML language server finds the schema.
std::string schema_line() {
  const auto schema = schema_file();
  return schema ? fmt::format("# yaml-language-server: $schema={}\n",
                              uri_of(*schema))
                : "";
}

/// A text as one word of a shell, in single quotes if it needs them.
std::string shell_word(std::string_view text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._/";
  if (!text.empty() && text.find_first_not_of(kPlain) == text.npos) {
    return std::string(text);
  }
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

int write_new(const NewFlags& flags) {
  fs::path file = flags.name;
  if (file.extension() != ".yaml" && file.extension() != ".yml") {
    file += ".yaml";
  }
  const std::string stem = io::visible(file.stem().string());
  // Of a name without a directory the parent is empty.
  report::write_files(
      file.has_parent_path() ? file.parent_path() : fs::path("."),
      {{file.filename().string(),
        schema_line() + new_problem(flags.kind, stem)}},
      flags.force);
  if (!flags.quiet) {
    const std::string shown = io::visible(file.string());
    print(fmt::format(
        "{}: written; to go on:\n  brachisto {}\n", shown,
        next_command(flags.kind, shell_word(shown), shell_word(stem))));
  }
  return kSuccess;
}

}  // namespace

Verb new_verb() {
  const auto flags = std::make_shared<NewFlags>();
  return {
      .name = "new",
      .text = "Write a problem file with comments, to begin with",
      .flags = {{.name = "NAME",
                 .value = &flags->name,
                 .text = "Name of the file; .yaml is added",
                 .check = not_empty(),
                 .required = true},
                {.name = "--kind",
                 .value = &flags->kind,
                 .text = "What it is about: one scene, a track under limits, "
                         "another world, a family of scenes, the quickest body",
                 .placeholder = "KIND",
                 .check = one_of(new_problem_kinds()),
                 .shows_default = true},
                {"--force", &flags->force, "Replace an existing file"},
                {"--quiet", &flags->quiet, "Print nothing"}},
      .footer =
          R"(Above each key stands what it means. A key behind a # counts once that is gone,
and those before the maps that it is in. The first line tells editors with the
YAML language server where the schema of problem files is.
Examples:
  brachisto new track
  brachisto new wide --kind sweep
Exit codes: 0 written, 6 I/O, or the file exists.)",
      .run = [flags] { return write_new(*flags); }};
}

}  // namespace brachisto::app
