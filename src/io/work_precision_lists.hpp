// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The lists of the section `work_precision`.

#pragma once

#include "brachisto/io/problem_file.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Reads `methods`: names, of which rolling_time and fsolve may be followed by
/// a list of degrees and of arms. Mistakes go to the findings.
void read_methods(ProblemFile& problem, const KeySpec& spec,
                  const YamlValue& list, Findings& findings);

/// Reads `meshes`.
void read_meshes(ProblemFile& problem, const KeySpec& spec,
                 const YamlValue& list, Findings& findings);

}  // namespace brachisto::io
