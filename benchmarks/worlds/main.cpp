// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Random scenes in other worlds, by the nonlinear program and by shooting.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "model/world_part.hpp"
#include "support/csv.hpp"
#include "support/drawn_scenes.hpp"
#include "support/table.hpp"
#include "support/text.hpp"
#include "worlds/random_world.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

enum class Fate {
  Agreed,      ///< both verified, times agree
  Refused,     ///< not a valid scene, with the reason
  NeitherOne,  ///< neither method finds an answer
  OneAlone,    ///< one method has a verified answer, the other none
  Differ,      ///< both verified, and times do not agree
  NoOrdinary,  ///< no verified answer in the ordinary world: not counted
  Lost,        ///< the process did not end
};
constexpr std::array kFates{"agreed", "refused",     "neither one", "one alone",
                            "differ", "no ordinary", "lost"};

/// Relative, of τ.
constexpr double kAgreement = 1e-9;

struct Record {
  Fate fate = Fate::Lost;
  double tau = 0.0, difference = 0.0, seconds = 0.0, other_seconds = 0.0;
  FixedText<160> world;
  FixedText<400> reason;
};

Record examine(std::uint64_t seed, int index) {
  Record record;
  const Scene scene = random_world_scene(seed, index);
  record.world = FixedText<160>(described_world(scene));
  const std::vector<SceneError> errors = validate(scene);
  if (!errors.empty()) {
    record.fate = Fate::Refused;
    record.reason = FixedText<400>(errors.front().message);
    return record;
  }
  if (!solve(in_ordinary_world(scene)).verified()) {
    record.fate = Fate::NoOrdinary;
    return record;
  }
  SolveOptions shooting;
  shooting.method = Shooting{};
  const Solution found = solve(scene);
  const Solution other = solve(scene, shooting);
  record.seconds = found.effort.seconds;
  record.other_seconds = other.effort.seconds;
  if (found.verified() && other.verified()) {
    record.tau = found.motion()->tau();
    record.difference = std::abs(other.motion()->tau() / record.tau - 1.0);
    record.fate = record.difference <= kAgreement ? Fate::Agreed : Fate::Differ;
    return record;
  }
  record.fate =
      found.verified() || other.verified() ? Fate::OneAlone : Fate::NeitherOne;
  record.reason = FixedText<400>(
      fmt::format("{}: {}", found.verified() ? "shooting" : "program",
                  why_not_verified(found.verified() ? other : found)));
  return record;
}

}  // namespace

int main(int argc, char** argv) {
  DrawnScenes scenes{
      .count = 200,
      .limits = {.seconds = 120},
      .out = BRACHISTO_SOURCE_DIR "/benchmarks/results/worlds.csv"};
  CLI::App app{"Random scenes in other worlds"};
  scenes.read_from(app);
  CLI11_PARSE(app, argc, argv);
  const auto& [seed, count, first, limits, out] = scenes;

  std::vector<Record> all(static_cast<std::size_t>(count));
  run_isolated<Record>(
      count, limits, [&](int i) { return examine(seed, first + i); },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        Record& one = all[static_cast<std::size_t>(i)];
        if (record) {
          one = *record;
        } else {
          one.reason = FixedText<400>(fate);
        }
        if (one.fate == Fate::Agreed || one.fate == Fate::NoOrdinary) return;
        fmt::print(stderr, "scene {}: {} ({}) {:.1e}: {}\n", first + i,
                   kFates.at(static_cast<std::size_t>(one.fate)),
                   one.world.str(), one.difference, one.reason.str());
      });

  std::string csv =
      "scene,fate,world,tau,difference,seconds,other_seconds,"
      "reason\n";
  std::map<Fate, int> fates;
  std::vector<double> seconds, differences;
  for (int i = 0; i < count; ++i) {
    const Record& one = all[static_cast<std::size_t>(i)];
    ++fates[one.fate];
    if (one.fate == Fate::Agreed) {
      seconds.push_back(one.seconds);
      differences.push_back(one.difference);
    }
    csv += fmt::format("{},{},{},{:.13g},{:.2g},{:.3f},{:.3f},{}\n", first + i,
                       kFates.at(static_cast<std::size_t>(one.fate)),
                       csv_field(one.world.str()), one.tau, one.difference,
                       one.seconds, one.other_seconds,
                       csv_field(one.reason.str()));
  }
  write_file(out, csv);
  fmt::print("{}\n\n", scenes.described());
  for (const auto& [fate, number] : fates) {
    fmt::print("{:>5} {}\n", number, kFates.at(static_cast<std::size_t>(fate)));
  }
  std::sort(seconds.begin(), seconds.end());
  std::sort(differences.begin(), differences.end());
  if (!seconds.empty()) {
    fmt::print("seconds: median {:.2f}, 90 % {:.2f}, most {:.2f}\n",
               percentile(seconds, 0.5), percentile(seconds, 0.9),
               seconds.back());
    fmt::print("differences of τ: median {:.1e}, most {:.1e}\n",
               percentile(differences, 0.5), differences.back());
  }
  const int counted = count - fates[Fate::NoOrdinary] - fates[Fate::Refused];
  const double share = 100.0 * fates[Fate::Agreed] / std::max(1, counted);
  constexpr double kWanted = 95.0;
  const bool passed = share >= kWanted && fates[Fate::Differ] == 0;
  fmt::print("{}: {:.1f} % of {} agree (wanted {:.0f} %), {} differ\n",
             passed ? "passed" : "FAILED", share, counted, kWanted,
             fates[Fate::Differ]);
  return passed ? 0 : 1;
}
