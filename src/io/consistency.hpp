// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the keys of a problem file demand of each other.

#pragma once

#include "brachisto/io/problem_file.hpp"
#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Checks that the body has the keys of its shape, and no others.
void check_body(const YamlValue& root, const ProblemFile& problem,
                Findings& findings);

/// Checks that elements, nodes and degree describe one mesh.
void check_mesh(const YamlValue& root, const ProblemFile& problem,
                Findings& findings);

/// Checks that the method has a use for the keys that are given, and that there
/// is something to search for.
void check_solver(const YamlValue& root, const ProblemFile& problem,
                  Findings& findings);

/// Checks the bounds of physics, as far as the numbers they are about could be
/// read.
void check_scene(const YamlValue& root, const ProblemFile& problem,
                 Findings& findings);

}  // namespace brachisto::io
