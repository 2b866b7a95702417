// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/wider_search.hpp"

namespace brachisto {

std::string wider_search(const Scene& scene, const SolveOptions& options) {
  const bool any_others = scene.limits.any() ||
                          (scene.world.ordinary() && scene.body.off_centred());
  if (options.searches() || scene.path || !any_others) return {};
  const std::string search = "search: global";
  const auto* program = options.of<Collocation>();
  if (program == nullptr) return search + " with method: ipopt";
  return program->discretisation.formulation == Formulation::ArcLength
             ? search + " with formulation: rolling_time"
             : search;
}

}  // namespace brachisto
