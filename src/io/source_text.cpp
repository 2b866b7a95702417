// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/source_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "brachisto/io/problem_file.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

/// Controls but tab and line feed; YAML allows no others.
bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n') || byte == 0x7F;
}

}  // namespace

std::string prepared_text(std::string_view text, int source) {
  if (text.size() > kMaxFileSize) {
    throw SyntaxError({source, 1, 1},
                      fmt::format("longer than {} bytes, which no problem file "
                                  "needs to be",
                                  kMaxFileSize));
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);

  std::string prepared;
  prepared.reserve(text.size());
  Position here{source, 1, 1};
  bool indenting = true;
  while (!text.empty()) {
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    const char c = text.front();
    const std::size_t length = character_length(text);
    if (length == 0) {
      throw SyntaxError(here, fmt::format("byte 0x{:02x} is not UTF-8; save "
                                          "the file in the encoding UTF-8",
                                          static_cast<unsigned char>(c)));
    }
    if (is_control(c)) {
      throw SyntaxError(here, fmt::format("control character U+{:04X} is not "
                                          "allowed in a text",
                                          static_cast<unsigned char>(c)));
    }
    if (c == '\t' && indenting) {
      throw SyntaxError(here,
                        "tab in the indentation; YAML indents with "
                        "spaces");
    }
    indenting = c == '\n' || (indenting && c == ' ');
    here = c == '\n' ? Position{source, here.line + 1, 1}
                     : Position{source, here.line, here.column + 1};
    prepared.append(text, 0, length);
    text.remove_prefix(length);
  }
  return prepared;
}

Ruler::Ruler(std::string_view text, int source) : text_(text), source_(source) {
  lines_.push_back({0, 0});
  int characters = 0;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (begins_character(i)) ++characters;
    if (text_[i] == '\n') lines_.push_back({i + 1, characters});
  }
}

Position Ruler::position(std::size_t offset) {
  offset = std::min(offset, text_.size());
  for (; offset_ < offset; ++offset_) {
    if (begins_character(offset_)) ++characters_;
  }
  for (; offset_ > offset; --offset_) {
    if (begins_character(offset_ - 1)) --characters_;
  }
  const auto next = std::ranges::upper_bound(lines_, offset, {}, &Line::offset);
  const auto number = static_cast<int>(next - lines_.begin());
  return {source_, number, characters_ - std::prev(next)->characters + 1};
}

}  // namespace brachisto::io
