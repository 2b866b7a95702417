// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Random scenes with one to three limits, bounds drawn around what the free
// extremal does, in the ordinary world or in others.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "campaign/random_scene.hpp"
#include "limits/random_limits.hpp"
#include "support/csv.hpp"
#include "support/drawn_scenes.hpp"
#include "support/table.hpp"
#include "support/text.hpp"
#include "trajectory/stated_limits.hpp"
#include "worlds/random_world.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

enum class Fate {
  Verified,         ///< solved, every check passed
  Refused,          ///< the limits cannot be kept, with a proof
  NoSmoothContact,  ///< confirmed by a scan
  Infeasible,       ///< a local certificate of infeasibility
  Unsolved,
  Violating,  ///< verified, and a bound is exceeded all the same
  NoFree,     ///< the free scene has no answer: not counted
  Lost,       ///< the process did not end
};
constexpr std::array kFates{"verified",   "refused",  "no smooth contact",
                            "infeasible", "unsolved", "violating",
                            "no free",    "lost"};

/// What the indirect method says of a verified one.
enum class Word { NotAsked, Agrees, Differs, None };
constexpr std::array kWords{"", "agrees", "differs", "none"};

struct Record {
  Fate fate = Fate::Lost;
  Word witness = Word::NotAsked;
  double apart = 0.0;  ///< |τ/τ of the witness − 1|
  double tau = 0.0, free_tau = 0.0, estimate = 0.0, seconds = 0.0;
  double excess = 0.0;
  int arcs = 0;
  FixedText<160> world;  ///< empty: the ordinary one
  FixedText<160> limits;
  FixedText<400> reason;
  FixedText<200> no_witness;  ///< why not
};

/// By how much a bound is exceeded on a fine grid; one of curvature for u >
/// 0.01 U, since before κ = q/w has fewer digits than the bound of q.
double worst_excess(const Solution& solution) {
  constexpr int kPlaces = 20000;
  const std::vector<StatedLimit> limits = stated_limits(solution.scene);
  double worst = 0.0;
  for (int i = 1; i <= kPlaces; ++i) {
    const TrajectoryPoint at =
        solution.motion()->at(static_cast<double>(i) / kPlaces);
    for (const StatedLimit& limit : limits) {
      if (i < kPlaces / 100 && limit.name.starts_with("curvature")) continue;
      worst = std::max(worst, -limit.slack(at));
    }
  }
  return worst;
}

/// Verified, whatever the witness says.
bool verified_alone(const Solution& solution) {
  return solution.status == Status::Solved &&
         std::ranges::all_of(
             solution.certificate.checks, [](const Check& check) {
               return check.passed || check.name.starts_with("extremal");
             });
}

void hear(const Solution& found, Record& record) {
  constexpr double kSame = 1e-10;
  if (!found.extremal) return;
  record.apart = found.extremal->difference;
  record.no_witness = FixedText<200>(found.extremal->message);
  record.witness = !found.extremal->solved ? Word::None
                   : record.apart <= kSame ? Word::Agrees
                                           : Word::Differs;
}

/// What is drawn and how it is judged.
struct Campaign {
  DrawnScenes scenes{
      .count = 500,
      .limits = {.seconds = 120},
      .out = BRACHISTO_SOURCE_DIR "/benchmarks/results/limits.csv"};
  bool worlds = false;
  bool losses = false;
  bool witness = false;
  std::string problems;  ///< folder for files, empty: none
};

/// The one that limits are drawn round.
Scene free_scene(const Campaign& campaign, int index) {
  const std::uint64_t seed = campaign.scenes.seed;
  return campaign.worlds ? random_world_scene(seed, index)
                         : random_scene(seed, index);
}

Record examine(const Campaign& campaign, int index) {
  Record record;
  const std::uint64_t seed = campaign.scenes.seed;
  const Scene free = free_scene(campaign, index);
  record.world = FixedText<160>(described_world(free));
  auto limited = validate(free).empty() ? under_random_limits(free, seed, index)
                                        : std::nullopt;
  if (!limited) {
    record.fate = Fate::NoFree;
    return record;
  }
  if (campaign.losses) add_losses(limited->scene, seed, index);
  const Scene& scene = limited->scene;
  record.free_tau = limited->free_tau;
  record.limits = FixedText<160>(described(scene));
  const std::vector<SceneError> errors = validate(scene);
  if (!errors.empty()) {
    record.fate = Fate::Refused;
    record.reason = FixedText<400>(errors.front().message);
    return record;
  }
  Collocation options;
  if (campaign.witness) options.certify = Certify::Extremal;
  if (!campaign.problems.empty()) {
    write_file(fmt::format("{}/{}.yaml", campaign.problems, index),
               report::input_json(scene, {.method = options}));
  }
  const Solution found = solve(scene, {.method = options});
  record.seconds = found.effort.seconds;
  record.reason = FixedText<400>(why_not_verified(found));
  if (verified_alone(found)) {
    hear(found, record);
    record.tau = found.motion()->tau();
    record.estimate = found.estimated_error.value_or(0.0);
    record.excess = worst_excess(found);
    constexpr double kAllowed = 1e-8;
    record.fate = record.excess <= kAllowed ? Fate::Verified : Fate::Violating;
    for (const LimitOnPath& limit : found.limits) {
      record.arcs += static_cast<int>(limit.active.size());
    }
    return record;
  }
  switch (found.status) {
    case Status::NoAdmissiblePath:
    case Status::NoFastestTrack:
      record.fate = Fate::Refused;
      break;
    case Status::NoSmoothContact:
      record.fate = Fate::NoSmoothContact;
      break;
    case Status::Infeasible:
      record.fate = Fate::Infeasible;
      break;
    default:
      record.fate = Fate::Unsolved;
  }
  return record;
}

}  // namespace

