// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sweep of the paper, by all cores and without leaving files.

#pragma once

#include <atomic>
#include <filesystem>

#include "brachisto/study/sweep_table.hpp"
#include "sweep/manager.hpp"

namespace brachisto::reproduction {

/// Solves the sweep of a problem file with the program's own workers.
///
/// \param jobs  worker processes
/// \return all scenes verified, unless the interrupt came
/// \throws NotVerified  if a scene has no verified answer
/// \throws io::IoError, io::InputError, sweep::StoreError, sweep::WorkersFail
[[nodiscard]] SweepTable solve_family(const std::filesystem::path& file,
                                      int jobs,
                                      const std::atomic<int>& interrupt,
                                      const sweep::ProgressSink& progress);

}  // namespace brachisto::reproduction
