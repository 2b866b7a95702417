// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/wider_search.hpp"

namespace brachisto {

std::string wider_search(const Scene& scene, const SolveOptions& options) {
  if (options.searches() || scene.contact != Contact::Smooth ||
      !scene.world.ordinary() || scene.path) {
    return {};
  }
  const std::string search = "search: global";
  const auto* program = options.of<Collocation>();
  if (program == nullptr) return search + " with method: ipopt";
  return program->discretisation.formulation == Formulation::ArcLength
             ? search + " with formulation: rolling_time"
             : search;
}

}  // namespace brachisto
