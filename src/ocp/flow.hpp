// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations of any problem, and their exact linearisation.
///
/// 𝓗 = L + p·f + μ (c − b) is linear in the costates p and in the multiplier μ,
/// so that jets of L, f and c by the states y and the control u alone, six
/// variables or fewer, give all its first and second derivatives.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "brachisto/math/jet.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "math/nearest_minimum.hpp"

namespace brachisto::ocp {

/// A limit that holds at one of its bounds, c(y, u) = b.
struct HeldLimit {
  std::size_t limit = 0;
  double bound = 0.0;
};

/// The motion and its costates on an arc along which one limit holds, or none:
///
///     y' = f(y, u),   p' = −∂𝓗/∂y
///
/// with u from ∂𝓗/∂u = 0 on a free arc, the minimum that the last one leads to;
/// where a limit holds u is from c(y, u) = b, and ∂𝓗/∂u = 0 gives
/// μ = −∂(L + p·f)/∂u / ∂c/∂u.
template <class Problem, class Scalar = double>
requires PointFunction<Problem, Scalar> || PointFunction<Problem>
class Flow {
 public:
  static constexpr std::size_t kStates = Problem::kStates;
  static constexpr std::size_t kControl = kStates;  ///< its place in a point
  static constexpr std::size_t kSize = 2 * kStates;
  static constexpr std::size_t kIgnorable = ignorable_states<Problem>();
  static constexpr int kPoint = static_cast<int>(kStates) + 1;
  using Number = Scalar;
  /// States, then their costates.
  using State = std::array<Scalar, kSize>;
  using FirstOrder = math::Jet1<Scalar, kPoint>;
  using SecondOrder = math::Jet2<Scalar, kPoint>;

  explicit Flow(Problem problem, std::optional<HeldLimit> held = {})
      : problem_(std::move(problem)), held_(held) {}

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const std::optional<HeldLimit>& held() const { return held_; }

  /// What the error of a component of the state counts.
  [[nodiscard]] double error_weight(std::size_t i) const {
    if (i < kStates) return 1.0;
    return judges_costates ? problem_.costate_weight(i - kStates) : 0.0;
  }
  /// Whether errors of costates count, which mean nothing on some arcs.
  bool judges_costates = true;

  [[nodiscard]] bool has_surface() const { return problem_.has_surface(); }
  /// Positive on one side of the surface, above it.
  [[nodiscard]] double height(const State& y) const {
    return problem_.height(y);
  }
  /// ∇h of that height.
  [[nodiscard]] std::array<Scalar, kStates> height_gradient(
      const State& y) const {
    using Jet = math::Jet1<Scalar, static_cast<int>(kStates)>;
    std::array<Scalar, kStates> states;
    std::copy_n(y.begin(), kStates, states.begin());
    return problem_.height(as_variables<Jet>(states)).gradient;
  }
  /// The same with the law of one side of the surface on both.
  [[nodiscard]] Flow on_side(bool above) const {
    Flow there = *this;
    there.problem_.keep_to_side(above);
    return there;
  }

  /// All that follows from one state, with derivatives by the point.
  template <class Jet>
  struct At {
    Scalar control{};
    Scalar multiplier{};  ///< μ; 0 on a free arc
    Rates<Jet, kStates> rates;
    Jet limit;        ///< c − b
    Jet hamiltonian;  ///< 𝓗, with μ as a constant
  };

  /// \tparam Jet      FirstOrder, or SecondOrder for variations and where the
  ///                  second derivative on a free arc is asked for
  /// \param  control  [in,out] near which u is searched
  /// \return false if there is none
  template <class Jet>
  [[nodiscard]] bool find(const State& y, Scalar& control, At<Jet>& at) const {
    using math::magnitude;
    control = held_ ? control_of_limit(y, control) : control_of(y, control);
    if (!(magnitude(control) < kInfinity)) return false;
    at.control = control;
    const PointOf<Problem, Scalar> here = point(y, control);
    if constexpr (requires { problem_.template jets<Jet>(here); }) {
      at.rates = problem_.template jets<Jet>(here);
    } else {
      at.rates = problem_.rates(as_variables<Jet>(here));
    }
    at.hamiltonian = at.rates.cost;
    for (std::size_t i = 0; i < kStates; ++i) {
      const Scalar& p = y[kStates + i];
      at.hamiltonian +=
          at.rates.states[i].chain(at.rates.states[i].value * p, p);
    }
    if (!held_) return true;
    at.limit = problem_.limit(held_->limit, as_variables<Jet>(here)) -
               Jet(Scalar(held_->bound));
    at.multiplier =
        -at.hamiltonian.gradient[kControl] / at.limit.gradient[kControl];
    at.hamiltonian += at.limit * Jet(at.multiplier);
    return magnitude(at.multiplier) < kInfinity;
  }

  /// y' and p'.
  template <class Jet>
  [[nodiscard]] static State rates(const At<Jet>& at) {
    State out;
    for (std::size_t i = 0; i < kStates; ++i) {
      out[i] = at.rates.states[i].value;
      out[kStates + i] = -at.hamiltonian.gradient[i];
    }
    return out;
  }

  /// ∂²𝓗/∂u², positive on a free arc that is a minimum.
  [[nodiscard]] static Scalar legendre(const At<SecondOrder>& at) {
    return at.hamiltonian.second(kControl, kControl);
  }

