// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/limited_integration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brachisto::limited {

namespace {

constexpr std::size_t kTime = kSize;      // position of t
constexpr std::size_t kPath = kSize + 1;  // states, costates and t

/// \tparam Columns  of derivatives by the start, kSize or none
template <std::size_t Columns>
struct PieceRates {
  /// The path, then its derivatives by each component of the start.
  using Stack = std::array<double, kPath*(1 + Columns)>;

  const LimitedFlow& flow;
  Judged judged;
  bool failed = false;

  void operator()(const Stack& stack, Stack& rates, double) const {
    if constexpr (Columns == 0) {
      State y;
      std::copy_n(stack.begin(), kSize, y.begin());
      const auto f = flow.rates(y);
      std::copy(f.y.begin(), f.y.end(), rates.begin());
      rates[kTime] = f.t;
    } else {
      Values<Jet> y;
      for (std::size_t i = 0; i < kSize; ++i) {
        y[i].value = stack[i];
        for (std::size_t j = 0; j < kSize; ++j) {
          y[i].gradient[j] = stack[kPath * (1 + j) + i];
        }
      }
      const auto f = flow.rates(y);
      const auto put = [&](std::size_t i, const Jet& rate) {
        rates[i] = rate.value;
        for (std::size_t j = 0; j < kSize; ++j) {
          rates[kPath * (1 + j) + i] = rate.gradient[j];
        }
      };
      for (std::size_t i = 0; i < kSize; ++i) put(i, f.y[i]);
      put(kTime, f.t);
    }
  }

  /// Of the path; p_θ is measured in units of r, its natural size. Where the
  /// states alone are judged also of their derivatives: next to rest β comes
  /// back to a limit on forces at a rate ∝ 1/u, which an incline, on which it
  /// never leaves it, does not show. A step too long for that rate would be
  /// right and its derivatives huge.
  [[nodiscard]] double relative_error(const Stack& now, const Stack& error,
                                      double tolerance) const {
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    constexpr double kOfDerivatives = 1e-8;
    double largest = 0.0;
    for (std::size_t i = 0; i < kPath; ++i) {
      if (judged == Judged::StatesAlone && i >= kStates && i < kSize) continue;
      const double weight = i == kPTheta ? flow.rotation_per_length() : 1.0;
      const double ratio = std::abs(error[i]) * weight /
                           (tolerance + kRounding * std::abs(now[i]) * weight);
      if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, ratio);
    }
    if (judged == Judged::StatesAndCostates) return largest;
    for (std::size_t j = 0; j < std::min(Columns, kStates); ++j) {
      for (std::size_t i = 0; i < kStates; ++i) {
        const std::size_t place = kPath * (1 + j) + i;
        const double ratio = std::abs(error[place]) /
                             (kOfDerivatives * (1.0 + std::abs(now[place])));
        if (!std::isfinite(ratio)) {
          return std::numeric_limits<double>::infinity();
        }
        largest = std::max(largest, ratio);
      }
    }
    return largest;
  }
};

template <std::size_t Columns>
typename PieceRates<Columns>::Stack stack_of(const State& y) {
  typename PieceRates<Columns>::Stack stack{};
  std::copy(y.begin(), y.end(), stack.begin());
  for (std::size_t j = 0; j < Columns; ++j) stack[kPath * (1 + j) + j] = 1.0;
  return stack;
}

template <class Stack>
State state_of(const Stack& stack) {
  State y;
  std::copy_n(stack.begin(), kSize, y.begin());
  return y;
}

}  // namespace

bool integrate_piece(const LimitedFlow& flow, const State& start, double span,
                     Judged judged, const shooting::StepControl& control,
                     double& step, PieceEnd& end) {
  using Rates = PieceRates<kSize>;
  shooting::AdaptiveIntegration<Rates> path(Rates{flow, judged},
                                            stack_of<kSize>(start));
  end.steps = 0;
  if (!shooting::advance(path, span, control, step,
                         [&](double) { ++end.steps; })) {
    return false;
  }
  end.y = state_of(path.now());
  end.t = path.now()[kTime];
  end.rates = state_of(path.slope());
  end.time_rate = path.slope()[kTime];
  for (std::size_t j = 0; j < kSize; ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    const double* derivatives = path.now().data() + kPath * (1 + j);
    end.by_start.col(column) =
        Eigen::Map<const Eigen::Matrix<double, PieceEnd::kRows, 1>>(
            derivatives);
    end.time_by_start(column) = derivatives[kTime];
  }
  return true;
}

bool follow_piece(const LimitedFlow& flow, const State& start, double span,
                  Judged judged, const shooting::StepControl& control,
                  const std::function<void(double u, const State&)>& on_step) {
  using Rates = PieceRates<0>;
  shooting::AdaptiveIntegration<Rates> path(Rates{flow, judged},
                                            stack_of<0>(start));
  double step = 0.0;
  return shooting::advance(path, span, control, step,
                           [&](double u) { on_step(u, state_of(path.now())); });
}

State step_from(const LimitedFlow& flow, const State& start, double span) {
  using Rates = PieceRates<0>;
  Rates::Stack stack = stack_of<0>(start);
  shooting::Stepper<Rates::Stack>().do_step(
      Rates{flow, Judged::StatesAndCostates}, stack, 0.0, span);
  return state_of(stack);
}

}  // namespace brachisto::limited
