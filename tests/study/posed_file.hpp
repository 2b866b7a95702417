// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes under limits as their search begins.

#pragma once

#include <string>

#include "brachisto/io/problem_file.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"

namespace brachisto::testing {

/// A file of problems/limits with its free extremal.
struct PosedFile {
  PosedProblem problem;
  Start start;

  explicit PosedFile(const std::string& name)
      : problem(
            pose(io::read_problem_file(BRACHISTO_PROBLEMS_DIR "/limits/" + name)
                     .scene,
                 {}, {})),
        start(start_from_cycloid(problem)) {}

  [[nodiscard]] MeshOptions options() const {
    return problem.mesh_options_after({});
  }
};

}  // namespace brachisto::testing
