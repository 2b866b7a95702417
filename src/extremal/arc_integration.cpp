// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_integration.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto::shooting {

namespace {

constexpr std::size_t kTime = kStates;      // position of t
constexpr std::size_t kPath = kStates + 1;  // states, costates and t
/// Columns of derivatives: by θ, w, p_θ, p_w at the start and by p_x, p_z, η.
/// No rate depends on x and z, whose columns are the identity.
constexpr std::size_t kColumns = 7;
constexpr std::size_t kStartColumns = 4;
constexpr std::size_t kWithDerivatives = kPath + kColumns * kStates;

template <std::size_t Size>
using Stack = std::array<double, Size>;

template <std::size_t Size>
State states_of(const Stack<Size>& stack, std::size_t offset = 0) {
  State y;
  for (std::size_t i = 0; i < kStates; ++i) y[i] = stack[offset + i];
  return y;
}

template <std::size_t Size>
void put(const State& y, std::size_t offset, Stack<Size>& stack) {
  for (std::size_t i = 0; i < kStates; ++i) stack[offset + i] = y[i];
}

/// The right-hand side as odeint wants it; remembers the last slope, which is
/// where the next one is searched.
template <std::size_t Size>
class Rates {
 public:
  Rates(const CanonicalFlow& flow, double near) : flow_(flow), beta(near) {}

  void operator()(const Stack<Size>& stack, Stack<Size>& rates, double) {
    const State y = states_of(stack);
    CanonicalFlow::Slope slope;
    if (failed || !flow_.find_slope(y, beta, slope)) {
      failed = true;
      rates.fill(0.0);
      return;
    }
    beta = slope.beta;
    put(flow_.rates(y, slope), 0, rates);
    rates[kTime] = slope.R;
    if constexpr (Size == kWithDerivatives) {
      for (std::size_t j = 0; j < kColumns; ++j) {
        const FlowParameters dp{j == kStartColumns ? 1.0 : 0.0,
                                j == kStartColumns + 1 ? 1.0 : 0.0,
                                j == kStartColumns + 2 ? 1.0 : 0.0};
        const std::size_t offset = kPath + j * kStates;
        put(flow_.variation_rates(y, slope, states_of(stack, offset), dp),
            offset, rates);
      }
    }
  }

 private:
  const CanonicalFlow& flow_;

 public:
  double beta;
  bool failed = false;
};

/// Largest error of the path relative to the tolerance; derivatives do not
/// count. p_θ is measured in units of r, its natural size.
template <std::size_t Size>
double relative_error(const Stack<Size>& error, const Stack<Size>& stack,
                      double inverse_radius, double tolerance) {
  constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
  double largest = 0.0;
  for (std::size_t i = 0; i < kPath; ++i) {
    const double weight = i == kPTheta ? inverse_radius : 1.0;
    const double allowed = tolerance + kRounding * std::abs(stack[i]) * weight;
    const double ratio = std::abs(error[i]) * weight / allowed;
    if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, ratio);
  }
  return largest;
}

template <std::size_t Size>
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<Stack<Size>>;

/// Steps from 0 to `span` with error control; tells `on_step` of every step.
template <std::size_t Size, class OnStep>
bool advance(const CanonicalFlow& flow, Rates<Size>& rates, Stack<Size>& stack,
             Stack<Size>& slope, double span, const StepControl& control,
             double& step, OnStep&& on_step) {
  constexpr double kSafety = 0.9;
  constexpr double kShortest = 1e-8;  // of the arc
  // A third of a turn takes a few hundred at the tightest tolerance.
  constexpr int kMostSteps = 20'000;
  constexpr double kOrder = 8.0;
  Stepper<Size> stepper;
  Stack<Size> trial;
  Stack<Size> error;
  double u = 0.0;
  rates(stack, slope, u);
  if (rates.failed || !(span > 0.0)) return false;
  if (!(step > 0.0)) step = 0.1 * span;

  for (int tried = 0; u < span; ++tried) {
    if (tried == kMostSteps) return false;
    check_stop();
    const double rest = span - u;
    // Neither a sliver at the end nor a step beyond it.
    const double h = rest <= step ? rest : std::min(step, 0.5 * rest);
    const double beta = rates.beta;
    stepper.do_step(rates, stack, slope, u, trial, h, error);
    const double ratio =
        rates.failed ? std::numeric_limits<double>::infinity()
                     : relative_error(error, stack, flow.inverse_radius(),
                                      control.tolerance);
    const double factor =
        std::clamp(kSafety * std::pow(ratio, -1.0 / kOrder), 0.2, 3.0);
    if (ratio > 1.0) {
      rates.beta = beta;
      rates.failed = false;
      step = h * factor;
      if (step < kShortest * span) return false;
      continue;
    }
    if (control.halve) {
      rates.beta = beta;
      stepper.do_step(rates, stack, slope, u, trial, 0.5 * h);
      const Stack<Size> middle = trial;
      stepper.do_step(rates, middle, u + 0.5 * h, trial, 0.5 * h);
    }
    stack = trial;
    u = rest <= step ? span : u + h;
    step = h < step ? std::max(step, h * factor) : h * factor;
    rates(stack, slope, u);
    if (rates.failed) return false;
    on_step(u);
  }
  return true;
}

