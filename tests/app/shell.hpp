// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Lines that a shell runs, with the command in its PATH.

#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "app/pages.hpp"

namespace brachisto::testing {

/// Of the build tree, or of an install tree whose prefix the environment names.
struct Tree {
  fs::path programs;
  fs::path problems;
  fs::path share;  ///< manual, completions, schemas
};

[[nodiscard]] inline Tree tree() {
  const char* prefix = std::getenv("BRACHISTO_PREFIX");
  if (prefix == nullptr) {
    const fs::path programs = fs::path(BRACHISTO_APP).parent_path();
    return {programs, BRACHISTO_PROBLEMS_DIR, programs / "share"};
  }
  const fs::path installed = prefix;
  return {installed / "bin", installed / "share/brachisto/problems",
          installed / "share"};
}

/// Runs lines in a directory; the exit code and all that was written.
/// \param with  the shell
[[nodiscard]] inline Output shell(const std::string& lines,
                                  const fs::path& where = ".",
                                  const std::string& with = "sh") {
  const ScratchDirectory tools;
  const std::string script = tools.file("lines", lines + "\n");
  const fs::path out = tools.path() / "out";
  const int status = std::system(
      ("cd '" + where.string() + "' && PATH='" + tree().programs.string() +
       "':$PATH timeout 600 " + with + " '" + script + "' < /dev/null > '" +
       out.string() + "' 2>&1")
          .c_str());
  return {WEXITSTATUS(status), content(out), ""};
}

[[nodiscard]] inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null").c_str()) == 0;
}

}  // namespace brachisto::testing
