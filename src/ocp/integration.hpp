// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Integration along an arc, with the exact derivatives of the steps taken.

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "math/nearest_minimum.hpp"
#include "math/roots.hpp"
#include "ocp/adaptive_integration.hpp"

namespace brachisto::ocp {

/// A flow as odeint wants it: states, costates and ∫L; behind them, if asked
/// for, row by row their derivatives by the components First to End − 1 of the
/// state at the start. Of ignorable states neither the column is kept, by which
/// nothing else changes, nor the row of the costate, which is constant.
/// Remembers the last control, near which the next one is searched. Odeint
/// works on a copy: that a stage found none shows in the error of its step.
template <class Flow, bool Derivatives, std::size_t First = Flow::kIgnorable,
          std::size_t End = Flow::kSize>
struct FlowRates {
  using Number = typename Flow::Number;
  static constexpr std::size_t kPath = Flow::kSize + 1;
  static constexpr std::size_t kCost = Flow::kSize;  ///< position of ∫L
  static_assert(First >= Flow::kIgnorable && End <= Flow::kSize);
  static constexpr std::size_t kColumns = Derivatives ? End - First : 0;
  static constexpr std::size_t kRows = kPath - Flow::kIgnorable;
  using Stack = std::array<Number, kPath + kRows * kColumns>;
  using State = typename Flow::State;
  using At = typename Flow::template At<std::conditional_t<
      Derivatives, typename Flow::SecondOrder, typename Flow::FirstOrder>>;

  const Flow& flow;
  Number control;
  bool failed = false;

  [[nodiscard]] static constexpr bool is_constant(std::size_t component) {
    return component >= Flow::kStates &&
           component < Flow::kStates + Flow::kIgnorable;
  }
  /// Where the row of a component that is not constant begins.
  [[nodiscard]] static constexpr std::size_t row_of(std::size_t component) {
    const std::size_t row =
        component < Flow::kStates ? component : component - Flow::kIgnorable;
    return kPath + row * kColumns;
  }
  /// Whether a component of the state at the start has a column.
  [[nodiscard]] static constexpr bool has_column(std::size_t by) {
    return First <= by && by < End;
  }
  /// ∂(component)/∂(another one at the start).
  /// \pre the other one is ignorable or has a column
  [[nodiscard]] static Number derivative(const Stack& stack,
                                         std::size_t component,
                                         std::size_t by) {
    if (!has_column(by) || is_constant(component)) {
      return Number(component == by ? 1.0 : 0.0);
    }
    return stack[row_of(component) + by - First];
  }

  void operator()(const Stack& stack, Stack& rates, double) {
    At at;
    if (failed || !flow.find(state_of(stack), control, at)) {
      failed = true;
      rates.fill(Number(0.0));
      return;
    }
    const State f = Flow::rates(at);
    std::copy(f.begin(), f.end(), rates.begin());
    rates[kCost] = at.rates.cost.value;
    if constexpr (Derivatives) {
      const typename Flow::Linearisation by = flow.linearisation(at);
      for (std::size_t i = 0; i < kPath; ++i) {
        if (is_constant(i)) continue;
        std::array<Number, kColumns> row{};
        for (std::size_t k = Flow::kIgnorable; k < Flow::kSize; ++k) {
          if (is_constant(k)) {
            if (has_column(k)) row[k - First] = row[k - First] + by[i][k];
            continue;
          }
          const Number* other = stack.data() + row_of(k);
          for (std::size_t j = 0; j < kColumns; ++j) {
            row[j] = row[j] + by[i][k] * other[j];
          }
        }
        std::copy(row.begin(), row.end(),
                  rates.begin() + static_cast<std::ptrdiff_t>(row_of(i)));
      }
    }
  }

  /// Of the path, relative to the tolerance. Where the states alone are judged
  /// also of their derivatives: next to rest β comes back to a limit on forces
  /// at a rate ∝ 1/u, which an incline, on which it never leaves it, does not
  /// show. A step too long for that rate would be right and its derivatives
  /// huge.
  [[nodiscard]] double relative_error(const Stack& now, const Stack& error,
                                      double tolerance) const {
    using math::magnitude;
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    double largest = 0.0;
    for (std::size_t i = 0; i < kPath; ++i) {
      const double weight = i == kCost ? 1.0 : flow.error_weight(i);
      if (weight == 0.0) continue;
      const double ratio = magnitude(error[i]) * weight /
                           (tolerance + kRounding * magnitude(now[i]) * weight);
      if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, ratio);
    }
    if (!Derivatives || flow.judges_costates) return largest;
    constexpr double kOfDerivatives = 1e-8;
    for (std::size_t i = 0; i < Flow::kStates; ++i) {
      for (std::size_t j = 0; First + j < std::min(End, Flow::kStates); ++j) {
        const std::size_t place = row_of(i) + j;
        const double ratio = magnitude(error[place]) /
                             (kOfDerivatives * (1.0 + magnitude(now[place])));
        if (!std::isfinite(ratio)) {
          return std::numeric_limits<double>::infinity();
        }
        largest = std::max(largest, ratio);
      }
    }
    return largest;
  }

