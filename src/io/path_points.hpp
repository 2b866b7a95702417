// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The points of a given path, which stand in a file of their own.

#pragma once

#include "brachisto/io/problem_file.hpp"
#include "io/findings.hpp"
#include "io/input_tree.hpp"

namespace brachisto::io {

/// Reads the file that scene.path names, if it has the shape points, into the
/// problem: a line `x,z`, then two numbers per line, in metres. Mistakes go to
/// the findings, with file and line.
void read_path_points(const InputTree& input, ProblemFile& problem,
                      Findings& findings);

}  // namespace brachisto::io
