// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is wrong with an input, and where.

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace brachisto::io {

/// One mistake in a problem file or in an override of the command line.
struct Diagnostic {
  std::string file;     ///< name of the file, or "--set KEY=VALUE"
  int line = 0;         ///< from 1; 0 if the mistake has no line (an override)
  int column = 0;       ///< from 1, in characters, not bytes; 0 as for `line`
  std::string key;      ///< dotted, "scene.body.k"; empty for the whole file
  std::string message;  ///< what was read; what is allowed; the nearest match
};

/// "file:line:column: key: message", without the parts that are not there.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// The content of a problem file is refused (exit code 3).
///
/// Holds all mistakes that were found, those of the file in file order and
/// then those of the overrides. what() has one of them per line, of very many
/// only the first kShownDiagnostics.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);

  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const {
    return diagnostics_;
  }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// How many mistakes InputError::what() spells out.
inline constexpr std::size_t kShownDiagnostics = 100;

/// A file cannot be opened, read or written (exit code 6).
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brachisto::io
