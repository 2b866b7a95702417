// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Steps of an embedded Runge–Kutta pair with the error under control.

#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <type_traits>

#include "brachisto/math/clock.hpp"

namespace brachisto::ocp {

/// How accurately steps are taken.
struct StepControl {
  /// Local error allowed to each step, in natural units.
  double tolerance = 1e-13;
  /// Takes every step that the error control chooses as two halves.
  bool halve = false;
};

template <class Stack>
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<Stack, double,
                                                               Stack, double>;

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
    rates_(now_, slope_, u_);
  }

  [[nodiscard]] const Stack& now() const { return now_; }
  [[nodiscard]] const Stack& slope() const { return slope_; }
  /// The right-hand side with what it remembers of the last place.
  [[nodiscard]] const Rates& rates() const { return rates_; }
  /// True if there are no rates here; no step can be taken then.
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
    stepper_.do_step(rates_, now_, slope_, u_, next, h, error);
    const double ratio = rates_.relative_error(now_, error, tolerance);
    factor_ = std::clamp(kSafety * std::pow(ratio, -1.0 / kOrder), 0.2, 3.0);
    if (!(ratio <= 1.0)) return false;
    if (halve) {
      stepper_.do_step(rates_, now_, slope_, u_, next, 0.5 * h);
      const Stack middle = next;
      stepper_.do_step(rates_, middle, u_ + 0.5 * h, next, 0.5 * h);
    }
    move_to(next, h);
    return true;
  }

  /// A step of length h, whatever its error.
  void step_unchecked(double h) {
    Stack next;
    stepper_.do_step(rates_, now_, slope_, u_, next, h);
    move_to(next, h);
  }

 private:
  void move_to(const Stack& next, double h) {
    now_ = next;
    u_ += h;
    rates_(now_, slope_, u_);
  }

  Rates rates_;
  double u_ = 0.0;
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

}  // namespace brachisto::ocp
