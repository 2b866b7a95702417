// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A disk that is soon full.

#pragma once

#include <sys/mount.h>

#include <filesystem>
#include <string>

namespace brachisto::testing {

/// A file system of some kilobytes in a directory, where that is allowed.
class TinyDisk {
 public:
  TinyDisk(const std::filesystem::path& directory, const std::string& size)
      : directory_(directory),
        mounted_(::mount("tmpfs", directory.c_str(), "tmpfs", 0,
                         ("size=" + size).c_str()) == 0) {}
  ~TinyDisk() {
    if (mounted_) ::umount2(directory_.c_str(), MNT_DETACH);
  }
  TinyDisk(const TinyDisk&) = delete;
  TinyDisk& operator=(const TinyDisk&) = delete;
  explicit operator bool() const { return mounted_; }

 private:
  std::filesystem::path directory_;
  bool mounted_;
};

}  // namespace brachisto::testing
