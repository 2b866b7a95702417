// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Files that are there in full or not at all.

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace brachisto::report {

/// Writing failed; what() names the file and the reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file to be written.
struct OutputFile {
  std::string name;  ///< without directory
  std::string content;
};

/// Writes files into a directory, made if need be. Each is written under a
/// temporary name, flushed to disk and renamed, in the given order: whoever
/// sees the last file sees all of them whole.
///
/// \param force  replace files that exist; otherwise they are an error, and
///               nothing is written
/// \throws OutputError
void write_files(const std::filesystem::path& directory,
                 const std::vector<OutputFile>& files, bool force);

/// Checks beforehand what write_files() would refuse, as far as it can be
/// known. \throws OutputError
void check_writable(const std::filesystem::path& directory,
                    const std::vector<std::string>& names, bool force);

/// Removes files of that name if they are there.
/// \throws OutputError
void remove_files(const std::filesystem::path& directory,
                  const std::vector<std::string>& names);

}  // namespace brachisto::report