template <std::size_t Size>
void fill_end(const Stack<Size>& stack, const Stack<Size>& slope, double beta,
              ArcEnd& end) {
  end.y = states_of(stack);
  end.t = stack[kTime];
  end.beta = beta;
  end.rates = states_of(slope);
}

ExtremalPath::Knot knot_at(double u, const Stack<kPath>& stack, double beta) {
  return {.u = u, .y = states_of(stack), .t = stack[kTime], .beta = beta};
}

}  // namespace

bool integrate_arc(const CanonicalFlow& flow, const State& start, double near,
                   double span, const StepControl& control, double& step,
                   ArcEnd& end) {
  Stack<kWithDerivatives> stack{};
  Stack<kWithDerivatives> slope{};
  put(start, 0, stack);
  for (std::size_t j = 0; j < kStartColumns; ++j) {
    stack[kPath + j * kStates + kTheta + j] = 1.0;
  }
  Rates<kWithDerivatives> rates(flow, near);
  end.steps = 0;
  if (!advance(flow, rates, stack, slope, span, control, step,
               [&](double) { ++end.steps; })) {
    return false;
  }
  fill_end(stack, slope, rates.beta, end);
  end.by_start.setIdentity();
  const auto column = [&](std::size_t j) {
    return Eigen::Map<const Vector6>(stack.data() + kPath + j * kStates);
  };
  for (std::size_t j = 0; j < kStartColumns; ++j) {
    end.by_start.col(static_cast<Eigen::Index>(kTheta + j)) = column(j);
  }
  for (std::size_t j = kStartColumns; j < kColumns; ++j) {
    end.by_parameter.col(static_cast<Eigen::Index>(j - kStartColumns)) =
        column(j);
  }
  return true;
}

bool integrate_path(const CanonicalFlow& flow, const State& start, double near,
                    double span, const StepControl& control, double& step,
                    ArcEnd& end, std::vector<ExtremalPath::Knot>& knots) {
  Stack<kPath> stack{};
  Stack<kPath> slope{};
  put(start, 0, stack);
  Rates<kPath> rates(flow, near);
  end.steps = 0;
  CanonicalFlow::Slope first;
  if (!flow.find_slope(start, near, first)) return false;
  knots.push_back(knot_at(0.0, stack, first.beta));
  if (!advance(flow, rates, stack, slope, span, control, step, [&](double u) {
        ++end.steps;
        knots.push_back(knot_at(u, stack, rates.beta));
      })) {
    return false;
  }
  fill_end(stack, slope, rates.beta, end);
  return true;
}

ExtremalPath::Knot step_from(const CanonicalFlow& flow,
                             const ExtremalPath::Knot& knot, double span) {
  Stack<kPath> stack{};
  put(knot.y, 0, stack);
  stack[kTime] = knot.t;
  Rates<kPath> rates(flow, knot.beta);
  Stepper<kPath>().do_step(rates, stack, 0.0, span);
  Stack<kPath> slope;
  rates(stack, slope, span);
  return knot_at(knot.u + span, stack, rates.beta);
}

}  // namespace brachisto::shooting
