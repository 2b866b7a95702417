// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/many_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "extremal/arc_flow.hpp"
#include "extremal/shooting.hpp"
#include "lanes/kernels.hpp"
#include "model/contact.hpp"
#include "model/scene_coordinate.hpp"
#include "model/start_angle.hpp"
#include "model/units.hpp"

namespace brachisto::lanes {

namespace {

Milestone milestone(const Scene& natural) {
  const Body& body = natural.body;
  return {.eta_m = body.eta_m,
          .theta_m = body.theta_m,
          .k = body.k,
          .contact_radius = contact_radius(natural),
          .rotation_per_length = arcs::rotation_per_length(natural),
          .L = natural.L,
          .H = natural.H,
          .start_angle = start_angle(body)};
}

/// From the cycloid.
/// \return nothing where there is none
bool aim(const Scene& natural, int offsets, Target& out) {
  const ExtremalGuess cycloid = cycloid_guess(natural);
  if (!cycloid.state) return false;
  const ExtremalState start = cycloid.state(0.0);
  out.unknowns = {start.p_x, start.p_z, 0.0, cycloid.rolling_time};
  out.sign = 0.0;
  Scene on_the_way = natural;
  for (int i = 0; i <= offsets; ++i) {
    on_the_way.body.eta_m = natural.body.eta_m * i / offsets;
    out.way[static_cast<std::size_t>(i)] = milestone(on_the_way);
  }
  return true;
}

/// From a known extremal.
Target aim_beside(const Scene& natural, Scene from, const Extremal& known,
                  int offsets) {
  Target out;
  out.unknowns = known.unknowns;
  out.sign = known.sign;
  // The same direction of the offset may be another angle.
  from.body.theta_m = natural.body.theta_m -
                      std::remainder(natural.body.theta_m - from.body.theta_m,
                                     2.0 * std::numbers::pi);
  for (int i = 1; i <= offsets; ++i) {
    out.way[static_cast<std::size_t>(i)] =
        milestone(i == offsets ? natural
                               : between(from, natural,
                                         static_cast<double>(i) / offsets));
  }
  return out;
}

/// Calls run(kernel) with the one for so many scenes.
void with_kernel(std::size_t count, [[maybe_unused]] Instructions instructions,
                 auto&& run) {
  if (count <= kFewLanes) {
    return run(Kernel<Instructions::Baseline, kFewLanes>());
  }
#if defined(__x86_64__)
  if (instructions == Instructions::Avx512) {
    return run(Kernel<Instructions::Avx512>());
  }
  if (instructions == Instructions::Avx2) {
    return run(Kernel<Instructions::Avx2>());
  }
#endif
  run(Kernel<Instructions::Baseline>());
}

/// Does with eight targets at a time what a kernel can.
template <class Out, class Aim>
std::vector<Out> in_eights(std::size_t count, Instructions instructions,
                           Aim&& aim_at, auto&& run) {
  std::vector<Out> out(count);
  Targets targets;
  const auto eight = std::make_unique<std::array<Out, kLanes>>();
  for (std::size_t first = 0; first < count; first += kLanes) {
    const std::size_t here = std::min(kLanes, count - first);
    std::array<bool, kLanes> aimed{};
    std::size_t some = kLanes;
    for (std::size_t i = 0; i < here; ++i) {
      aimed[i] = aim_at(first + i, targets[i]);
      if (aimed[i]) some = i;
    }
    if (some == kLanes) continue;
    // A lane that nobody needs does what another one does.
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (!aimed[i]) targets[i] = targets[some];
    }
    with_kernel(here, instructions,
                [&](auto kernel) { run(kernel, targets, *eight); });
    for (std::size_t i = 0; i < here; ++i) {
      if (aimed[i]) out[first + i] = (*eight)[i];
    }
  }
  return out;
}

/// \return nothing where it is not one of those that are solved side by side
std::optional<Scene> as_shot_for(const Scene& scene) {
  const Scene natural = in_natural_units(without_whole_turns(scene));
  return fits(natural) ? std::optional(natural) : std::nullopt;
}

}  // namespace

bool fits(const Scene& scene) {
  return scene.body.rolls() && scene.world.ordinary() && !scene.limits.any() &&
         scene.path == nullptr &&
         (scene.contact == Contact::Smooth || scene.contact == Contact::Centre);
}

Instructions best_instructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return Instructions::Avx512;
  if (__builtin_cpu_supports("avx2")) return Instructions::Avx2;
#endif
  return Instructions::Baseline;
}

std::vector<Extremal> shoot(std::span<const Scene> scenes,
                            const Fineness& fineness,
                            Instructions instructions) {
  return in_eights<Extremal>(
      scenes.size(), instructions,
      [&](std::size_t i, Target& target) {
        const std::optional<Scene> natural = as_shot_for(scenes[i]);
        return natural && aim(*natural, fineness.offsets, target);
      },
      [&](auto kernel, const Targets& targets, Extremals& eight) {
        kernel.shoot(targets, fineness, eight);
      });
}

std::vector<Extremal> shoot_beside(std::span<const Scene> scenes,
                                   const Scene& from, const Extremal& known,
                                   const Fineness& fineness,
                                   Instructions instructions) {
  const Scene before = in_natural_units(without_whole_turns(from));
  return in_eights<Extremal>(
      scenes.size(), instructions,
      [&](std::size_t i, Target& target) {
        const std::optional<Scene> natural = as_shot_for(scenes[i]);
        if (!natural) return false;
        target = aim_beside(*natural, before, known, fineness.offsets);
        return true;
      },
      [&](auto kernel, const Targets& targets, Extremals& eight) {
        kernel.shoot(targets, fineness, eight);
      });
}

std::vector<Landing> land(std::span<const Scene> natural,
                          const Extremal& extremal, Instructions instructions) {
  const Fineness fineness{1, 0, extremal.places, 1};
  return in_eights<Landing>(
      natural.size(), instructions,
      [&](std::size_t i, Target& target) {
        target = aim_beside(natural[i], natural[i], extremal, fineness.offsets);
        return true;
      },
      [&](auto kernel, const Targets& targets, Landings& eight) {
        kernel.land(targets, fineness, eight);
      });
}

}  // namespace brachisto::lanes