  [[nodiscard]] static State state_of(const Stack& stack) {
    State y;
    std::copy_n(stack.begin(), Flow::kSize, y.begin());
    return y;
  }
  [[nodiscard]] static Stack stack_of(const State& y) {
    Stack stack{};
    std::copy(y.begin(), y.end(), stack.begin());
    for (std::size_t j = 0; j < kColumns; ++j) {
      if (!is_constant(j + First)) stack[row_of(j + First) + j] = Number(1.0);
    }
    return stack;
  }
};

/// Where a way has led.
template <class Rates>
struct Arrived {
  typename Rates::Stack now, slope;
  typename Rates::Number control;
};

/// Derivatives beyond a surface. A neighbour passes it later by du and has
/// moved at the rates of this side until then:
///
///     δy⁺ = δy⁻ + (y'⁻ − y'⁺) du,   du = −∇h·δy⁻ / ∇h·y'⁻
///
/// where h is the height above it.
template <bool Derivatives, class Flow, class Stack>
void pass_surface(const Flow& here, const Flow& there,
                  const typename Flow::Number& control, Stack& now) {
  if constexpr (Derivatives) {
    using Rates = FlowRates<Flow, true>;
    using Number = typename Flow::Number;
    const typename Flow::State y = Rates::state_of(now);
    typename Flow::template At<typename Flow::FirstOrder> at_here, at_there;
    Number same = control;
    if (!here.find(y, same, at_here) || !there.find(y, same, at_there)) return;
    const auto before = Flow::rates(at_here), behind = Flow::rates(at_there);
    const auto normal = here.height_gradient(y);
    const auto rise = [&](const auto& change) {
      Number sum(0.0);
      for (std::size_t i = 0; i < Flow::kStates; ++i) {
        sum = sum + normal[i] * change(i);
      }
      return sum;
    };
    const Number speed = rise([&](std::size_t i) { return before[i]; });
    for (std::size_t j = 0; j < Rates::kColumns; ++j) {
      const Number du =
          rise([&](std::size_t i) { return now[Rates::row_of(i) + j]; }) /
          speed;
      for (std::size_t i = 0; i < Flow::kSize; ++i) {
        if (Rates::is_constant(i)) continue;
        Number& derivative = now[Rates::row_of(i) + j];
        derivative = derivative - (before[i] - behind[i]) * du;
      }
    }
  }
}

/// Goes from 0 to `span`; tells `on_step(u, stack, control)` of every step.
/// A problem that has a surface, on which its rates have a kink, is followed in
/// pieces that end where the surface is passed: an error estimate from stages
/// on both sides would see little of it.
///
/// \param near  control near which the first one is searched
/// \param step  [in,out] step to try first; the last one taken
template <bool Derivatives, class Flow, class OnStep>
[[nodiscard]] std::optional<Arrived<FlowRates<Flow, Derivatives>>> travel(
    const Flow& flow, const typename Flow::State& start,
    const typename Flow::Number& near, double span, const StepControl& control,
    double& step, OnStep&& on_step) {
  using Rates = FlowRates<Flow, Derivatives>;
  using Path = AdaptiveIntegration<Rates>;
  if (!flow.has_surface()) {
    Path path(Rates{flow, near}, Rates::stack_of(start));
    if (!advance(path, span, control, step, [&](double u) {
          on_step(u, path.now(), path.rates().control);
        })) {
      return std::nullopt;
    }
    return Arrived<Rates>{path.now(), path.slope(), path.rates().control};
  }
  constexpr int kMostPassages = 50;
  const auto height = [&](const typename Rates::Stack& stack) {
    return flow.height(Rates::state_of(stack));
  };
  // The last place that is known to be on the side of a piece.
  double u = 0.0;
  typename Rates::Stack now = Rates::stack_of(start);
  typename Rates::Number steer = near;
  bool above = height(now) > 0.0;
  for (int passages = 0; passages <= kMostPassages; ++passages) {
    const Flow here = flow.on_side(above);
    const double from = u;
    double beyond = 0.0;  // length of the step that led over the surface
    Path path(Rates{here, steer}, now);
    const bool went =
        u >= span || advance(path, span - from, control, step, [&](double v) {
          if ((height(path.now()) > 0.0) != above) {
            beyond = from + v - u;
            return false;
          }
          u = from + v;
          now = path.now();
          steer = path.rates().control;
          on_step(u, now, steer);
          return true;
        });
    if (!went) return std::nullopt;
    if (beyond == 0.0) return Arrived<Rates>{now, path.slope(), steer};
    const auto after = [&](double h) {
      Path part(Rates{here, steer}, now);
      part.step_unchecked(h);
      return part;
    };
    // At its beginning a piece may lie on the surface but for rounding.
    const double side = above ? 1.0 : -1.0;
    const double at_first = std::max(0.0, side * height(now));
    if (at_first > 0.0) {
      const double h = math::find_root(
          [&](double part) { return side * height(after(part).now()); }, 0.0,
          beyond, at_first, std::min(0.0, side * height(path.now())));
      const Path on_surface = after(h);
      u += h;
      now = on_surface.now();
      steer = on_surface.rates().control;
      on_step(u, now, steer);
      pass_surface<Derivatives>(here, flow.on_side(!above), steer, now);
    }
    above = !above;
  }
  return std::nullopt;
}

