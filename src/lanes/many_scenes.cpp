// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/many_scenes.hpp"

#include <algorithm>
#include <memory>

#include "extremal/arc_flow.hpp"
#include "extremal/shooting.hpp"
#include "lanes/kernel.hpp"
#include "model/contact.hpp"
#include "model/start_angle.hpp"
#include "model/units.hpp"

namespace brachisto::lanes {

#if defined(__x86_64__)
extern template void shoot_eight<Instructions::Avx2>(const Targets&,
                                                     const Fineness&,
                                                     Extremals&);
extern template void shoot_eight<Instructions::Avx512>(const Targets&,
                                                       const Fineness&,
                                                       Extremals&);
#endif
extern template void shoot_eight<Instructions::Baseline>(const Targets&,
                                                         const Fineness&,
                                                         Extremals&);

namespace {

/// \return nothing where there is no cycloid
bool aim(const Scene& natural, int offsets, Target& out) {
  const ExtremalGuess cycloid = cycloid_guess(natural);
  if (!cycloid.state) return false;
  const ExtremalState start = cycloid.state(0.0);
  const Body& body = natural.body;
  out = {.eta_m = body.eta_m,
         .theta_m = body.theta_m,
         .k = body.k,
         .contact_radius = contact_radius(natural),
         .rotation_per_length = arcs::rotation_per_length(natural),
         .L = natural.L,
         .H = natural.H,
         .p_x = start.p_x,
         .p_z = start.p_z,
         .rolling_time = cycloid.rolling_time};
  Body on_the_way = body;
  for (int i = 0; i <= offsets; ++i) {
    on_the_way.eta_m = body.eta_m * i / offsets;
    out.start_angle[static_cast<std::size_t>(i)] = start_angle(on_the_way);
  }
  return true;
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
  std::vector<Extremal> out(scenes.size());
  Targets targets;
  const auto eight = std::make_unique<Extremals>();
  for (std::size_t first = 0; first < scenes.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, scenes.size() - first);
    std::array<bool, kLanes> aimed{};
    std::size_t some = kLanes;
    for (std::size_t i = 0; i < count; ++i) {
      const Scene natural =
          in_natural_units(without_whole_turns(scenes[first + i]));
      aimed[i] = fits(natural) && aim(natural, fineness.offsets, targets[i]);
      if (aimed[i]) some = i;
    }
    if (some == kLanes) continue;
    // A lane that nobody needs does what another one does.
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (!aimed[i]) targets[i] = targets[some];
    }
    switch (instructions) {
#if defined(__x86_64__)
      case Instructions::Avx512:
        shoot_eight<Instructions::Avx512>(targets, fineness, *eight);
        break;
      case Instructions::Avx2:
        shoot_eight<Instructions::Avx2>(targets, fineness, *eight);
        break;
#endif
      default:
        shoot_eight<Instructions::Baseline>(targets, fineness, *eight);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (aimed[i]) out[first + i] = (*eight)[i];
    }
  }
  return out;
}

}  // namespace brachisto::lanes
