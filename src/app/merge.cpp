// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto merge DIR…: parts of a sweep into one.

#include <fmt/format.h>
#include <memory>

#include <nlohmann/json.hpp>
#include <utility>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/result.hpp"
#include "io/visible_text.hpp"
#include "report/in_full.hpp"
#include "sweep/directory_lock.hpp"
#include "sweep/merge.hpp"

namespace brachisto::app {

namespace {

using sweep::Store;

struct MergeFlags {
  std::vector<std::string> parts;
  std::string out;
  bool json = false;
  bool quiet = false;
};

/// "19: scenes 0–15, 32, 40–41": how many, and which.
std::string listed(const std::vector<std::size_t>& scenes) {
  if (scenes.empty()) return "0";
  return fmt::format("{}: {}", scenes.size(), sweep::scene_ranges(scenes));
}

/// Opens the store that the parts come into, or makes it.
Store open_target(const std::string& directory, const sweep::StoreInfo& info) {
  if (!Store::exists(directory)) return Store::create(directory, info);
  Store target = Store::open(directory, sweep::Database::Access::ReadWrite);
  if (target.info().input_hash != info.input_hash ||
      target.info().version != info.version) {
    throw sweep::StoreError(directory + ": holds another sweep");
  }
  return target;
}

sweep::MergeReport join(const MergeFlags& flags, const sweep::Job& job,
                        const sweep::StoreInfo& info) {
  const report::HeldSignals held;
  const sweep::DirectoryLock lock(flags.out);
  std::vector<Store> parts =
      sweep::open_parts({flags.parts.begin(), flags.parts.end()}, info);
  const bool is_new = !Store::exists(flags.out);
  try {
    Store target = open_target(flags.out, info);
    const sweep::MergeReport report = merge(parts, target, job);
    for (const Store& part : parts) tell_damage(part);
    tell_damage(target);
    parts.clear();  // the target may be one of them, and be read no more
    return report;
  } catch (...) {
    if (is_new) Store::remove(flags.out);
    throw;
  }
}

int run(const MergeFlags& flags) {
  auto [job, info] = [&] {
    const Store first =
        Store::open(flags.parts.front(), sweep::Database::Access::ReadOnly);
    return std::pair(first.job(), first.info());
  }();
  info.shard = sweep::kMerged;
  const sweep::MergeReport report = join(flags, job, info);
  const std::size_t scenes = job.file.num_scenes();
  const std::size_t finished = scenes - report.gaps.size();
  if (flags.json) {
    const nlohmann::ordered_json document = {
        {"schema_version", report::kSchemaVersion},
        {"scenes", scenes},
        {"finished", finished},
        {"added", report.added},
        {"overlaps", report.overlaps},
        {"conflicts", report.conflicts},
        {"gaps", report.gaps}};
    print_json(document);
  } else if (!flags.quiet) {
    print(
        fmt::format("{}: {} of {} scenes, {} of them added now\n"
                    "  in several parts, alike: {}\n"
                    "  in several parts, different: {}\n"
                    "  in no part: {}\n",
                    io::visible(flags.out), finished, scenes, report.added,
                    listed(report.overlaps), listed(report.conflicts),
                    listed(report.gaps)));
  }
  if (report.damaged) return kIoError;
  return report.conflicts.empty() ? kSuccess : kNotSolved;
}

}  // namespace

Verb merge_verb() {
  const auto flags = std::make_shared<MergeFlags>();
  return {
      .name = "merge",
      .text = "Join parts of a sweep into one",
      .flags = {{.name = "DIR",
                 .value = &flags->parts,
                 .text = "Directories of the parts",
                 .check = not_empty(),
                 .required = true},
                directory_flag(
                    "--out", flags->out,
                    "Directory of the whole; it may exist and be part of it",
                    true),
                json_flag(flags->json),
                {"--quiet", &flags->quiet, "Print no results"}},
      .footer =
          R"(Example:
  brachisto merge part1 part2 part3 part4 --out map
Exit codes: 0 joined, perhaps with gaps, which are listed; 4 parts have
different results for a scene; 6 I/O, parts of different sweeps, or
damaged results that are sound in no part.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
