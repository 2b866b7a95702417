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
#include "model/field.hpp"
#include "model/scene_coordinate.hpp"
#include "model/start_angle.hpp"
#include "model/units.hpp"
#include "model/world_part.hpp"

namespace brachisto::lanes {

namespace {

/// The law of a field with a kink that a path which stays on one side of it
/// has: with the body above A, and as it stands there above B.
FieldSide side_of(const Scene& natural) {
  const Point start = start_of_centre(natural);
  const double sum =
      height_above_surface(natural, start) +
      height_above_surface(natural, {natural.L + start.x, natural.H + start.z});
  return sum > 0.0 ? FieldSide::Outside : FieldSide::Inside;
}

/// The slope that a body has which is left at rest, whatever another start was
/// built from.
double slope_from_rest(const Scene& natural) {
  if (!natural.world.field_varies()) return start_angle(natural.body);
  Scene resting = natural;
  resting.world.start_slope.reset();
  return start_angle(resting);
}

Milestone milestone(const Scene& natural) {
  const Body& body = natural.body;
  return {.eta_m = body.eta_m,
          .theta_m = body.theta_m,
          .k = body.k,
          .contact_radius = contact_radius(natural),
          .rotation_per_length = arcs::rotation_per_length(natural),
          .L = natural.L,
          .H = natural.H,
          .start_angle = slope_from_rest(natural),
          .start_speed = natural.world.start_speed,
          .air = natural.world.air,
          .body_radius = body.radius,
          .sphere = natural.world.sphere.value_or(Sphere()),
          .field_share = natural.world.field_share};
}

/// From the cycloid.
/// \return nothing where there is none
bool aim(const Scene& natural, const Fineness& fineness, Target& out) {
  Scene on_the_way = part_of_world(natural, 0.0);
  const ExtremalGuess cycloid = cycloid_guess(on_the_way);
  if (!cycloid.state) return false;
  const ExtremalState start = cycloid.state(0.0);
  out.unknowns = {start.p_x, start.p_z, 0.0, cycloid.rolling_time};
  out.sign = 0.0;
  out.side = natural.world.side.value_or(FieldSide::Outside);
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
  out.side = natural.world.side.value_or(FieldSide::Outside);
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

/// Calls run(kernel) with the one of a set of instructions.
template <Surroundings In>
void with_kernel([[maybe_unused]] Instructions instructions, auto&& run) {
#if defined(__x86_64__)
  if (instructions == Instructions::Avx512) {
    return run(Kernel<Instructions::Avx512, In>());
  }
  if (instructions == Instructions::Avx2) {
    return run(Kernel<Instructions::Avx2, In>());
  }
#endif
  run(Kernel<Instructions::Baseline, In>());
}
/// The one with the fewest lanes for so many scenes.
Instructions enough_for(std::size_t scenes, Instructions best) {
  Instructions set = Instructions::Baseline;
  while (set != best && lanes_of(set) < scenes) {
    set = static_cast<Instructions>(static_cast<int>(set) + 1);
  }
  return set;
}

/// Does with targets, a register full at a time, what a kernel can.
template <Surroundings In, class Out>
void in_lanes(std::span<const std::size_t> places, Instructions instructions,
              auto&& aim_at, auto&& run, std::vector<Out>& out) {
  Targets targets;
  const auto found = std::make_unique<std::array<Out, kMostLanes>>();
  const std::size_t lanes = lanes_of(instructions);
  for (std::size_t first = 0; first < places.size(); first += lanes) {
    const auto here =
        places.subspan(first, std::min(lanes, places.size() - first));
    std::array<bool, kMostLanes> aimed{};
    std::size_t some = kMostLanes;
    for (std::size_t i = 0; i < here.size(); ++i) {
      aimed[i] = aim_at(here[i], targets[i]);
      if (aimed[i]) some = i;
    }
    if (some == kMostLanes) continue;
    // A lane that nobody needs does what another one does.
    for (std::size_t i = 0; i < lanes; ++i) {
      if (!aimed[i]) targets[i] = targets[some];
    }
    with_kernel<In>(enough_for(here.size(), instructions),
                    [&](auto kernel) { run(kernel, targets, *found); });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (aimed[i]) out[here[i]] = (*found)[i];
    }
  }
}
/// Those from rest or pushed, in air or not, and by their field, each kind
/// apart: what a scene is worked out by does not depend on which stand beside
/// it.
template <class Out>
std::vector<Out> in_lanes(std::span<const Scene> scenes,
                          Instructions instructions, auto&& aim_at,
                          auto&& run) {
  instructions = std::min(instructions, best_instructions());
  std::vector<Out> out(scenes.size());
  constexpr std::size_t kPushed = 1, kInAir = 2, kOutside = 4, kInside = 8;
  std::array<std::vector<std::size_t>, 12> places;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const World& world = scenes[i].world;
    std::size_t kind = 0;
    if (world.start_speed > 0.0) kind |= kPushed;
    if (world.air.any()) kind |= kInAir;
    if (world.field_varies()) {
      kind |= world.side == FieldSide::Inside ? kInside : kOutside;
    }
    places[kind].push_back(i);
  }
  const auto shoot_all = [&]<Surroundings In>(std::size_t kind) {
    for (const std::size_t left : {kind, kind | kPushed}) {
      in_lanes<In>(places[left], instructions, aim_at, run, out);
    }
  };
  shoot_all.template operator()<Surroundings{}>(0);
  shoot_all.template operator()<Surroundings{.air = true}>(kInAir);
  for (const std::size_t side : {kOutside, kInside}) {
    shoot_all.template operator()<Surroundings{.field = true}>(side);
    shoot_all.template operator()<Surroundings{.air = true, .field = true}>(
        side | kInAir);
  }
  return out;
}

Scene as_shot_for(const Scene& scene) {
  Scene natural = in_natural_units(without_whole_turns(scene));
  if (has_surface(natural.world)) natural.world.side = side_of(natural);
  return natural;
}
std::vector<Scene> as_shot_for(std::span<const Scene> scenes) {
  std::vector<Scene> out;
  for (const Scene& scene : scenes) out.push_back(as_shot_for(scene));
  return out;
}

/// Whether the law of the field is right for it everywhere.
bool keeps_its_side(const Scene& natural, const Extremal& extremal) {
  for (int i = 0; i <= extremal.places && natural.world.side; ++i) {
    const Place& at = extremal.path[static_cast<std::size_t>(i)];
    const double beyond = beyond_surface(natural, at.x, at.z, at.theta);
    if (!(beyond <= kBeyondSurface)) return false;
  }
  return true;
}

}  // namespace

