// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Overrides "dotted.key=VALUE" from the command line.

#pragma once

#include <string>

#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Replaces or adds a value in a tree; maps on the way that are absent or
/// empty come into being. If something else stands in the way, the tree stays
/// as it is, for reading it reports that. Behind "sweep." a key of the problem
/// is one key of the section, dots and all.
///
/// \param text    KEY=VALUE, VALUE in YAML
/// \param source  number of the input, ≥ 1, see Position
/// Mistakes in `text` itself go to `findings`.
void apply_override(YamlValue& root, const std::string& text, int source,
                    Findings& findings);

}  // namespace brachisto::io
