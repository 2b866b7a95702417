// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Fields of comma-separated values.

#pragma once

#include <string>
#include <string_view>

namespace brachisto::report {

/// A text as a field (RFC 4180): within quotes if it has to be.
[[nodiscard]] std::string csv_field(std::string_view text);

}  // namespace brachisto::report
