// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto sweep FILE: a family of scenes, by several processes.

#include <fmt/format.h>
#include <memory>

#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/sweep_run.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/result.hpp"
#include "io/visible_text.hpp"
#include "math/wall_clock.hpp"
#include "sweep/directory_lock.hpp"
#include "sweep/manager.hpp"
#include "sweep/outcome.hpp"
#include "sweep/progress.hpp"
#include "sweep/worker.hpp"

namespace brachisto::app {

namespace {

using sweep::Counts;
using sweep::Job;
using sweep::Shard;
using sweep::Store;
using sweep::StoreInfo;

struct SweepFlags : CommonFlags, SweepRun {
  bool retry = false;
};

/// Scenes that failed, the first few with their reasons.
std::string failures(const Counts& counts) {
  std::string text;
  for (const sweep::FailedScene& failed : counts.failures) {
    text +=
        fmt::format("  scene {}: {}: {}\n", failed.scene,
                    io::visible(failed.status), io::visible(failed.message));
  }
  const std::size_t more = counts.failed - counts.failures.size();
  if (more > 0) text += fmt::format("  and {} more\n", more);
  return text;
}

nlohmann::ordered_json failures_json(const Counts& counts) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const sweep::FailedScene& failed : counts.failures) {
    list.push_back({{"scene", failed.scene},
                    {"status", failed.status},
                    {"message", failed.message}});
  }
  return list;
}

/// Forgets what no worker answered for.
void forget_worker_failures(Store& store) {
  std::vector<std::size_t> scenes;
  store.for_each_result([&](std::size_t scene, const std::string& document) {
    if (sweep::read_outcome(document).status.starts_with("worker_")) {
      scenes.push_back(scene);
    }
  });
  store.forget(scenes);
}

void print_results(const SweepFlags& flags, const Counts& counts,
                   double seconds, int signal) {
  if (flags.json) {
    const nlohmann::ordered_json document = {
        {"schema_version", report::kSchemaVersion},
        {"status", signal != 0         ? "interrupted"
                   : counts.failed > 0 ? "some_failed"
                                       : "solved"},
        {"scenes", counts.scenes},
        {"finished", counts.finished()},
        {"verified", counts.verified},
        {"feasible", counts.feasible},
        {"failed", counts.failed},
        {"failures", failures_json(counts)},
        {"new", counts.finished() - counts.before},
        {"seconds", seconds},
        {"store",
         (std::filesystem::path(flags.out) / Store::kFileName).string()}};
    print_json(document);
  } else if (!flags.quiet) {
    print(
        fmt::format("{}: {} of {} scenes finished, {} of them now in {:.1f} s\n"
                    "  verified {} (feasible {}), failed {}\n{}",
                    io::visible(flags.out), counts.finished(), counts.scenes,
                    counts.finished() - counts.before, seconds, counts.verified,
                    counts.feasible, counts.failed, failures(counts)));
    if (signal != 0) print("  stopped; --resume goes on\n");
  }
}

int run(const SweepFlags& flags) {
  const Job job = sweep::read_job(flags.file, flags.overrides);
  const StoreInfo wanted =
      sweep::store_info(job, Shard::parse(flags.shard).name());
  const std::atomic<int>& signal = catch_signals();
  const sweep::DirectoryLock lock(flags.out);
  Store store = open_store(flags, job, wanted);
  if (flags.retry) forget_worker_failures(store);

  sweep::Progress progress(flags.quiet ? sweep::Progress::Form::None
                                       : sweep::Progress::form_of_stderr());
  const auto start = WallClock::now();
  const Counts counts =
      run_manager(job, store, manager_options(flags, job, signal),
                  [&](const Counts& now) { progress.show(now); });
  progress.finish(counts);
  const double seconds = seconds_since(start);
  const int stopped_by = counts.finished() < counts.scenes ? signal.load() : 0;
  print_results(flags, counts, seconds, stopped_by);
  if (stopped_by != 0) return kSignalBase + stopped_by;
  return counts.failed == 0 ? kSuccess : kNotSolved;
}

}  // namespace

Verb sweep_verb() {
  const auto flags = std::make_shared<SweepFlags>();
  const TextCheck shard{[](const std::string& text) -> std::string {
    try {
      (void)Shard::parse(text);
      return {};
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }};
  // The program alone takes some 40 MiB.
  const TextCheck memory = number("0 or from 64 to 1e12", [](double mebibytes) {
    return mebibytes == 0.0 || (mebibytes >= 64.0 && mebibytes <= 1e12);
  });
  return {
      .name = "sweep",
      .text = "Solve the family of scenes of a problem file",
      .flags = flags->with(
          {directory_flag("--out", flags->out,
                          "Keep the results in DIR/sweep.sqlite", true),
           jobs_flag(flags->jobs),
           {.name = "--shard",
            .value = &flags->shard,
            .text = "Do the i-th of N parts only; `merge` joins them",
            .placeholder = "i/N",
            .check = shard},
           {"--resume", &flags->resume,
            "Go on with the results in DIR, if there are any"},
           {.name = "--retry-failed",
            .value = &flags->retry,
            .text = "Solve scenes again that no worker answered for",
            .needs = {"--resume"}},
           unless_resumed(flags->force),
           {.name = "--timeout",
            .value = &flags->timeout,
            .text = "Kill a worker that takes longer for one scene; default: "
                    "three times solver.limits.seconds and a minute",
            .placeholder = "SECONDS",
            .check = seconds()},
           {.name = "--memory",
            .value = &flags->memory,
            .text = "Bound on a worker's address space, 0 for none; default: "
                    "the machine's memory / N",
            .placeholder = "MIB",
            .check = memory},
           worker_flag(flags->program)}),
      .footer =
          R"(Examples:
  brachisto sweep map.yaml --out map
  brachisto sweep map.yaml --out map --resume
  brachisto sweep map.yaml --out part2 --shard 2/4
  brachisto export map --csv > map.csv
  brachisto report map
Exit codes: 0 all solved and verified, 3 bad input file, 4 some are
not, 6 I/O, 130/143 after SIGINT/SIGTERM with the results kept.)",
      .run = [flags] { return run(*flags); }};
}

Verb worker_verb() {
  return {.name = "worker",
          .text = "Solve what the manager of a sweep asks for",
          .run =
              [] {
                std::ios::sync_with_stdio(false);
                sweep::run_worker(std::cin, std::cout);
                return static_cast<int>(kSuccess);
              },
          .hidden = true};
}

}  // namespace brachisto::app
