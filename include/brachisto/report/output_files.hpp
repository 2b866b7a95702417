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

/// Writes files into a directory, made if need be: all of them or none. They
/// are written under temporary names and flushed to disk; then they get their
/// names in the given order, so that whoever sees the last one sees all of them
/// whole. Signals that ask the process to end wait meanwhile.
///
/// \param force     replace files that exist; otherwise they are an error
/// \param obsolete  names of files that go, if they are there, when the others
///                  come
/// \throws OutputError  and leaves the directory as it was, not made if it was
///                      not there
void write_files(const std::filesystem::path& directory,
                 const std::vector<OutputFile>& files, bool force,
                 const std::vector<std::string>& obsolete = {});

/// Checks beforehand what write_files() would refuse, as far as it can be
/// known. \throws OutputError
void check_writable(const std::filesystem::path& directory,
                    const std::vector<std::string>& names, bool force);

}  // namespace brachisto::report
