// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a file and the overrides of the command line to one tree.

#pragma once

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

}  // namespace brachisto::io
