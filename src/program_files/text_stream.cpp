// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/text_stream.hpp"

#include <array>
#include <charconv>

namespace brachisto::program_files {

namespace {

template <class Number>
void put(TextStream& out, Number number) {
  // 17 digits, sign, point and exponent.
  std::array<char, 32> digits;  // NOLINT: filled below
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), number);
  out << std::string_view(digits.data(), end);
}

}  // namespace

TextStream& TextStream::operator<<(int number) {
  put(*this, number);
  return *this;
}

TextStream& TextStream::operator<<(std::size_t number) {
  put(*this, number);
  return *this;
}

TextStream& TextStream::operator<<(double number) {
  put(*this, number);
  return *this;
}

void TextStream::flush() {
  sink_(text_);
  text_.clear();
}

}  // namespace brachisto::program_files
