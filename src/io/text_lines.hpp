// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A text, line by line.

#pragma once

#include <algorithm>
#include <string_view>

namespace brachisto::io {

/// Takes the first line off a text, its end included, and returns it without.
[[nodiscard]] inline std::string_view take_line(std::string_view& text) {
  const std::size_t length = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace brachisto::io
