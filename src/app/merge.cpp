// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto merge DIR…: parts of a sweep into one.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/result_json.hpp"
#include "io/visible_text.hpp"
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

/// "3: 0–15, 32, 40–47": how many, and which.
std::string ranges(const std::vector<std::size_t>& scenes) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < scenes.size();) {
    std::size_t j = i;
    while (j + 1 < scenes.size() && scenes[j + 1] <= scenes[j] + 1) ++j;
    parts.push_back(scenes[i] == scenes[j]
                        ? fmt::format("{}", scenes[i])
                        : fmt::format("{}–{}", scenes[i], scenes[j]));
    i = j + 1;
  }
  return parts.empty()
             ? "0"
             : fmt::format("{}: {}", scenes.size(), fmt::join(parts, ", "));
}

int run(const MergeFlags& flags) {
  sweep::StoreInfo info =
      Store::open(flags.parts.front(), sweep::Database::Access::ReadOnly)
          .info();
  const sweep::Job job = sweep::job_from_line(info.job);
  info.shard = sweep::kMerged;
  const sweep::DirectoryLock lock(flags.out);
  std::vector<Store> parts =
      sweep::open_parts({flags.parts.begin(), flags.parts.end()}, info);
  Store target =
      Store::exists(flags.out)
          ? Store::open(flags.out, sweep::Database::Access::ReadWrite)
          : Store::create(flags.out, info);
  if (target.info().input_hash != info.input_hash ||
      target.info().version != info.version) {
    throw sweep::StoreError(flags.out + ": holds another sweep");
  }
  const sweep::MergeReport report = merge(parts, target, job);
  if (flags.json) {
    const nlohmann::ordered_json document = {
        {"schema_version", report::kSchemaVersion},
        {"scenes", job.file.num_scenes()},
        {"finished", target.num_results()},
        {"added", report.added},
        {"overlaps", report.overlaps},
        {"conflicts", report.conflicts},
        {"gaps", report.gaps}};
    print_data(document.dump(2) + "\n");
  } else if (!flags.quiet) {
    print(fmt::format(
        "{}: {} of {} scenes, {} of them added now\n"
        "  in several parts, alike: {}\n"
        "  in several parts, different: {}\n"
        "  in no part: {}\n",
        io::visible(flags.out), target.num_results(), job.file.num_scenes(),
        report.added, ranges(report.overlaps), ranges(report.conflicts),
        ranges(report.gaps)));
  }
  return report.conflicts.empty() ? kSuccess : kNotSolved;
}

}  // namespace

void add_merge(CLI::App& app, int& exit_code) {
  auto flags = std::make_shared<MergeFlags>();
  CLI::App* verb =
      app.add_subcommand("merge", "Join parts of a sweep into one");
  verb->add_option("DIR", flags->parts, "Directories of the parts")
      ->check(not_empty())
      ->required();
  verb->add_option("--out", flags->out,
                   "Directory of the whole; it may exist and be part of it")
      ->check(not_empty())
      ->required();
  verb->add_flag("--json", flags->json, "Print one JSON document to stdout");
  verb->add_flag("--quiet", flags->quiet, "Print no results");
  verb->footer(
      "Example:\n"
      "  brachisto merge part1 part2 part3 part4 --out map\n"
      "Exit codes: 0 joined, perhaps with gaps, which are listed; 4 parts "
      "have\n"
      "different results for a scene; 6 I/O, or parts of different sweeps.");
  verb->callback([flags, &exit_code] { exit_code = run(*flags); });
}

}  // namespace brachisto::app
