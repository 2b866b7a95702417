// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// One writer per directory.

#pragma once

#include <filesystem>
#include <system_error>

#include "report/in_full.hpp"

namespace brachisto::sweep {

/// Holds a lock of the kernel on a directory, made if need be and removed again
/// if nothing came into it. It ends with the process, however that ends, and
/// leaves no file behind.
class DirectoryLock {
 public:
  /// \throws StoreError  if another process holds it, or if there can be no
  ///                     such directory
  explicit DirectoryLock(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

 private:
  std::error_code error_;
  report::NewDirectories made_;
  int descriptor_;
};

}  // namespace brachisto::sweep
