// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations step by step, forwards and backwards, with the error
/// under control.

#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

#include "brachisto/math/stop_condition.hpp"
#include "extremal/canonical_flow.hpp"
#include "extremal/extremal_path.hpp"

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

/// How accurately steps are taken.
struct StepControl {
  /// Local error allowed to each step, in natural units.
  double tolerance = 1e-13;
  /// Takes every step that the error control chooses as two halves.
  bool halve = false;
};

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

template <class Stack>
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<Stack>;

/// A path on its way, by an embedded Runge–Kutta pair of orders 7 and 8
/// (Fehlberg 1968). The caller says how long a step shall be and learns whether
/// it was taken.
///
/// \tparam Rates  the right-hand side as odeint wants it, its Stack, failed,
///                and relative_error()
template <class Rates>
class AdaptiveIntegration {
 public:
  using Stack = typename Rates::Stack;

  AdaptiveIntegration(const Rates& rates, const Stack& start)
      : rates_(rates), now_(start) {
    rates_(now_, slope_, 0.0);
  }

  [[nodiscard]] const Stack& now() const { return now_; }
  [[nodiscard]] const Stack& slope() const { return slope_; }
  [[nodiscard]] double beta() const { return rates_.beta; }
  /// True if there is no slope here; no step can be taken then.
  [[nodiscard]] bool failed() const { return rates_.failed; }
  /// By how much the next step had better be longer than the last.
  [[nodiscard]] double factor() const { return factor_; }

  /// Takes a step of length h if its error is at most the tolerance.
  /// \param halve  takes it as two halves
  /// \return false if nothing has moved
  bool step(double h, double tolerance, bool halve = false) {
    constexpr double kSafety = 0.9;
    constexpr double kOrder = 8.0;
    Stack next, error;
    stepper_.do_step(rates_, now_, slope_, 0.0, next, h, error);
    const double ratio = rates_.relative_error(now_, error, tolerance);
    factor_ = std::clamp(kSafety * std::pow(ratio, -1.0 / kOrder), 0.2, 3.0);
    if (ratio > 1.0) return false;
    if (halve) {
      stepper_.do_step(rates_, now_, slope_, 0.0, next, 0.5 * h);
      const Stack middle = next;
      stepper_.do_step(rates_, middle, 0.0, next, 0.5 * h);
    }
    move_to(next);
    return true;
  }

  /// A step of length h, whatever its error.
  void step_unchecked(double h) {
    Stack next;
    stepper_.do_step(rates_, now_, slope_, 0.0, next, h);
    move_to(next);
  }

 private:
  void move_to(const Stack& next) {
    now_ = next;
    rates_(now_, slope_, 0.0);
  }

  Rates rates_;
  Stack now_, slope_;
  double factor_ = 1.0;
  Stepper<Stack> stepper_;
};

/// Steps from 0 to `span` with error control; tells `on_step` of every step,
/// which ends the way there by returning false.
template <class Rates, class OnStep>
[[nodiscard]] bool advance(AdaptiveIntegration<Rates>& path, double span,
                           const StepControl& control, double& step,
                           OnStep&& on_step) {
  constexpr double kShortest = 1e-8;  // of the arc
  // A third of a turn takes a few hundred at the tightest tolerance.
  constexpr int kMostSteps = 20'000;
  if (path.failed() || !(span > 0.0)) return false;
  if (!(step > 0.0)) step = 0.1 * span;
  double u = 0.0;
  for (int tried = 0; u < span; ++tried) {
    if (tried == kMostSteps) return false;
    check_stop();
    const double rest = span - u;
    // Neither a sliver at the end nor a step beyond it.
    const double h = rest <= step ? rest : std::min(step, 0.5 * rest);
    if (!path.step(h, control.tolerance, control.halve)) {
      step = h * path.factor();
      if (step < kShortest * span) return false;
      continue;
    }
    u = rest <= step ? span : u + h;
    step = h < step ? std::max(step, h * path.factor()) : h * path.factor();
    if (path.failed()) return false;
    if constexpr (std::is_same_v<decltype(on_step(u)), bool>) {
      if (!on_step(u)) return true;
    } else {
      on_step(u);
    }
  }
  return true;
}

}  // namespace brachisto::shooting
