// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The pages of the documentation, to be held against the command.

#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "app/command.hpp"

namespace brachisto::testing {

inline const fs::path kRoot = fs::path(BRACHISTO_PROBLEMS_DIR).parent_path();

[[nodiscard]] inline std::vector<std::string> lines_of(
    const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// What a user reads.
struct Page {
  std::string name, text;
};

/// All pages, and the help of the command.
[[nodiscard]] inline std::vector<Page> pages() {
  std::vector<Page> all{
      {"README.md", content(kRoot / "README.md")},
      {"CONTRIBUTING.md", content(kRoot / "CONTRIBUTING.md")},
      {"benchmarks/README.md", content(kRoot / "benchmarks/README.md")},
      {"brachisto --help", run({"--help"}).out}};
  for (const auto& entry : fs::directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() != ".md") continue;
    all.push_back(
        {"docs/" + entry.path().filename().string(), content(entry.path())});
  }
  return all;
}

}  // namespace brachisto::testing
