// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/letters.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace brachisto::report {

namespace {

constexpr double kWide =
    0.6;  // a letter by its size, on average, in wide fonts

}  // namespace

std::size_t letters(std::string_view text) {
  // All but continuation bytes begin a letter.
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

double width_of(std::size_t letters, double font_size) {
  return kWide * font_size * static_cast<double>(letters);
}

std::string shortened(std::string_view text, std::size_t length) {
  if (letters(text) <= length) return std::string(text);
  std::string out(text);
  while (letters(out) >= length) out.pop_back();
  return out + "…";
}

std::vector<std::string> lines_of(std::string_view list, std::size_t length) {
  std::vector<std::string> lines(1);
  while (!list.empty()) {
    const std::size_t comma = list.find(", ");
    const std::string_view item = list.substr(0, comma);
    list.remove_prefix(std::min(list.size(), item.size() + 2));
    std::string& line = lines.back();
    if (!line.empty() && letters(line) + letters(item) + 3 > length) {
      line += ',';
      lines.emplace_back(item);
    } else {
      line += fmt::format("{}{}", line.empty() ? "" : ", ", item);
    }
  }
  return lines;
}

std::vector<std::string> words_in_lines(std::string_view text,
                                        std::size_t length) {
  std::vector<std::string> lines{""};
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) {
    std::string& line = lines.back();
    if (line.empty()) {
      line = word;
    } else if (letters(line) + 1 + letters(word) <= length) {
      line += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string shortened_key(std::string_view key, std::size_t length) {
  std::string out(key);
  std::size_t dot = 0;
  while (letters(out) > length &&
         (dot = key.find('.')) != std::string_view::npos) {
    key.remove_prefix(dot + 1);
    out = "…" + std::string(key);
  }
  return shortened(out, length);
}

std::size_t columns_for_a_line() {
  constexpr std::size_t kUsual = 80;
  if (::isatty(STDERR_FILENO) == 0) {
    return std::numeric_limits<std::size_t>::max();
  }
  struct winsize window {};
  const bool known =
      ::ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1;
  return (known ? window.ws_col : kUsual) - 1;
}

}  // namespace brachisto::report
