// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Lines that a page shows against those that the command writes.

#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace brachisto::testing {

/// A line cut into its numbers and what stands between them.
struct Parts {
  std::vector<std::string> words{""}, numbers;
};

[[nodiscard]] inline Parts parts_of(const std::string& line) {
  Parts parts;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t end = line.find_first_not_of("0123456789.", i);
    const std::string number = line.substr(i, end - i);
    if (number.find_first_of("0123456789") != std::string::npos) {
      parts.numbers.push_back(number);
      parts.words.emplace_back();
      i += number.size();
    } else {
      parts.words.back() += line[i++];
    }
  }
  return parts;
}

/// Why a line that is shown is not the one that is written; "" if it is.
[[nodiscard]] inline std::string difference_of(const std::string& shown,
                                               const std::string& written) {
  const Parts ours = parts_of(written), theirs = parts_of(shown);
  const std::string both = shown + "\n" + written;
  if (theirs.words != ours.words) return "other words:\n" + both;
  // Iterations and seconds, and how far meshes and methods agree, are not the
  // same everywhere.
  if (shown.starts_with("  found ")) return {};
  const bool agrees = shown.find(" agree to ") != std::string::npos ||
                      shown.find(" difference ") != std::string::npos;
  // "1e-11" is two numbers, the mantissa is always of one digit.
  const std::size_t compared =
      ours.numbers.size() - (agrees ? std::size_t{2} : 0);
  for (std::size_t j = 0; j < compared; ++j) {
    // The wanted accuracy; numbers of few digits are the same.
    constexpr double kAccuracy = 1e-10;
    constexpr std::size_t kFew = 8;
    const bool same = ours.numbers[j].size() <= kFew
                          ? theirs.numbers[j] == ours.numbers[j]
                          : std::abs(std::stod(theirs.numbers[j]) /
                                         std::stod(ours.numbers[j]) -
                                     1.0) <= kAccuracy;
    if (!same) return "other numbers:\n" + both;
  }
  return {};
}

}  // namespace brachisto::testing
