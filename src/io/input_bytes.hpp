// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Input files as bytes.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace brachisto::io {

/// What stands for standard input in place of a problem file.
inline constexpr std::string_view kStandardInput = "-";

/// Bytes of a problem file or of standard input, but no more than are needed to
/// see that they are too many.
/// \throws IoError
[[nodiscard]] std::string read_problem_bytes(const std::filesystem::path& path);

/// Bytes of a file, of which no more than `most` + 1 are read. A pipe or a
/// device, which may keep us waiting or never end, is refused.
///
/// \param what  is expected, for messages: "a problem file"
/// \throws IoError
[[nodiscard]] std::string read_file_bytes(const std::filesystem::path& path,
                                          std::size_t most,
                                          std::string_view what);

}  // namespace brachisto::io
