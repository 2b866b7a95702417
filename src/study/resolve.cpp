// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/resolve.hpp"

#include <utility>

#include "study/certification.hpp"

namespace brachisto {

void refine_until_resolved(
    const Scene& scene, Discretisation wanted, ContactCandidate from,
    const std::function<MeshOptions()>& options,
    const std::function<const Certificate*(Refinement)>& conclude) {
  constexpr int kRounds = 3;
  constexpr double kTighter = 1e-2;
  for (int round = 0; round < kRounds; ++round) {
    Refinement found = refine(scene, wanted, from.curve, from.phi, options());
    if (found.answer) {
      from = {found.answer->curve(), found.answer->solution.tangency.phi};
    }
    const Certificate* checks = conclude(std::move(found));
    if (checks == nullptr || wanted.fixed() || !under_resolved(*checks)) return;
    wanted.tolerance = kTighter * wanted.tolerance.value_or(kDefaultTolerance);
  }
}

}  // namespace brachisto
