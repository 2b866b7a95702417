// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a file and the overrides of the command line to one tree.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// What a problem file and its overrides say together.
struct InputTree {
  YamlValue root;
  std::vector<std::string> sources;  ///< names of the inputs, see Findings
};

/// Builds the tree of a text and applies the overrides to it.
/// \throws InputError  if the text is not YAML, or is empty; other mistakes go
///                     to the findings
[[nodiscard]] InputTree read_input_tree(
    std::string_view text, const std::string& name,
    const std::vector<std::string>& overrides, Findings& findings);

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
/// All of them, of files that the program wrote itself.
[[nodiscard]] std::string read_file_bytes(const std::filesystem::path& path,
                                          std::string_view what);

}  // namespace brachisto::io
