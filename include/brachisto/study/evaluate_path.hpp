// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion on a path that a scene states.

#pragma once

#include "brachisto/study/solve.hpp"

namespace brachisto {

/// Evaluates the given path of a scene: nothing is optimised. A body that
/// stalls, does not start or does not fit is Status::Stalled, a path that does
/// not exist Status::NoAdmissiblePath.
///
/// \param scene  a valid one with a path
/// \param hooks  of which the interrupt is looked at
[[nodiscard]] Solution evaluate_path(const Scene& scene,
                                     const SolveOptions& options,
                                     const SolveHooks& hooks = {});

}  // namespace brachisto