/// Where an arc ends.
template <class Flow>
struct ArcEnd {
  static constexpr int kWidth = static_cast<int>(Flow::kSize);

  typename Flow::State y;
  typename Flow::Number cost{};     ///< ∫L over the arc
  typename Flow::Number control{};  ///< continuous along the arc
  typename Flow::State rates;       ///< dy/du
  typename Flow::Number cost_rate{};
  int steps = 0;
  /// ∂y/∂(y at the start), and of ∫L.
  Eigen::Matrix<typename Flow::Number, kWidth, kWidth> by_start;
  Eigen::Matrix<typename Flow::Number, 1, kWidth> cost_by_start;
};

/// Integrates from u = 0 to `span`; nothing if there is no control, or the
/// steps become too small.
template <bool Derivatives, class Flow>
[[nodiscard]] auto arrive(const Flow& flow, const typename Flow::State& start,
                          const typename Flow::Number& near, double span,
                          const StepControl& control, double& step,
                          ArcEnd<Flow>& end) {
  using Rates = FlowRates<Flow, Derivatives>;
  end.steps = 0;
  const auto arrived = travel<Derivatives>(
      flow, start, near, span, control, step,
      [&](double, const auto&, const auto&) { ++end.steps; });
  if (arrived) {
    end.y = Rates::state_of(arrived->now);
    end.cost = arrived->now[Rates::kCost];
    end.control = arrived->control;
    end.rates = Rates::state_of(arrived->slope);
    end.cost_rate = arrived->slope[Rates::kCost];
  }
  return arrived;
}

/// The same with the derivatives; false if it fails.
template <class Flow>
[[nodiscard]] bool integrate_arc(const Flow& flow,
                                 const typename Flow::State& start,
                                 const typename Flow::Number& near, double span,
                                 const StepControl& control, double& step,
                                 ArcEnd<Flow>& end) {
  const auto arrived =
      arrive<true>(flow, start, near, span, control, step, end);
  if (!arrived) return false;
  using Rates = FlowRates<Flow, true>;
  for (std::size_t i = 0; i <= Flow::kSize; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < Flow::kSize; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      const auto by = Rates::derivative(arrived->now, i, j);
      (i < Flow::kSize ? end.by_start(row, column)
                       : end.cost_by_start(column)) = by;
    }
  }
  return true;
}

/// The same without the derivatives, which are left as they are. Takes the same
/// steps, unless the states alone are judged.
template <class Flow>
[[nodiscard]] bool end_of_arc(const Flow& flow,
                              const typename Flow::State& start,
                              const typename Flow::Number& near, double span,
                              const StepControl& control, double& step,
                              ArcEnd<Flow>& end) {
  return arrive<false>(flow, start, near, span, control, step, end).has_value();
}

/// A state on the way.
template <class Flow>
struct Passed {
  double u = 0.0;
  typename Flow::State y{};
  double cost = 0.0, control = 0.0;
};

/// The same without derivatives; tells of the start and of every step.
template <class Flow, class Tell>
[[nodiscard]] bool follow_arc(const Flow& flow,
                              const typename Flow::State& start, double near,
                              double span, const StepControl& control,
                              Tell&& tell) {
  using Rates = FlowRates<Flow, false>;
  typename Rates::At at;
  if (!flow.find(start, near, at)) return false;
  tell(Passed<Flow>{0.0, start, 0.0, near});
  double step = 0.0;
  return travel<false>(flow, start, near, span, control, step,
                       [&](double u, const auto& stack, double steer) {
                         tell(Passed<Flow>{u, Rates::state_of(stack),
                                           stack[Rates::kCost], steer});
                       })
      .has_value();
}

/// One step of length `span`, unchecked: for interpolation.
template <class Flow>
[[nodiscard]] Passed<Flow> step_from(const Flow& flow, const Passed<Flow>& from,
                                     double span) {
  using Rates = FlowRates<Flow, false>;
  typename Rates::Stack stack = Rates::stack_of(from.y);
  stack[Rates::kCost] = from.cost;
  AdaptiveIntegration<Rates> path(Rates{flow, from.control}, stack);
  path.step_unchecked(span);
  return {from.u + span, Rates::state_of(path.now()), path.now()[Rates::kCost],
          path.rates().control};
}

}  // namespace brachisto::ocp
