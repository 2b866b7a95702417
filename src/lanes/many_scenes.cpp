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
#include "model/world_part.hpp"

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
          .start_angle = start_angle(body),
          .start_speed = natural.world.start_speed,
          .air = natural.world.air};
}

/// From the cycloid.
/// \return nothing where there is none
bool aim(const Scene& natural, const Fineness& fineness, Target& out) {
  Scene on_the_way = in_ordinary_world(natural);
  const ExtremalGuess cycloid = cycloid_guess(on_the_way);
  if (!cycloid.state) return false;
  const ExtremalState start = cycloid.state(0.0);
  out.unknowns = {start.p_x, start.p_z, 0.0, cycloid.rolling_time};
  out.sign = 0.0;
  auto next = out.way.begin();
  for (int i = 0; i <= fineness.offsets; ++i) {
    on_the_way.body.eta_m = natural.body.eta_m * i / fineness.offsets;
    *next++ = milestone(on_the_way);
  }
  const int more = natural.world.ordinary() ? 0 : fineness.into_world;
  out.steps = fineness.offsets + more;
  for (int i = 1; i <= more; ++i) {
    *next++ = milestone(part_of_world(natural, static_cast<double>(i) / more));
  }
  return true;
}

/// From a known extremal.
Target aim_beside(const Scene& natural, Scene from, const Extremal& known,
                  int offsets) {
  Target out;
  out.unknowns = known.unknowns;
  out.sign = known.sign;
  out.steps = offsets;
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
template <Falling Where>
void with_kernel(std::size_t count, [[maybe_unused]] Instructions instructions,
                 auto&& run) {
  if (count <= kFewLanes) {
    return run(Kernel<Instructions::Baseline, kFewLanes, Where>());
  }
#if defined(__x86_64__)
  if (instructions == Instructions::Avx512) {
    return run(Kernel<Instructions::Avx512, kLanes, Where>());
  }
  if (instructions == Instructions::Avx2) {
    return run(Kernel<Instructions::Avx2, kLanes, Where>());
  }
#endif
  run(Kernel<Instructions::Baseline, kLanes, Where>());
}

/// Does with eight targets at a time what a kernel can.
template <Falling Where, class Out>
void in_eights(std::span<const std::size_t> places, Instructions instructions,
               auto&& aim_at, auto&& run, std::vector<Out>& out) {
  Targets targets;
  const auto eight = std::make_unique<std::array<Out, kLanes>>();
  for (std::size_t first = 0; first < places.size(); first += kLanes) {
    const auto here =
        places.subspan(first, std::min(kLanes, places.size() - first));
    std::array<bool, kLanes> aimed{};
    std::size_t some = kLanes;
    for (std::size_t i = 0; i < here.size(); ++i) {
      aimed[i] = aim_at(here[i], targets[i]);
      if (aimed[i]) some = i;
    }
    if (some == kLanes) continue;
    // A lane that nobody needs does what another one does.
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (!aimed[i]) targets[i] = targets[some];
    }
    with_kernel<Where>(here.size(), instructions,
                       [&](auto kernel) { run(kernel, targets, *eight); });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (aimed[i]) out[here[i]] = (*eight)[i];
    }
  }
}
/// Those that fall freely, are pushed or are in air, each kind apart: what a
/// scene is worked out by does not depend on which stand beside it.
template <class Out>
std::vector<Out> in_eights(std::span<const Scene> scenes,
                           Instructions instructions, auto&& aim_at,
                           auto&& run) {
  std::vector<Out> out(scenes.size());
  std::array<std::vector<std::size_t>, 4> places;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const World& world = scenes[i].world;
    places[(world.air.any() ? 2 : 0) + (world.start_speed > 0.0 ? 1 : 0)]
        .push_back(i);
  }
  for (const std::size_t left : {0, 1}) {
    in_eights<Falling::Free>(places[left], instructions, aim_at, run, out);
    in_eights<Falling::InAir>(places[2 + left], instructions, aim_at, run, out);
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
  const World& world = scene.world;
  return scene.body.rolls() && !world.field_varies() && !world.losses.any() &&
         !scene.limits.any() && scene.path == nullptr &&
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
      scenes, instructions,
      [&](std::size_t i, Target& target) {
        const std::optional<Scene> natural = as_shot_for(scenes[i]);
        return natural && aim(*natural, fineness, target);
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
      scenes, instructions,
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

namespace {

/// As an extremal was shot for, one step between two of its places.
template <class Out>
std::vector<Out> shot_again(std::span<const Scene> natural,
                            const Extremal& extremal, Instructions instructions,
                            auto&& run) {
  const Fineness fineness{1, 0, extremal.places, 2};
  return in_eights<Out>(
      natural, instructions,
      [&](std::size_t i, Target& target) {
        target = aim_beside(natural[i], natural[i], extremal, fineness.offsets);
        return true;
      },
      [&](auto kernel, const Targets& targets, auto& eight) {
        run(kernel, targets, fineness, eight);
      });
}

}  // namespace

std::vector<Landing> land(std::span<const Scene> natural,
                          const Extremal& extremal, Instructions instructions) {
  return shot_again<Landing>(
      natural, extremal, instructions,
      [](auto kernel, auto&... with_out) { kernel.land(with_out...); });
}

Response respond(const Scene& natural, const Extremal& extremal) {
  return shot_again<Response>(std::span(&natural, 1), extremal,
                              Instructions::Baseline,
                              [](auto kernel, auto&... with_out) {
                                kernel.respond(with_out...);
                              })
      .front();
}

}  // namespace brachisto::lanes
