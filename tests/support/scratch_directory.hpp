// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A place for files of a test.

#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

namespace brachisto::testing {

namespace fs = std::filesystem;

/// A directory that goes away with its owner.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name =
        (fs::temp_directory_path() / "brachisto-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no temporary directory");
    }
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  /// Writes a file and gives its path.
  [[nodiscard]] std::string file(const std::string& name,
                                 const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return (path_ / name).string();
  }

 private:
  fs::path path_;
};

/// All of a file.
[[nodiscard]] inline std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What lies in a directory.
[[nodiscard]] inline std::set<std::string> names(const fs::path& path) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(path)) {
    out.insert(entry.path().filename().string());
  }
  return out;
}

}  // namespace brachisto::testing
