// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problem files out.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::io {

/// A problem file with other values, as a file of its own: in YAML, expressions
/// as they were written, without comments, and with the file of its points
/// named from where it will stand.
///
/// \param name       of the file
/// \param overrides  as of read_problem_file()
/// \param directory  where it will stand
/// \throws InputError  if it cannot be read
[[nodiscard]] std::string problem_yaml(
    std::string_view text, const std::string& name,
    const std::vector<std::string>& overrides,
    const std::filesystem::path& directory);

}  // namespace brachisto::io
