// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/smooth_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto {

Tangency close_contact(
    const std::function<std::optional<double>(double phi)>& end_slope,
    double phi_start, const TangencyOptions& options) {
  struct Sample {
    double phi, mismatch;
  };
  std::optional<Sample> previous, positive, negative;
  Tangency tangency;
  tangency.phi = phi_start;
  tangency.slope = options.initial_slope;

  double phi = phi_start;
  while (tangency.passes < options.max_passes) {
    tangency.phi = phi;
    const std::optional<double> slope = end_slope(tangency.phi);
    ++tangency.passes;
    if (!slope || !std::isfinite(*slope)) return tangency;
    const Sample now{tangency.phi, *slope - tangency.phi};
    tangency.mismatch = now.mismatch;
    tangency.closed =
        std::abs(now.mismatch) <= options.tolerance ||
        (previous && std::abs(now.mismatch) <= options.loose_tolerance &&
         2.0 * std::abs(now.mismatch) >= std::abs(previous->mismatch));
    if (tangency.closed) return tangency;
    (now.mismatch > 0.0 ? positive : negative) = now;

    if (previous && previous->mismatch != now.mismatch) {
      tangency.slope =
          (now.mismatch - previous->mismatch) / (now.phi - previous->phi);
    }
    const double step = -now.mismatch / tangency.slope;
    double next =
        now.phi + std::clamp(step, -options.first_step, options.first_step);
    if (positive && negative) {
      const auto [low, high] = std::minmax({positive->phi, negative->phi});
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      // Nothing lies between them.
      if (next == low || next == high) return tangency;
    }
    previous = now;
    phi = next;
  }
  return tangency;
}

}  // namespace brachisto
