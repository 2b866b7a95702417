// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problem files: a scene and the options of its solve, in YAML.
///
/// Reading is strict. Whatever the program would not use as the author meant
/// it is an error: unknown, repeated and misplaced keys, values of the wrong
/// type, anchors, tags, further documents. docs/problem-files.md describes the
/// format.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/io/diagnostics.hpp"
#include "brachisto/io/work_precision_plan.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/study/solve_options.hpp"

namespace brachisto::io {

/// Content of a problem file after defaults.
struct ProblemFile {
  Scene scene;
  SolveOptions options;
  std::string points_file;  ///< of scene.path, as the file names it, or empty
  WorkPrecisionPlan work_precision;  ///< for comparisons alone
  std::vector<Diagnostic> warnings;  ///< of what is read, but hardly meant
};

/// Longest problem file that is read [bytes].
inline constexpr std::size_t kMaxFileSize = 1U << 20U;

/// Deepest nesting of maps and lists that is read.
inline constexpr std::size_t kMaxNesting = 32;

/// Reads a problem file.
///
/// \param path       of the file, which is UTF-8 with any line ends; "-" is
///                   standard input
/// \param overrides  "dotted.key=VALUE", VALUE in YAML; each replaces or adds
///                   its key, the last one wins
/// \return a scene that satisfies validate(), and options within their bounds
/// \throws IoError     if the file, or the one that scene.path names, cannot be
///                     read
/// \throws InputError  with every mistake of its content; a syntax error ends
///                     the reading and comes alone
[[nodiscard]] ProblemFile read_problem_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides = {});

/// Reads a problem from memory; `name` stands for the file in messages.
/// \throws IoError, InputError  as read_problem_file()
[[nodiscard]] ProblemFile read_problem_text(
    std::string_view text, const std::string& name,
    const std::vector<std::string>& overrides = {});

}  // namespace brachisto::io
