// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "limits/random_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "campaign/random_scene.hpp"
#include "math/portable_random.hpp"
#include "trajectory/stated_limits.hpp"

namespace brachisto::benchmarks {

namespace {

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

/// See under_random_limits().
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

}  // namespace

std::optional<LimitedScene> under_random_limits(Scene scene, std::uint64_t seed,
                                                int index) {
  const Solution free = solve(scene);
  if (!free.verified()) return std::nullopt;
  SplitMix64 random(SplitMix64::scrambled(seed) +
                    static_cast<std::uint64_t>(index));
  add_limits(scene, *free.motion(), random);
  return LimitedScene{std::move(scene), free.motion()->tau()};
}

void add_losses(Scene& scene, std::uint64_t seed, int index) {
  // Another stream than that of the limits.
  SplitMix64 random(SplitMix64::scrambled(seed + 1) +
                    static_cast<std::uint64_t>(index));
  scene.world.losses.rolling = random.uniform(0.002, 0.05);
  PathLimits& limits = scene.limits;
  if (!limits.friction || limits.normal_min) {
    limits.normal_min = std::max(0.0, limits.normal_min.value_or(0.0));
  }
}

std::optional<LimitedScene> random_limited_scene(std::uint64_t seed,
                                                 int index) {
  return under_random_limits(random_scene(seed, index), seed, index);
}

std::string described(const Scene& scene) {
  std::string text = scene.contact == Contact::Optimal ? "optimal" : "smooth";
  for (const StatedLimit& limit : stated_limits(scene)) {
    text += fmt::format(" {} {:.4g}", limit.name, *limit.bound);
  }
  if (scene.world.losses.any()) {
    text += fmt::format(" rolling {:.4g}", scene.world.losses.rolling);
  }
  return text;
}

}  // namespace brachisto::benchmarks
