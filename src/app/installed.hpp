// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Files that came with the program.

#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace brachisto::app {

/// A file or directory below share/brachisto of the place the program is
/// installed in; nothing if it is not there.
[[nodiscard]] std::optional<std::filesystem::path> installed(
    std::string_view name);

}  // namespace brachisto::app
