// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Random scenes, each solved by the nonlinear program and, independently, by
// the indirect method.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "campaign/random_scene.hpp"
#include "campaign/record.hpp"
#include "campaign/summary.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

struct Flags {
  std::uint64_t seed = 1;
  int count = 1000;
  int first = 0;
  ProcessLimits limits{.jobs = 1, .seconds = 900};
  std::string out = BRACHISTO_SOURCE_DIR "/benchmarks/results/campaign.csv";
};

int run(const Flags& flags) {
  std::vector<Examined> all;
  for (int i = 0; i < flags.count; ++i) {
    const int index = flags.first + i;
    all.push_back({index, random_scene(flags.seed, index), {}});
  }
  int finished = 0;
  run_isolated<Record>(
      flags.count, flags.limits,
      [&](int i) { return examine(all[static_cast<std::size_t>(i)].scene); },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        Examined& one = all[static_cast<std::size_t>(i)];
        if (record) {
          one.record = *record;
        } else {
          one.record.reason = FixedText<400>(fate);
        }
        if (one.record.verdict != Verdict::Agrees) {
          fmt::print(stderr, "scene {}: {} {}\n", one.index,
                     word(one.record.verdict), one.record.reason.str());
        }
        if (++finished % 100 == 0) {
          fmt::print(stderr, "{} of {}\n", finished, flags.count);
        }
      });

  std::string csv = csv_head();
  for (const Examined& one : all) {
    csv += csv_line(one.index, one.scene, one.record);
  }
  write_file(flags.out, csv);
  const Verdicts verdicts = count(all);
  fmt::print("Seed {}, scenes {} to {}. {}.\n\n{}\n", flags.seed, flags.first,
             flags.first + flags.count - 1, machine(), summary(all));
  fmt::print("{}: {:.2f} % verified (wanted {:.1f} %), {} disagreeing\n",
             verdicts.passed() ? "passed" : "FAILED", 100.0 * verdicts.share(),
             100.0 * kWantedShare, verdicts.disagreeing);
  return verdicts.passed() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Flags flags;
  CLI::App app{"Random scenes, solved by two independent methods"};
  app.add_option("--seed", flags.seed, "Of the random scenes")
      ->capture_default_str();
  app.add_option("--count", flags.count, "How many scenes")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first", flags.first, "Number of the first scene")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--jobs", flags.limits.jobs, "Processes at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", flags.limits.seconds, "For one scene, at most")
      ->capture_default_str();
  app.add_option("--out", flags.out, "CSV file")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return run(flags);
}
