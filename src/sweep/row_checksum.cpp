// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/row_checksum.hpp"

#include <xxhash.h>

#include <string>

namespace brachisto::sweep {

std::int64_t row_checksum(std::string_view key, std::string_view content) {
  std::string row(key);
  row += '\n';
  row += content;
  return static_cast<std::int64_t>(XXH3_64bits(row.data(), row.size()));
}

}  // namespace brachisto::sweep
