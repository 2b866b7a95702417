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
#include "support/drawn_scenes.hpp"
#include "support/table.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

int run(const DrawnScenes& flags) {
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
  fmt::print("{}\n\n{}\n", flags.described(), summary(all));
  fmt::print("{}: {:.2f} % verified (wanted {:.1f} %), {} disagreeing\n",
             verdicts.passed() ? "passed" : "FAILED", 100.0 * verdicts.share(),
             100.0 * kWantedShare, verdicts.disagreeing);
  return verdicts.passed() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  DrawnScenes flags{
      .count = 1000,
      .limits = {.seconds = 900},
      .out = BRACHISTO_SOURCE_DIR "/benchmarks/results/campaign.csv"};
  CLI::App app{"Random scenes, solved by two independent methods"};
  flags.read_from(app);
  CLI11_PARSE(app, argc, argv);
  return run(flags);
}
