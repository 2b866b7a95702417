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

/// The schema of problem files: installed with the program, or made with it in
/// its build tree; nothing if there is none.
[[nodiscard]] std::optional<std::filesystem::path> schema_file();

/// The names of the schemas below share/brachisto.
inline constexpr const char* kProblemSchema = "schemas/problem.schema.json";
inline constexpr const char* kResultSchema = "schemas/result.schema.json";

}  // namespace brachisto::app