int main(int argc, char** argv) {
  Campaign campaign;
  CLI::App app{"Random scenes under random limits"};
  campaign.scenes.read_from(app);
  app.add_flag("--worlds", campaign.worlds,
               "Each in a random world, around what is free there");
  app.add_flag("--losses", campaign.losses, "With rolling resistance");
  app.add_flag("--witness", campaign.witness,
               "Solve once more by the indirect method what is verified");
  app.add_option("--problems", campaign.problems,
                 "Folder for a problem file of each scene, for the command");
  CLI11_PARSE(app, argc, argv);
  const auto& [seed, count, first, limits, out] = campaign.scenes;

  std::vector<Record> all(static_cast<std::size_t>(count));
  run_isolated<Record>(
      count, limits, [&](int i) { return examine(campaign, first + i); },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        Record& one = all[static_cast<std::size_t>(i)];
        if (record) {
          one = *record;
        } else {
          one.world =
              FixedText<160>(described_world(free_scene(campaign, first + i)));
          one.reason = FixedText<400>(fate);
        }
        if (one.fate >= Fate::NoSmoothContact && one.fate != Fate::NoFree) {
          fmt::print(stderr, "scene {}: {} ({}; {}): {}\n", first + i,
                     kFates.at(static_cast<std::size_t>(one.fate)),
                     one.world.str(), one.limits.str(), one.reason.str());
        }
      });

  std::string csv =
      "scene,fate,world,limits,tau,free_tau,estimated_error,excess,arcs,"
      "seconds,witness,apart,reason,no_witness\n";
  std::map<Fate, int> fates;
  std::map<Word, int> words;
  std::vector<double> seconds, apart;
  for (int i = 0; i < count; ++i) {
    const Record& one = all[static_cast<std::size_t>(i)];
    ++fates[one.fate];
    ++words[one.witness];
    if (one.fate == Fate::Verified) seconds.push_back(one.seconds);
    if (one.witness == Word::Agrees || one.witness == Word::Differs) {
      apart.push_back(one.apart);
    }
    csv += fmt::format(
        "{},{},{},{},{:.13g},{:.13g},{:.2g},{:.2g},{},{:.3f},{},{:.2g},{},{}"
        "\n",
        first + i, kFates.at(static_cast<std::size_t>(one.fate)),
        csv_field(one.world.str()), csv_field(one.limits.str()), one.tau,
        one.free_tau, one.estimate, one.excess, one.arcs, one.seconds,
        kWords.at(static_cast<std::size_t>(one.witness)), one.apart,
        csv_field(one.reason.str()), csv_field(one.no_witness.str()));
  }
  write_file(out, csv);
  fmt::print("{}\n\n", campaign.scenes.described());
  const int counted = count - fates[Fate::NoFree];
  int good = 0;
  for (const auto& [fate, number] : fates) {
    fmt::print("{:>5} {}\n", number, kFates.at(static_cast<std::size_t>(fate)));
    if (fate <= Fate::Infeasible) good += number;
  }
  const double share = 100.0 * good / std::max(1, counted);
  std::sort(seconds.begin(), seconds.end());
  if (!seconds.empty()) {
    fmt::print("seconds: median {:.2f}, 90 % {:.2f}, most {:.2f}\n",
               percentile(seconds, 0.5), percentile(seconds, 0.9),
               seconds.back());
  }
  if (campaign.witness) {
    fmt::print("the indirect method: {} agree to 1e-10, {} differ, {} none\n",
               words[Word::Agrees], words[Word::Differs], words[Word::None]);
    std::sort(apart.begin(), apart.end());
    if (!apart.empty()) {
      fmt::print("τ apart: median {:.1e}, 90 % {:.1e}, most {:.1e}\n",
                 percentile(apart, 0.5), percentile(apart, 0.9), apart.back());
    }
  }
  constexpr double kWanted = 98.0;
  const bool passed = share >= kWanted && fates[Fate::Violating] == 0;
  fmt::print("{}: {:.1f} % of {} (wanted {:.0f} %), {} violating\n",
             passed ? "passed" : "FAILED", share, counted, kWanted,
             fates[Fate::Violating]);
  return passed ? 0 : 1;
}
