// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sweep of the paper, by all cores and without leaving files.

#pragma once

#include "brachisto/study/sweep_table.hpp"
#include "reproduction/transit.hpp"
#include "sweep/manager.hpp"

namespace brachisto::reproduction {

/// Solves a sweep with the program's own workers.
///
/// \param jobs  worker processes
/// \throws Interrupted
/// \throws NotVerified  if a scene has no verified answer
/// \throws sweep::StoreError, sweep::WorkersFail
[[nodiscard]] SweepTable solve_family(const sweep::Job& job, int jobs,
                                      const Interrupt& interrupt,
                                      const sweep::ProgressSink& progress);

}  // namespace brachisto::reproduction
