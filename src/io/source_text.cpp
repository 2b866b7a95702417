// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/source_text.hpp"

#include <fmt/format.h>

#include <array>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::io {

namespace {

/// Length in bytes of the UTF-8 character at the beginning of `text`, 0 if
/// there is none: Unicode standard, table 3-7 (no overlong forms, no
/// surrogates, nothing above U+10FFFF).
std::size_t character_length(std::string_view text) {
  struct Form {
    unsigned char first_low, first_high, second_low, second_high;
    std::size_t length;
  };
  static constexpr std::array<Form, 9> kForms{{{0x00, 0x7F, 0, 0, 1},
                                               {0xC2, 0xDF, 0x80, 0xBF, 2},
                                               {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                               {0xE1, 0xEC, 0x80, 0xBF, 3},
                                               {0xED, 0xED, 0x80, 0x9F, 3},
                                               {0xEE, 0xEF, 0x80, 0xBF, 3},
                                               {0xF0, 0xF0, 0x90, 0xBF, 4},
                                               {0xF1, 0xF3, 0x80, 0xBF, 4},
                                               {0xF4, 0xF4, 0x80, 0x8F, 4}}};
  const auto within = [&](std::size_t i, unsigned char low,
                          unsigned char high) {
    if (i >= text.size()) return false;
    const auto byte = static_cast<unsigned char>(text[i]);
    return low <= byte && byte <= high;
  };
  for (const Form& form : kForms) {
    if (!within(0, form.first_low, form.first_high)) continue;
    if (form.length > 1 && !within(1, form.second_low, form.second_high)) {
      return 0;
    }
    for (std::size_t i = 2; i < form.length; ++i) {
      if (!within(i, 0x80, 0xBF)) return 0;
    }
    return form.length;
  }
  return 0;
}

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

}  // namespace brachisto::io
