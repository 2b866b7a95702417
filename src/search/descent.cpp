// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/descent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/inertia.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

bool is_minimum(RollingTime& problem, const PrimalDual& point) {
  const Inertia inertia = kkt_inertia(problem, point);
  return inertia.known && inertia.zero == 0 &&
         inertia.negative == problem.num_constraints();
}

}  // namespace

Descent descend(const Scene& scene, const ContactCandidate& saddle,
                MeshOptions options) {
  // Next to nothing, but far more than what Ipopt takes for solved [rad].
  constexpr double kPush = 1e-3;
  constexpr double kSame = 1e-6;
  Descent out;
  RollingTime problem(scene, saddle.curve.mesh(), saddle.phi);
  const MeshSolution there = stay_on_mesh(
      problem, {prolong(saddle.curve, problem), saddle.phi, -1.0}, options);
  if (!there.solved() || is_minimum(problem, there.point)) return out;
  options.newton_alone = false;
  for (const double push : {kPush, -kPush}) {
    PrimalDual start = there.point;
    for (int c = 0; c < problem.layout().num_points(); ++c) {
      start.x[static_cast<std::size_t>(problem.layout().beta(c))] += push;
    }
    const MeshSolution found = solve_on_mesh(
        problem, {std::move(start), there.tangency.phi, -1.0}, options);
    out.work += {found.iterations, found.tangency.passes, 0, found.log};
    if (options.ipopt.stop.met()) return out;
    if (!found.solved() || !is_minimum(problem, found.point)) continue;
    // Both ways may lead to the same one.
    ContactCandidate minimum{ExtremalCurve(problem, found.point),
                             found.tangency.phi};
    if (std::ranges::none_of(out.minima, [&](const ContactCandidate& other) {
          return std::abs(mark_of(other) - mark_of(minimum)) <= kSame;
        })) {
      out.minima.push_back(std::move(minimum));
    }
  }
  return out;
}

}  // namespace brachisto
