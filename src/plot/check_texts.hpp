// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the checks of a certificate mean, for those who read it.

#pragma once

#include <span>
#include <string_view>

namespace brachisto::plot {

/// A check by its name in result files, and one line on it. docs/numerics.md
/// tells more.
struct CheckText {
  std::string_view check, meaning;
};

/// All checks that a certificate may have.
[[nodiscard]] std::span<const CheckText> check_texts();

/// The line on a check; "" of one that is not known.
[[nodiscard]] std::string_view check_meaning(std::string_view check);

}  // namespace brachisto::plot
