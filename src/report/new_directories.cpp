// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/new_directories.hpp"

#include <unistd.h>

namespace brachisto::report {

namespace fs = std::filesystem;

NewDirectories::NewDirectories(const fs::path& directory,
                               std::error_code& error) {
  std::error_code ignored;
  for (fs::path missing = fs::absolute(directory);
       !fs::exists(missing, ignored) && missing.has_relative_path();
       missing = missing.parent_path()) {
    made_.push_back(missing);
  }
  fs::create_directories(directory, error);
}

NewDirectories::~NewDirectories() {
  // The call refuses a directory that something is in.
  for (const fs::path& one : made_) ::rmdir(one.c_str());
}

}  // namespace brachisto::report
