// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_integration.hpp"

#include "extremal/adaptive_integration.hpp"

namespace brachisto::shooting {

namespace {

template <std::size_t Size>
void fill_end(const AdaptiveIntegration<CanonicalRates<Size>>& path,
              ArcEnd& end) {
  end.y = states_of(path.now());
  end.t = path.now()[kTime];
  end.beta = path.rates().beta;
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
  AdaptiveIntegration path(CanonicalRates<kWithDerivatives>{flow, near}, stack);
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
  AdaptiveIntegration path(CanonicalRates<kPath>{flow, near}, stack);
  end.steps = 0;
  CanonicalFlow::Slope first;
  if (!flow.find_slope(start, near, first)) return false;
  knots.push_back(knot_at(0.0, stack, first.beta));
  if (!advance(path, span, control, step, [&](double u) {
        ++end.steps;
        knots.push_back(knot_at(u, path.now(), path.rates().beta));
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
  CanonicalRates<kPath> rates{flow, knot.beta};
  Stepper<Stack<kPath>>().do_step(rates, stack, 0.0, span);
  Stack<kPath> slope;
  rates(stack, slope, span);
  return knot_at(knot.u + span, stack, rates.beta);
}

}  // namespace brachisto::shooting
