// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What accuracy costs with rolling_time.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"

namespace brachisto::benchmarks {

/// How much of the work is timed, and who does it.
enum class Work {
  /// The nonlinear program on the mesh, from the cycloid to the closed contact,
  /// as the arms of fsolve are timed.
  OnMesh,
  /// solve(), from the scene to τ with its estimated error: the continuation
  /// from the cycloid and the check against degree p + 1 too. Not the
  /// certificate.
  Whole,
};

struct Way {
  Work work = Work::Whole;
  ProgramSolver method = ProgramSolver::Ipopt;

  friend bool operator==(const Way&, const Way&) = default;
};

/// "on the mesh, Ipopt", "whole solve, Newton".
[[nodiscard]] std::string name(const Way& way);

/// A solve, and what it costs.
struct RollingRun {
  Way way;
  int degree = 0, elements = 0;  ///< of the final mesh
  int nodes = 0;
  bool solved = false;
  double error = 0.0;        ///< of τ, relative, against the extremal
  double cpu_seconds = 0.0;  ///< mean of the repetitions
  int repetitions = 0;
};

/// solve(), again and again after a warm-up, until 0.2 s have passed.
[[nodiscard]] RollingRun time_whole(const Scene& scene,
                                    const SolveOptions& options,
                                    double exact_tau);

/// Options of a solve on a uniform mesh.
[[nodiscard]] SolveOptions on_mesh(ProgramSolver method, int degree,
                                   int elements);

/// Every degree on many uniform meshes, in all four ways, each timed.
[[nodiscard]] std::vector<RollingRun> rolling_menu(const Scene& scene,
                                                   double exact_tau);

/// The cheapest run of the menu that is as accurate. An error may be small by
/// chance where it changes its sign: only meshes count all of whose refinements
/// in the menu are as accurate too.
/// \return nothing if none is
[[nodiscard]] std::optional<RollingRun> cheapest(
    std::span<const RollingRun> menu, Work work, double error);

}  // namespace brachisto::benchmarks
