// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A scene in, its smooth-contact extremal out; and what that takes, foretold.

#pragma once

#include <atomic>
#include <optional>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/study/solution.hpp"

namespace brachisto {

/// What a caller may hook into.
struct SolveHooks {
  const std::atomic<int>* interrupt = nullptr;  ///< nonzero: stop
  bool verbose = false;                         ///< keep the solver's log
  ProgressHook progress = {};                   ///< may be empty
  /// A solved scene not far away. If its extremal can be followed to this scene
  /// the continuation from the cycloid is spared; if not, or if it makes no
  /// sense, or if the result is not verified, it is not used.
  const Neighbour* neighbour = nullptr;
};

/// Finds the smooth-contact extremal of a scene (docs/theory.md, section 3).
/// If the scene states its path, that is evaluated, and nothing is optimised: a
/// body that stalls, does not start or does not fit is Status::Stalled, a path
/// that does not exist Status::NoAdmissiblePath.
/// The method DiscreteSystem solves the paper's equations instead, compares
/// their time with that of the extremal, and is never verified.
///
/// May be called in several threads at once. What they do with Ipopt, which is
/// not safe in threads with MUMPS, they do one after the other; with
/// ProgramSolver::NewtonKkt and a chain, and with Shooting, they do not wait.
/// The limit of time counts the waiting too.
///
/// \throws std::invalid_argument  with all that is wrong, if the scene is not
///         valid, an option is out of its bounds, or the formulation arc_length
///         is combined with what it does not have: a degree, another search or
///         start, a tolerance below kSmallestArcLengthTolerance
[[nodiscard]] Solution solve(const Scene& scene,
                             const SolveOptions& options = {},
                             const SolveHooks& hooks = {});

/// Size of a solve, its memory and its time, each to a factor of two or so.
struct Forecast {
  double turns = 0.0;  ///< of the body on its way; 0 if they do not matter
  double nodes = 0.0;  ///< of the final mesh, or of the discrete system
  /// The nodes follow from the wanted error: they and the memory are bounds
  /// that few scenes exceed.
  bool adaptive = false;
  double bytes = 0.0;    ///< largest resident set of a process that solves it
  double seconds = 0.0;  ///< processor time on this machine
  /// A twentieth of what the answer takes of them, without searches and
  /// cross-checks: with less time than this a solve is not begun.
  double least_seconds = 0.0;
};

/// From the turns along the path of the uniform cylinder and the options, by
/// rates measured on one machine, and a millisecond of work that tells how fast
/// this one is. Nothing for a path that the scene states, and where no path
/// leads to B.
/// \throws std::invalid_argument  see solve()
[[nodiscard]] std::optional<Forecast> forecast(
    const Scene& scene, const SolveOptions& options = {});

}  // namespace brachisto
