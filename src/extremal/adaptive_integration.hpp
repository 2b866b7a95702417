// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations of the free motion, forwards and backwards, as the
/// integration wants them.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "extremal/canonical_flow.hpp"
#include "extremal/extremal_path.hpp"
#include "ocp/integration.hpp"

namespace brachisto::shooting {

inline constexpr std::size_t kTime = kStates;      // position of t
inline constexpr std::size_t kPath = kStates + 1;  // states, costates and t
/// Columns of derivatives: by θ, w, p_θ, p_w at the start and by p_x, p_z, η.
/// No rate depends on x and z, whose columns are the identity.
inline constexpr std::size_t kColumns = 7;
inline constexpr std::size_t kStartColumns = 4;
inline constexpr std::size_t kWithDerivatives = kPath + kColumns * kStates;

/// What is integrated: kPath numbers, or kWithDerivatives.
template <std::size_t Size>
using Stack = std::array<double, Size>;

template <std::size_t Size>
State states_of(const Stack<Size>& stack, std::size_t offset = 0) {
  State y;
  std::copy_n(stack.begin() + offset, kStates, y.begin());
  return y;
}

template <std::size_t Size>
void put(const State& y, std::size_t offset, Stack<Size>& stack) {
  std::copy_n(y.begin(), kStates, stack.begin() + offset);
}

inline ExtremalPath::Knot knot_at(double u, const Stack<kPath>& stack,
                                  double beta) {
  return {.u = u, .y = states_of(stack), .t = stack[kTime], .beta = beta};
}

using ocp::AdaptiveIntegration;
using ocp::advance;
using ocp::StepControl;
using ocp::Stepper;

/// The right-hand side as odeint wants it; remembers the last slope, which is
/// where the next one is searched. Odeint works on a copy: that a stage found
/// no slope shows in the error of its step.
template <std::size_t Size>
struct CanonicalRates {
  using Stack = shooting::Stack<Size>;

  const CanonicalFlow& flow;
  double beta;             ///< slope angle near which the first one is searched
  double direction = 1.0;  ///< −1 to go back
  bool failed = false;

  void operator()(const Stack& stack, Stack& rates, double) {
    const State y = states_of(stack);
    CanonicalFlow::Slope slope;
    if (failed || !flow.find_slope(y, beta, slope)) {
      failed = true;
      rates.fill(0.0);
      return;
    }
    beta = slope.beta;
    put(flow.rates(y, slope), 0, rates);
    rates[kTime] = slope.R;
    if constexpr (Size == kWithDerivatives) {
      for (std::size_t j = 0; j < kColumns; ++j) {
        const FlowParameters dp{j == kStartColumns ? 1.0 : 0.0,
                                j == kStartColumns + 1 ? 1.0 : 0.0,
                                j == kStartColumns + 2 ? 1.0 : 0.0};
        const std::size_t offset = kPath + j * kStates;
        put(flow.variation_rates(y, slope, states_of(stack, offset), dp),
            offset, rates);
      }
    }
    if (direction < 0.0) {
      for (double& rate : rates) rate = -rate;
    }
  }

  /// Largest error of the path relative to the tolerance; derivatives do not
  /// count. p_θ is measured in units of r, its natural size.
  [[nodiscard]] double relative_error(const Stack& now, const Stack& error,
                                      double tolerance) const {
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    // Back from B, rounding is far below the tolerances.
    const bool back = direction < 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < (back ? kStates : kPath); ++i) {
      const double weight = i == kPTheta ? flow.inverse_radius() : 1.0;
      const double rounding =
          back ? 0.0 : kRounding * std::abs(now[i]) * weight;
      const double ratio = std::abs(error[i]) * weight / (tolerance + rounding);
      if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, ratio);
    }
    return largest;
  }
};

}  // namespace brachisto::shooting
