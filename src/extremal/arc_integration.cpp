// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_integration.hpp"

#include <algorithm>

#include "brachisto/math/stop_condition.hpp"
#include "extremal/adaptive_integration.hpp"

namespace brachisto::shooting {

namespace {

/// Steps from 0 to `span` with error control; tells `on_step` of every step.
template <std::size_t Size, class OnStep>
bool advance(AdaptiveIntegration<Size>& path, double span,
             const StepControl& control, double& step, OnStep&& on_step) {
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
    on_step(u);
  }
  return true;
}

template <std::size_t Size>
void fill_end(const AdaptiveIntegration<Size>& path, ArcEnd& end) {
  end.y = states_of(path.now());
  end.t = path.now()[kTime];
  end.beta = path.beta();
  end.rates = states_of(path.slope());
}

}  // namespace

bool integrate_arc(const CanonicalFlow& flow, const State& start, double near,
                   double span, const StepControl& control, double& step,
                   ArcEnd& end) {
  Stack<kWithDerivatives> stack{};
  put(start, 0, stack);
  for (std::size_t j = 0; j < kStartColumns; ++j) {
    stack[kPath + j * kStates + kTheta + j] = 1.0;
  }
  AdaptiveIntegration path(Rates<kWithDerivatives>{flow, near}, stack);
  end.steps = 0;
  if (!advance(path, span, control, step, [&](double) { ++end.steps; })) {
    return false;
  }
  fill_end(path, end);
  end.by_start.setIdentity();
  const auto column = [&](std::size_t j) {
    return Eigen::Map<const Vector6>(path.now().data() + kPath + j * kStates);
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
  put(start, 0, stack);
  AdaptiveIntegration path(Rates<kPath>{flow, near}, stack);
  end.steps = 0;
  CanonicalFlow::Slope first;
  if (!flow.find_slope(start, near, first)) return false;
  knots.push_back(knot_at(0.0, stack, first.beta));
  if (!advance(path, span, control, step, [&](double u) {
        ++end.steps;
        knots.push_back(knot_at(u, path.now(), path.beta()));
      })) {
    return false;
  }
  fill_end(path, end);
  return true;
}

ExtremalPath::Knot step_from(const CanonicalFlow& flow,
                             const ExtremalPath::Knot& knot, double span) {
  Stack<kPath> stack{};
  put(knot.y, 0, stack);
  stack[kTime] = knot.t;
  Rates<kPath> rates{flow, knot.beta};
  Stepper<kPath>().do_step(rates, stack, 0.0, span);
  Stack<kPath> slope;
  rates(stack, slope, span);
  return knot_at(knot.u + span, stack, rates.beta);
}

}  // namespace brachisto::shooting
