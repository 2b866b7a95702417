// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What tells that a row of a store is as it was written.

#pragma once

#include <cstdint>
#include <string_view>

namespace brachisto::sweep {

/// 64-bit XXH3 of a row.
///
/// \param key  of the row and of its table, "result 17": a row whose key has
///             changed is as wrong as one whose content has
[[nodiscard]] std::int64_t row_checksum(std::string_view key,
                                        std::string_view content);

}  // namespace brachisto::sweep
