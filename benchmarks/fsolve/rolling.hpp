// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What accuracy costs with rolling_time.

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brachisto/study/solve.hpp"

namespace brachisto::benchmarks {

/// One way to solve, and what it costs. The time is that of solve() from the
/// scene to τ with its estimated error: continuation from the cycloid and the
/// check against degree p + 1 included, the certificate not.
struct RollingRun {
  Method method = Method::Ipopt;
  int degree = 0, elements = 0;  ///< of the final mesh
  int nodes = 0;
  bool solved = false;
  double error = 0.0;        ///< of τ, relative, against the extremal
  double cpu_seconds = 0.0;  ///< mean of the repetitions
  int repetitions = 0;
};

/// Solves again and again, after a warm-up, until 0.2 s have passed.
[[nodiscard]] RollingRun time_rolling(const Scene& scene,
                                      const SolveOptions& options,
                                      double exact_tau);

/// Options of a solve on a uniform mesh.
[[nodiscard]] SolveOptions on_mesh(Method method, int degree, int elements);

/// Every degree on many uniform meshes, by Ipopt and by Newton's method, each
/// timed.
[[nodiscard]] std::vector<RollingRun> rolling_menu(const Scene& scene,
                                                   double exact_tau);

/// The cheapest run of the menu that is as accurate. An error may be small by
/// chance where it changes its sign: only meshes count all of whose refinements
/// in the menu are as accurate too.
/// \return nothing if none is
[[nodiscard]] std::optional<RollingRun> cheapest(
    std::span<const RollingRun> menu, double error);

}  // namespace brachisto::benchmarks
