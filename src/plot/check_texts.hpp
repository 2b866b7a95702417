// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the checks of a certificate mean, for those who read it.

#pragma once

#include <string_view>

namespace brachisto::plot {

/// One line on a check; "" of one that is not known. docs/numerics.md tells
/// more.
[[nodiscard]] std::string_view check_meaning(std::string_view check);

}  // namespace brachisto::plot
