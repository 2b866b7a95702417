// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Random scenes with one to three limits, bounds drawn around what the free
// extremal does.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "campaign/random_scene.hpp"
#include "math/portable_random.hpp"
#include "support/csv.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"
#include "support/text.hpp"
#include "trajectory/stated_limits.hpp"

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

struct Record {
  Fate fate = Fate::Lost;
  double tau = 0.0, free_tau = 0.0, estimate = 0.0, seconds = 0.0;
  double excess = 0.0;
  int arcs = 0;
  FixedText<160> limits;
  FixedText<400> reason;
};

/// The value that a figure of the free motion is below for a share of the time,
/// u > 0.05 U.
double quantile(const Motion& motion, double share,
                double (*figure)(const TrajectoryPoint&)) {
  constexpr int kPlaces = 2000;
  std::vector<std::pair<double, double>> values;  // value, time
  double total = 0.0;
  TrajectoryPoint before = motion.at(0.05);
  for (int i = 1; i <= kPlaces; ++i) {
    const TrajectoryPoint here =
        motion.at(0.05 + 0.95 * static_cast<double>(i) / kPlaces);
    values.emplace_back(figure(here), here.t - before.t);
    total += here.t - before.t;
    before = here;
  }
  std::sort(values.begin(), values.end());
  double passed = 0.0;
  for (const auto& [value, time] : values) {
    passed += time;
    if (passed >= share * total) return value;
  }
  return values.back().first;
}

/// One to three of six limits; the slopes free where that is well posed, in
/// half of the cases.
void add_limits(Scene& scene, const Motion& free, SplitMix64& random) {
  constexpr double kShare = 0.95;
  const double r = scene.body.radius;
  scene.limits.curvature.of = CurvatureLimit::Of::Centre;
  std::vector<int> kinds{0, 1, 2, 3, 4, 5};
  const int count = 1 + static_cast<int>(random.uniform(0.0, 3.0));
  for (int i = 0; i < count; ++i) {
    const auto pick = static_cast<std::size_t>(
        random.uniform(0.0, static_cast<double>(kinds.size())));
    const int kind = kinds[pick];
    kinds.erase(kinds.begin() + static_cast<std::ptrdiff_t>(pick));
    const double factor = random.uniform(0.7, 1.3);
    PathLimits& limits = scene.limits;
    switch (kind) {
      case 0:
        limits.friction =
            factor * quantile(free, kShare, [](const TrajectoryPoint& p) {
              return std::abs(p.motion.R_t) / p.motion.R_n;
            });
        break;
      case 1:
        limits.normal_min =
            factor * quantile(free, 1.0 - kShare, [](const TrajectoryPoint& p) {
              return p.motion.R_n;
            });
        break;
      case 2:
        limits.normal_max =
            factor * quantile(free, kShare, [](const TrajectoryPoint& p) {
              return p.motion.R_n;
            });
        break;
      case 3:
        limits.curvature.hump =
            factor / r * quantile(free, kShare, [](const TrajectoryPoint& p) {
              return 1.0 - p.motion.fold_margin;
            });
        break;
      case 4:
        limits.curvature.valley =
            factor / r * quantile(free, kShare, [](const TrajectoryPoint& p) {
              return p.motion.fold_margin - 1.0;
            });
        break;
      default:
        limits.floor =
            r + factor * quantile(free, kShare, [](const TrajectoryPoint& p) {
                  return p.centre.z;
                });
    }
  }
  const PathLimits& limits = scene.limits;
  const bool well_posed = limits.curvature.hump &&
                          *limits.curvature.hump < 1.0 / r &&
                          (limits.curvature.valley || limits.normal_max);
  if (well_posed && random.uniform() < 0.5) scene.contact = Contact::Optimal;
}

std::string described(const Scene& scene) {
  std::string text = scene.contact == Contact::Optimal ? "optimal" : "smooth";
  for (const StatedLimit& limit : stated_limits(scene)) {
    text += fmt::format(" {} {:.4g}", limit.name, *limit.bound);
  }
  return text;
}

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
      if (i < kPlaces / 100 && limit.power_of_length < 0) continue;
      worst = std::max(worst, -limit.slack(at));
    }
  }
  return worst;
}

Record examine(std::uint64_t seed, int index) {
  Record record;
  Scene scene = random_scene(seed, index);
  const Solution free = solve(scene);
  if (!free.verified()) {
    record.fate = Fate::NoFree;
    return record;
  }
  record.free_tau = free.motion()->tau();
  SplitMix64 random(SplitMix64::scrambled(seed) +
                    static_cast<std::uint64_t>(index));
  add_limits(scene, *free.motion(), random);
  record.limits = FixedText<160>(described(scene));
  const std::vector<SceneError> errors = validate(scene);
  if (!errors.empty()) {
    record.fate = Fate::Refused;
    record.reason = FixedText<400>(errors.front().message);
    return record;
  }
  const Solution found = solve(scene);
  record.seconds = found.effort.seconds;
  record.reason = FixedText<400>(why_not_verified(found));
  if (found.verified()) {
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
  std::uint64_t seed = 1;
  int count = 500;
  int first = 0;
  ProcessLimits limits{.jobs = 1, .seconds = 120};
  std::string out = BRACHISTO_SOURCE_DIR "/benchmarks/results/limits.csv";
  CLI::App app{"Random scenes under random limits"};
  app.add_option("--seed", seed, "Of the random scenes")->capture_default_str();
  app.add_option("--count", count, "How many scenes")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first", first, "Number of the first scene")
      ->capture_default_str();
  app.add_option("--jobs", limits.jobs, "Processes at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", limits.seconds, "For one scene, at most")
      ->capture_default_str();
  app.add_option("--out", out, "CSV file")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

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
        if (one.fate >= Fate::NoSmoothContact && one.fate != Fate::NoFree) {
          fmt::print(stderr, "scene {}: {} ({}): {}\n", first + i,
                     kFates.at(static_cast<std::size_t>(one.fate)),
                     one.limits.str(), one.reason.str());
        }
      });

  std::string csv =
      "scene,fate,limits,tau,free_tau,estimated_error,excess,arcs,seconds,"
      "reason\n";
  std::map<Fate, int> fates;
  std::vector<double> seconds;
  for (int i = 0; i < count; ++i) {
    const Record& one = all[static_cast<std::size_t>(i)];
    ++fates[one.fate];
    if (one.fate == Fate::Verified) seconds.push_back(one.seconds);
    csv += fmt::format("{},{},{},{:.13g},{:.13g},{:.2g},{:.2g},{},{:.3f},{}\n",
                       first + i, kFates.at(static_cast<std::size_t>(one.fate)),
                       csv_field(one.limits.str()), one.tau, one.free_tau,
                       one.estimate, one.excess, one.arcs, one.seconds,
                       csv_field(one.reason.str()));
  }
  write_file(out, csv);
  fmt::print("Seed {}, scenes {} to {}. {}.\n\n", seed, first,
             first + count - 1, machine());
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
  constexpr double kWanted = 98.0;
  const bool passed = share >= kWanted && fates[Fate::Violating] == 0;
  fmt::print("{}: {:.1f} % of {} (wanted {:.0f} %), {} violating\n",
             passed ? "passed" : "FAILED", share, counted, kWanted,
             fates[Fate::Violating]);
  return passed ? 0 : 1;
}
