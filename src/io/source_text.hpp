// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The bytes of a problem file, made fit for a YAML parser.

#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/findings.hpp"

namespace brachisto::io {

/// The input cannot be read any further.
class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(Position where, const std::string& message)
      : std::runtime_error(message), position(where) {}

  Position position;
};

/// Takes the byte order mark away and turns CR LF into LF.
///
/// \param source  number of the input, see Position
/// \throws SyntaxError  if the text is too long, is not UTF-8, or contains
///         control characters or a tab in an indentation
[[nodiscard]] std::string prepared_text(std::string_view text, int source);

/// Finds the line and the column, in characters, of bytes of a UTF-8 text.
///
/// Counts on from the last byte asked for, so that asking in order costs O(n)
/// altogether, even where all of the text is one line.
class Ruler {
 public:
  Ruler(std::string_view text, int source);

  /// Place of a byte; offsets behind the end mean the end.
  [[nodiscard]] Position position(std::size_t offset);

 private:
  struct Line {
    std::size_t offset;
    int characters;  ///< in all lines before
  };

  [[nodiscard]] bool begins_character(std::size_t i) const {
    return (static_cast<unsigned char>(text_[i]) & 0xC0U) != 0x80U;
  }

  std::string_view text_;
  int source_;
  std::vector<Line> lines_;
  std::size_t offset_ = 0;
  int characters_ = 0;  ///< in text_[0, offset_)
};

}  // namespace brachisto::io
