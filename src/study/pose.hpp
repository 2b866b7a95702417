// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The first stage of a solve: what is solved, and with what.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "refinement/mesh_solve.hpp"

namespace brachisto {

/// Whether there are limits, or the slopes at the contacts are not the
/// extremal's own. A bead touches A and B whatever its slopes there.
[[nodiscard]] bool is_limited(const Scene& scene);

/// A scene with all that its solve goes by; no stage changes it.
struct PosedProblem : PosedScene {
  SolveOptions options;
  /// What meshes, starts and certificates go by: of the method, or where that
  /// poses no program the defaults at its tolerance.
  Collocation program;
  MeshOptions mesh_options;  ///< as if nothing had been done
  /// What is asked for, in natural units, if it is_limited(); contacts of a
  /// bead that are to be optimal are smooth, its slopes being free. Then
  /// `natural`, where it starts from, is without limits and its contact smooth
  /// or the centre's.
  std::optional<Scene> limited;
  /// Of the uniform cylinder, in natural units; nothing if there is none.
  std::optional<CycloidArc> cycloid;
  std::vector<std::string> warnings;  ///< see Solution::warnings

  [[nodiscard]] const StopCondition& stop() const {
    return mesh_options.ipopt.stop;
  }
  [[nodiscard]] const ProgressHook& progress() const {
    return mesh_options.progress;
  }
  /// The options with the iterations that are left.
  [[nodiscard]] MeshOptions mesh_options_after(const Work& done) const;
};

/// The scene whose extremal limits are relaxed to: without them, and with a
/// contact of slopes of its own.
[[nodiscard]] Scene without_limits(Scene scene);

/// Another scene, by the same options and within the same limits of time.
[[nodiscard]] PosedProblem with_scene(const PosedProblem& posed,
                                      const Scene& scene);

/// Checks and poses a problem. The limit of time begins here.
/// \throws std::invalid_argument  see solve()
[[nodiscard]] PosedProblem pose(const Scene& scene, const SolveOptions& options,
                                const SolveHooks& hooks);

}  // namespace brachisto
