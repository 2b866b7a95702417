// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The bytes of a problem file, made fit for a YAML parser.

#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

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

}  // namespace brachisto::io