double beyond_surface(const Scene& natural, double x, double z, double theta) {
  if (!natural.world.side) return 0.0;
  const double height = height_of_mass(natural, x, z, theta);
  return natural.world.side == FieldSide::Outside ? -height : height;
}

bool fits(const Scene& scene) {
  const World& world = scene.world;
  return scene.body.rolls() && (!world.field_varies() || world.sphere) &&
         !world.losses.any() && !scene.limits.any() && scene.path == nullptr &&
         (scene.contact == Contact::Smooth || scene.contact == Contact::Centre);
}

Instructions best_instructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return Instructions::Avx512;
  if (__builtin_cpu_supports("avx2")) return Instructions::Avx2;
#endif
  return Instructions::Baseline;
}

namespace {

std::vector<Extremal> shot(std::span<const Scene> natural,
                           const Fineness& fineness, Instructions instructions,
                           auto&& aim_at) {
  std::vector<Extremal> out = in_lanes<Extremal>(
      natural, instructions,
      [&](std::size_t i, Target& target) {
        return fits(natural[i]) && aim_at(i, target);
      },
      [&](auto kernel, const Targets& targets, Extremals& found) {
        kernel.shoot(targets, fineness, found);
      });
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].side = natural[i].world.side;
    out[i].found = out[i].found && keeps_its_side(natural[i], out[i]);
  }
  return out;
}

}  // namespace

std::vector<Extremal> shoot(std::span<const Scene> scenes,
                            const Fineness& fineness,
                            Instructions instructions) {
  const std::vector<Scene> natural = as_shot_for(scenes);
  return shot(natural, fineness, instructions,
              [&](std::size_t i, Target& target) {
                return aim(natural[i], fineness, target);
              });
}

std::vector<Extremal> shoot_beside(std::span<const Scene> scenes,
                                   const Scene& from, const Extremal& known,
                                   const Fineness& fineness,
                                   Instructions instructions) {
  const std::vector<Scene> natural = as_shot_for(scenes);
  const Scene before = as_shot_for(from);
  return shot(
      natural, fineness, instructions, [&](std::size_t i, Target& target) {
        target = aim_beside(natural[i], before, known, fineness.offsets);
        return true;
      });
}

namespace {

/// As an extremal was shot for, one step between two of its places.
template <class Out>
std::vector<Out> shot_again(std::span<const Scene> natural,
                            const Extremal& extremal, Instructions instructions,
                            auto&& run) {
  const Fineness fineness{1, 0, extremal.places, 2};
  return in_lanes<Out>(
      natural, instructions,
      [&](std::size_t i, Target& target) {
        target = aim_beside(natural[i], natural[i], extremal, fineness.offsets);
        return true;
      },
      [&](auto kernel, const Targets& targets, auto& found) {
        run(kernel, targets, fineness, found);
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
