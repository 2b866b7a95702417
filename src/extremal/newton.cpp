// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/newton.hpp"

#include <algorithm>
#include <utility>

namespace brachisto::shooting {

ShootingResult solve_newton(const ShootingSystem& system,
                            const ChainVector& start, const ChainScale& scale,
                            const TangencyRow& tangency,
                            const ShootingOptions& options) {
  // A correction this small that no longer shrinks is made of rounding, which
  // a long path magnifies: over a thousand turns by 1e8.
  constexpr double kRoundingLevel = 1e-7;
  ShootingResult result;
  result.point = start;
  if (!system.evaluate(start, options.integration, result.at)) {
    if (system.stopped()) result.end = NewtonEnd::Stopped;
    return result;
  }

  const auto gap = [&](const ChainVector& point) {
    return tangency.value - tangency.row.dot(point.globals);
  };
  double factor = 1.0;
  while (result.steps < options.max_steps) {
    const ChainElimination chain(result.at.jacobian, tangency.row);
    const ChainVector change =
        chain.solve(result.at.residual, gap(result.point));
    const double length = scale.norm(change);
    if (!std::isfinite(length)) {
      result.end = NewtonEnd::Diverged;
      return result;
    }
    ++result.steps;

    Linearisation trial_at;
    ChainVector trial;
    double contraction = 0.0;
    factor = std::min(1.0, 4.0 * factor);
    for (;; factor *= 0.5) {
      if (factor < options.smallest_factor) {
        // At rounding level there is nothing left to descend.
        result.end = length < kRoundingLevel ? NewtonEnd::Converged
                                             : NewtonEnd::Diverged;
        return result;
      }
      if (system.stopped()) {
        result.end = NewtonEnd::Stopped;
        return result;
      }
      trial = moved(result.point, factor, change);
      if (!system.evaluate(trial, options.integration, trial_at)) continue;
      const ChainVector simplified = chain.solve(trial_at.residual, gap(trial));
      result.last_change_of_phi = simplified.globals(kPhi);
      contraction = length > 0.0 ? scale.norm(simplified) / length : 0.0;
      if (contraction <= 1.0 - 0.25 * factor) break;
      if (length < kRoundingLevel && factor == 1.0) break;
    }
    result.point = std::move(trial);
    result.at = std::move(trial_at);
    if (result.steps == 1) result.first_contraction = contraction;
    result.last_correction = contraction * length;
    const bool stagnates = length < kRoundingLevel && contraction > 0.25;
    if (factor == 1.0 &&
        (result.last_correction <= options.tolerance || stagnates)) {
      result.end = NewtonEnd::Converged;
      return result;
    }
  }
  result.end = NewtonEnd::MaxSteps;
  return result;
}

}  // namespace brachisto::shooting
