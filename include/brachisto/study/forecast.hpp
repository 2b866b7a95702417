// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a solve takes, foretold before it begins.

#pragma once

#include <optional>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"

namespace brachisto {

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
