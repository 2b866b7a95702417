// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Mistakes on their way from where they are noticed to an InputError.

#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

/// A place in one of the inputs.
struct Position {
  int source = 0;  ///< 0: the file; i: the i-th override
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1, in characters

  /// Order of the inputs, and of reading within one.
  friend auto operator<=>(const Position&, const Position&) = default;
};

/// A mistake.
struct Finding {
  Position position;
  std::string key;
  std::string message;
};

/// Collects mistakes in any order and reports them in the order of the inputs,
/// those in overrides without lines and columns.
class Findings {
 public:
  void add(Position position, std::string key, std::string message);

  /// Notes what is read, but hardly meant.
  void warn(Position position, std::string key, std::string message);

  /// True if a mistake was added for exactly this key.
  [[nodiscard]] bool concern(std::string_view key) const;

  /// All of them, in the order in which they were added.
  [[nodiscard]] const std::vector<Finding>& all() const { return findings_; }

  /// \param sources  names of the inputs: the file, then each override
  /// \throws InputError  if anything was added
  void throw_if_any(const std::vector<std::string>& sources) const;

  /// What was noted by warn().
  [[nodiscard]] std::vector<Diagnostic> warnings(
      const std::vector<std::string>& sources) const;

 private:
  std::vector<Finding> findings_, warnings_;
};

}  // namespace brachisto::io
