// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The look of the pages that are written.

#pragma once

#include <string>

namespace brachisto::report {

/// A style element: for a screen, a phone and printing.
[[nodiscard]] std::string page_style();

}  // namespace brachisto::report
