// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Text that may be copied byte by byte, and names for outcomes.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"

namespace brachisto::benchmarks {

/// At most N − 1 bytes; longer text is cut between characters.
template <std::size_t N>
class FixedText {
 public:
  FixedText() = default;
  explicit FixedText(std::string_view text) {
    std::size_t n = text.size() < N ? text.size() : N - 1;
    constexpr unsigned kContinues = 0x80, kMask = 0xc0;
    const auto splits = [&](std::size_t i) {
      return i < text.size() &&
             (static_cast<unsigned char>(text[i]) & kMask) == kContinues;
    };
    while (n > 0 && splits(n)) --n;
    for (std::size_t i = 0; i < n; ++i) bytes_[i] = text[i];
  }
  [[nodiscard]] std::string str() const { return bytes_.data(); }
  [[nodiscard]] bool empty() const { return bytes_[0] == '\0'; }

 private:
  std::array<char, N> bytes_{};
};

/// The problem files in a folder whose names contain a text, in their order.
///
/// \throws std::filesystem::filesystem_error for what is no folder
[[nodiscard]] std::vector<std::string> problem_files(
    const std::string& folder, std::string_view part = "");

/// One word for how the indirect method ended: "branch_turns_back".
[[nodiscard]] std::string_view word(ExtremalStatus status);

/// Failed checks of a certificate: "closure 1e-07 > 1e-08; …".
[[nodiscard]] std::string failed_checks(const Certificate& certificate);

/// Why a solution is not verified: the message, or the failed checks. Empty if
/// it is verified.
[[nodiscard]] std::string why_not_verified(const Solution& solution);

}  // namespace brachisto::benchmarks
