// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The manager of a sweep: hands chains to workers and stores their answers.

#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/wall_clock.hpp"
#include "sweep/chain_plan.hpp"
#include "sweep/job.hpp"
#include "sweep/store.hpp"

namespace brachisto::sweep {

struct ManagerOptions {
  std::string program;  ///< runs a worker when called with the verb worker
  int jobs = 1;         ///< worker processes, ≥ 1
  /// A worker that takes longer for one scene is killed.
  double seconds_per_scene = 0.0;
  std::size_t memory = 0;  ///< address space of a worker [bytes]; 0: no bound
  Shard shard = {};
  const std::atomic<int>* interrupt = nullptr;  ///< nonzero: stop
  /// Of the whole: workers are told what is left, and half a second later they
  /// are killed and what they were at is left undone.
  WallClock::time_point end = WallClock::time_point::max();
};

/// A scene without a verified result.
struct FailedScene {
  std::size_t scene = 0;
  std::string status, message;
};

/// How far a sweep is: the part of it that the shard is.
struct Counts {
  std::size_t scenes = 0;
  std::size_t before = 0;  ///< finished before this run
  std::size_t verified = 0, feasible = 0, failed = 0;  ///< all that are there
  std::vector<FailedScene> failures;  ///< the first kShownFailures of them

  static constexpr std::size_t kShownFailures = 10;
  [[nodiscard]] std::size_t finished() const { return verified + failed; }
};

/// Workers fail one after the other, whatever they are to solve.
class WorkersFail : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Called now and then while workers work.
using ProgressSink = std::function<void(const Counts&)>;

/// Solves whatever the store lacks, with the numbers that solving all of it in
/// one go would give. A worker that crashes, hangs, stops without
/// an answer or writes something else costs the scene it was at: that is tried
/// once more, from the same start, and then recorded as failed. If workers fail
/// in a row, without a good answer between, it is not the scenes' fault.
///
/// \return the counts at the end, which the interrupt and the limit of time may
///         bring early
/// \throws StoreError         if an answer cannot be stored
/// \throws WorkersFail        with nothing of these failures recorded
/// \throws std::system_error  if no worker can be started
Counts run_manager(const Job& job, Store& store, const ManagerOptions& options,
                   const ProgressSink& progress);

}  // namespace brachisto::sweep
