// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Directories that do not stay if nothing comes into them.

#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace brachisto::report {

/// A directory for what is about to be written, made if need be with those
/// above it. What was made and is empty in the end is removed again.
class NewDirectories {
 public:
  NewDirectories(const std::filesystem::path& directory,
                 std::error_code& error);
  ~NewDirectories();
  NewDirectories(const NewDirectories&) = delete;
  NewDirectories& operator=(const NewDirectories&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

}  // namespace brachisto::report
