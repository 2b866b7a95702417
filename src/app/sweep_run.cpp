// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/sweep_run.hpp"

#include <fmt/format.h>
#include <sys/sysinfo.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "brachisto/report/result.hpp"
#include "plot/sweep_page.hpp"
#include "sweep/table.hpp"

namespace brachisto::app {

namespace {

using sweep::Database;
using sweep::Job;
using sweep::Shard;
using sweep::Store;
using sweep::StoreError;
using sweep::StoreInfo;

/// Refuses to go on with a store of something else.
void check_same(const Store& store, const StoreInfo& wanted, const Job& job,
                const std::string& directory) {
  const StoreInfo& stored = store.info();
  const auto refuse = [&](const std::string& reason) {
    throw StoreError(fmt::format(
        "{}: cannot be resumed: {}. Use another --out, or --force to begin "
        "again",
        directory, reason));
  };
  if (stored.version != wanted.version) {
    refuse(fmt::format("it was made by brachisto {}, this is {}",
                       stored.version, wanted.version));
  }
  if (stored.input_hash != wanted.input_hash) {
    refuse(sweep::difference(store.job().file, job.file));
  }
  if (!stored.shard.empty() && stored.shard != wanted.shard &&
      stored.shard != sweep::kMerged) {
    refuse(fmt::format("it is shard {}, not {}", stored.shard, wanted.shard));
  }
}

/// A solve stops itself at its own limit, give or take an iteration; a scene
/// may be solved warm, cold, and by a second method.
double generous_timeout(const io::SweepFile& file) {
  double limit = 0.0;
  for (std::size_t scene = 0; scene < file.num_scenes(); ++scene) {
    limit = std::max(limit, file.problem(scene).options.limits.seconds);
  }
  return 3.0 * limit + 60.0;
}

}  // namespace

Store open_store(const SweepRun& run, const Job& job, const StoreInfo& wanted) {
  if (run.force) Store::remove(run.out);
  if (!Store::exists(run.out)) return Store::create(run.out, wanted);
  if (!run.resume) {
    throw StoreError(fmt::format(
        "{}: has a sweep already; --resume goes on with it, --force begins "
        "again",
        run.out));
  }
  Store store = Store::open(run.out, Database::Access::ReadWrite);
  check_same(store, wanted, job, run.out);
  store.check();
  tell_damage(store, "What is damaged or lost is solved again.\n");
  store.mend(wanted);
  return store;
}

sweep::ManagerOptions manager_options(const SweepRun& run, const Job& job,
                                      const std::atomic<int>& signal) {
  sweep::ManagerOptions options;
  options.program = run.program.empty() ? "/proc/self/exe" : run.program;
  options.jobs = jobs_or_cores(run.jobs);
  options.seconds_per_scene =
      run.timeout > 0.0 ? run.timeout : generous_timeout(job.file);
  constexpr double kMebibyte = 1024.0 * 1024.0;
  if (run.memory >= 0.0) {
    options.memory = static_cast<std::size_t>(run.memory * kMebibyte);
  } else {
    struct sysinfo machine {};
    ::sysinfo(&machine);
    options.memory = machine.totalram * machine.mem_unit /
                     static_cast<std::size_t>(options.jobs);
  }
  options.shard = Shard::parse(run.shard);
  options.interrupt = &signal;
  return options;
}

int write_sweep_report(const std::string& directory, bool force, bool quiet) {
  sweep::Store store =
      sweep::Store::open(directory, sweep::Database::Access::ReadOnly);
  const sweep::Job job = store.job();
  const report::DrawnFiles page = plot::sweep_report(
      read_table(store, job), read_tracks(store, job), &catch_signals());
  warn(page.missing);
  const std::filesystem::path out = std::filesystem::path(directory) / "report";
  report::write_files(out, page.files, force);
  if (!quiet) print_paths(out, page.files);
  return exit_code(store);
}

}  // namespace brachisto::app
