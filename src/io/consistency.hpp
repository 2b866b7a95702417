// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the keys of a problem file demand of each other.

#pragma once

#include <string>

#include "brachisto/io/problem_file.hpp"
#include "io/draft.hpp"
#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Checks that the body has the keys of its shape and no others; that elements,
/// nodes and degree describe one mesh; that the method has a use for the keys
/// that are given, that there is something to search for, and that the method
/// knows limits if there are any; and the bounds of physics, as far as the
/// numbers they are about could be read.
void check_all(const YamlValue& root, const Draft& problem, Findings& findings);

/// \param file  how messages call it
/// \throws InputError  if the problem leaves nothing to a design
void require_design(const ProblemFile& problem, const std::string& file);

}  // namespace brachisto::io
