// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Guess::Straight and Guess::Random.

#pragma once

#include <string>

#include "brachisto/model/cycloid.hpp"
#include "brachisto/study/cold_start.hpp"
#include "brachisto/study/continuation.hpp"
#include "brachisto/study/mesh_solve.hpp"
#include "brachisto/study/solve_options.hpp"

namespace brachisto {

/// A cold start and the work it took.
struct OtherStart {
  ColdStart cold;
  int iterations = 0;
  int passes = 0;
  std::string log;
};

/// Runs the solver from the start that the options ask for, on the mesh of the
/// principal branch, and says where it led. The principal branch stays the
/// answer.
///
/// \param scene      in SI units
/// \param arc        of the same scene in natural units
/// \param principal  with a curve
[[nodiscard]] OtherStart start_elsewhere(const Scene& scene,
                                         const SolveOptions& options,
                                         const CycloidArc& arc,
                                         const Continuation& principal,
                                         const MeshOptions& budget);

}  // namespace brachisto