  /// How u and μ change with the state.
  struct Eliminated {
    State control, multiplier;
  };
  [[nodiscard]] Eliminated eliminated(const At<SecondOrder>& at) const {
    const SecondOrder& h = at.hamiltonian;
    const Scalar h_uu = h.second(kControl, kControl);
    // ∂²𝓗/∂u∂(y, p)
    State mixed;
    for (std::size_t i = 0; i < kStates; ++i) {
      mixed[i] = h.second(kControl, i);
      mixed[kStates + i] = at.rates.states[i].gradient[kControl];
    }
    Eliminated out{};
    if (!held_) {
      const Scalar factor = Scalar(-1.0) / h_uu;
      for (std::size_t i = 0; i < kSize; ++i) {
        out.control[i] = mixed[i] * factor;
      }
      return out;
    }
    const Scalar factor = Scalar(-1.0) / at.limit.gradient[kControl];
    for (std::size_t i = 0; i < kStates; ++i) {
      out.control[i] = at.limit.gradient[i] * factor;
    }
    // ∂𝓗/∂u stays zero: c_u δμ = −(𝓗_uu δu + 𝓗_uy δy + f_u·δp).
    for (std::size_t i = 0; i < kSize; ++i) {
      out.multiplier[i] = (mixed[i] + h_uu * out.control[i]) * factor;
    }
    return out;
  }

  /// Derivatives of the rates by the state, and in a last row those of L.
  using Linearisation = std::array<State, kSize + 1>;
  [[nodiscard]] Linearisation linearisation(const At<SecondOrder>& at) const {
    const Eliminated by = eliminated(at);
    const SecondOrder& h = at.hamiltonian;
    Linearisation out;
    const auto put = [&](const SecondOrder& value, State& row) {
      const Scalar by_control = value.gradient[kControl];
      for (std::size_t j = 0; j < kSize; ++j) {
        row[j] = by_control * by.control[j];
        if (j < kStates) row[j] += value.gradient[j];
      }
    };
    for (std::size_t i = 0; i < kStates; ++i) {
      put(at.rates.states[i], out[i]);
      State& row = out[kStates + i];
      const Scalar by_control = h.second(kControl, i);
      for (std::size_t j = 0; j < kStates; ++j) {
        row[j] = -(h.second(i, j) + by_control * by.control[j]);
        row[kStates + j] = -(at.rates.states[j].gradient[i] +
                             by_control * by.control[kStates + j]);
      }
      if (!held_) continue;
      for (std::size_t j = 0; j < kSize; ++j) {
        row[j] -= at.limit.gradient[i] * by.multiplier[j];
      }
    }
    put(at.rates.cost, out[kSize]);
    return out;
  }

  /// 𝓗 with its first two derivatives by the control.
  [[nodiscard]] ByControl<Scalar> by_control(const State& y,
                                             const Scalar& control) const {
    if constexpr (requires { problem_.hamiltonian_by_control(y, control); }) {
      return problem_.hamiltonian_by_control(y, control);
    } else {
      using Jet = math::Jet2<Scalar, 1>;
      const auto at = problem_.rates(steered<Jet>(y, control));
      Jet h = at.cost;
      for (std::size_t i = 0; i < kStates; ++i) {
        h += at.states[i] * Jet(y[kStates + i]);
      }
      return {h.value, h.gradient[0], h.hessian[0]};
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  [[nodiscard]] static PointOf<Problem, Scalar> point(const State& y,
                                                      const Scalar& control) {
    PointOf<Problem, Scalar> out;
    std::copy_n(y.begin(), kStates, out.begin());
    out[kControl] = control;
    return out;
  }
  /// The same point, in which the control alone is a variable.
  template <class Jet>
  [[nodiscard]] static PointOf<Problem, Jet> steered(const State& y,
                                                     const Scalar& control) {
    PointOf<Problem, Jet> out;
    for (std::size_t i = 0; i < kStates; ++i) out[i] = Jet(y[i]);
    out[kControl] = Jet::variable(control, 0);
    return out;
  }

  [[nodiscard]] Scalar control_of(const State& y, const Scalar& near) const {
    if constexpr (requires { problem_.least_control(y, near); }) {
      return problem_.least_control(y, near);
    } else {
      return math::nearest_minimum(
          [&](const Scalar& u) { return by_control(y, u); }, near);
    }
  }

  /// Newton's method; limits are affine in the control or nearly so.
  [[nodiscard]] Scalar control_of_limit(const State& y,
                                        const Scalar& near) const {
    using math::magnitude;
    using Jet = math::Jet1<Scalar, 1>;
    constexpr int kMostSteps = 30;
    constexpr double kLastStep = 1e-9;  // its square is below rounding
    Scalar control = near;
    for (int i = 0; i < kMostSteps; ++i) {
      const Jet c = problem_.limit(held_->limit, steered<Jet>(y, control));
      const Scalar step = (Scalar(held_->bound) - c.value) / c.gradient[0];
      control = control + step;
      if (!(magnitude(step) > kLastStep * (1.0 + magnitude(control)))) {
        break;
      }
    }
    return control;
  }

  Problem problem_;
  std::optional<HeldLimit> held_;
};

}  // namespace brachisto::ocp
