// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys that a method has no use for.

#pragma once

#include "brachisto/io/problem_file.hpp"
#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Refuses keys that would have no effect with the method of the problem,
/// unless they say what holds anyway.
void check_unused_keys(const YamlValue& root, const ProblemFile& problem,
                       Findings& findings);

}  // namespace brachisto::io
