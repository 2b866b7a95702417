// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the micro-benchmarks measure: the extremal of the reference case.

#pragma once

#include <benchmark/benchmark.h>

#include "brachisto/nlp/problem.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::benchmarks {

/// The degree of every mesh here.
inline constexpr int kMicroDegree = 5;

/// A problem and its solution up to the error of a coarse mesh, about 1e-9.
struct ExtremalOnMesh {
  RollingTime problem;
  PrimalDual point;
  double phi;  ///< end angle of the smooth contact [rad]

  [[nodiscard]] int nodes() const { return problem.mesh().num_nodes(); }
};

/// The extremal of a coarse mesh on a uniform one with so many elements, in
/// natural units.
[[nodiscard]] ExtremalOnMesh extremal_on_mesh(int elements);

/// The same for the argument of a benchmark, number 0.
[[nodiscard]] ExtremalOnMesh extremal_for(const benchmark::State& state);

/// States the time per node and the size for the fit of complexities.
void per_node(benchmark::State& state, const ExtremalOnMesh& at);

}  // namespace brachisto::benchmarks
