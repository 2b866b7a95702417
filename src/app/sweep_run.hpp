// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// How verbs that have many scenes solved set worker processes to it, and the
// page of what came of it.

#pragma once

#include <atomic>
#include <string>

#include "sweep/job.hpp"
#include "sweep/manager.hpp"
#include "sweep/store.hpp"

namespace brachisto::app {

/// Where results are kept, and who makes them.
struct SweepRun {
  std::string out;
  std::string shard = "1/1";
  std::string program;   ///< of workers; empty: this one
  int jobs = 0;          ///< 0: as many as cores
  double timeout = 0.0;  ///< of one scene [s]; 0: generous
  double memory = -1.0;  ///< of a worker [MiB]; < 0: its share of the machine
  bool resume = false;
  bool force = false;
};

/// The store of a job: a new one, or the one that is there if it is to be gone
/// on with.
/// \throws sweep::StoreError  if it is of something else
[[nodiscard]] sweep::Store open_store(const SweepRun& run,
                                      const sweep::Job& job,
                                      const sweep::StoreInfo& wanted);

[[nodiscard]] sweep::ManagerOptions manager_options(
    const SweepRun& run, const sweep::Job& job, const std::atomic<int>& signal);

/// Writes DIR/report.
/// \param force  replaces an earlier one
/// \param quiet  does not list what was written
/// \return the exit code
/// \throws sweep::StoreError, report::OutputError, Stopped
int write_sweep_report(const std::string& directory, bool force, bool quiet);

}  // namespace brachisto::app
