// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Text of many numbers on its way into a file.

#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include "report/in_full.hpp"

namespace brachisto::program_files {

/// Gathers text and hands it on in pieces. Numbers are written with as many
/// digits as tell them from all others.
class TextStream {
 public:
  explicit TextStream(report::TextSink sink) : sink_(std::move(sink)) {}
  TextStream(const TextStream&) = delete;
  TextStream& operator=(const TextStream&) = delete;

  TextStream& operator<<(std::string_view text) {
    text_ += text;
    if (text_.size() > kPiece) flush();
    return *this;
  }
  TextStream& operator<<(char c) { return *this << std::string_view(&c, 1); }
  template <class Number>
  requires std::is_arithmetic_v<Number> TextStream& operator<<(Number number) {
    // 17 digits, sign, point and exponent.
    std::array<char, 32> digits;  // NOLINT: filled below
    const auto [end, error] =
        std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return *this << std::string_view(digits.data(), end);
  }
  /// Once all is said.
  void flush() {
    sink_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1U << 20U;

  report::TextSink sink_;
  std::string text_;
};

}  // namespace brachisto::program_files
