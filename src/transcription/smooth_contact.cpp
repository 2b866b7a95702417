// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/smooth_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto {

ContactClosure close_contact(
    const std::function<std::optional<double>(double phi)>& end_slope,
    double phi_start, const ClosureOptions& options) {
  struct Sample {
    double phi, mismatch;
  };
  std::optional<Sample> previous, positive, negative;
  ContactClosure closure;
  closure.phi = phi_start;
  closure.slope = options.initial_slope;

  double phi = phi_start;
  while (closure.passes < options.max_passes) {
    closure.phi = phi;
    const std::optional<double> slope = end_slope(closure.phi);
    ++closure.passes;
    if (!slope || !std::isfinite(*slope)) return closure;
    const Sample now{closure.phi, *slope - closure.phi};
    closure.mismatch = now.mismatch;
    closure.closed =
        std::abs(now.mismatch) <= options.tolerance ||
        (previous && std::abs(now.mismatch) <= options.loose_tolerance &&
         2.0 * std::abs(now.mismatch) >= std::abs(previous->mismatch));
    if (closure.closed) return closure;
    (now.mismatch > 0.0 ? positive : negative) = now;

    if (previous && previous->mismatch != now.mismatch) {
      closure.slope =
          (now.mismatch - previous->mismatch) / (now.phi - previous->phi);
    }
    const double step = -now.mismatch / closure.slope;
    double next =
        now.phi + std::clamp(step, -options.first_step, options.first_step);
    if (positive && negative) {
      const auto [low, high] = std::minmax({positive->phi, negative->phi});
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      // Nothing lies between them.
      if (next == low || next == high) return closure;
    }
    previous = now;
    phi = next;
  }
  return closure;
}

}  // namespace brachisto
