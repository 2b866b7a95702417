// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How bodies leave A, from rest or pushed: the slope there, and p_w by 𝓗 = 0.

#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "lanes/lane.hpp"
#include "lanes/second_order.hpp"

namespace brachisto::lanes::detail {

/// What derivatives by costates at the start belong to: the contact turns about
/// A as the costates have it, or the state stays where it is.
enum class Leaving { Turning, Held };

/// Starts with given p_x, p_z and p_θ. With a push v₀ the slope at A is the
/// one that makes 𝓗 minimal where the centre is and has w by that slope:
///
///     β = argmin 𝓗(r sin β, −r cos β, θ_m, v₀ √A(θ_m, β), p),   𝓗 = 0.
///
/// At rest it does not depend on the costates.
template <class Flow>
class Departures {
 public:
  using Number = typename Flow::Number;
  using State = typename Flow::State;
  static constexpr std::size_t kCostates = 3;
  using Costates = std::array<Number, kCostates>;

  struct Start {
    Number beta;
    State y;
    // Derivatives of the state by β and by each costate with β held, and of β
    // by them; 0 at rest, where p_w goes with none.
    State turning{};
    Costates p_w_by, beta_by;

    template <class Rates>
    [[nodiscard]] typename Rates::Stack stack(Leaving leaving) const {
      auto out = Rates::stack_of(y);
      if constexpr (Rates::kColumns > 0) {
        for (std::size_t j = 0; j < kCostates; ++j) {
          const auto at = [&](std::size_t i) -> Number& {
            return out[Rates::row_of(i) + j];
          };
          at(kPW) = p_w_by[j];
          if (leaving == Leaving::Held) continue;
          for (const std::size_t i : {kX, kZ, kW, kPW}) {
            at(i) = at(i) + turning[i] * beta_by[j];
          }
        }
      }
      return out;
    }
  };

  Departures(const Flow& flow, const Number& theta_m, const Number& radius,
             const Number& speed, const Number& at_rest)
      : flow_(flow),
        theta_m_(theta_m),
        radius_(radius),
        speed_(speed),
        at_rest_(at_rest) {}

  [[nodiscard]] Start with(const Costates& p) const {
    constexpr int kMostSteps = 12;
    constexpr double kLastStep = 1e-9;  // its square is below rounding
    Start out = left(p, at_rest_);
    if (!any(speed_ > Number(0.0))) return out;
    auto moving = Number(1.0) > Number(0.0);
    for (int i = 0;; ++i) {
      typename Flow::template At<typename Flow::SecondOrder> at;
      Number least = out.beta;
      static_cast<void>(flow_.find(out.y, least, at));
      const State by_state = flow_.eliminated(at).control;
      const auto& f = at.rates.states;
      const Number w_by = at.rates.cost.gradient[Flow::kControl] * speed_;
      out.turning[kX] = radius_ * cos(least);
      out.turning[kZ] = radius_ * sin(least);
      out.turning[kW] = w_by;
      const auto& h = at.hamiltonian.gradient;
      Number gained = h[kW] * w_by;
      if constexpr (Flow::kIgnorable == 0) {
        gained = gained + h[kX] * out.turning[kX] + h[kZ] * out.turning[kZ];
      }
      out.turning[kPW] = -(gained / f[kW].value);
      Number by_itself(0.0);
      for (const std::size_t j : {kX, kZ, kW, kPW}) {
        by_itself = by_itself + by_state[j] * out.turning[j];
      }
      const Number rest = Number(1.0) - by_itself;
      for (std::size_t j = 0; j < kCostates; ++j) {
        out.p_w_by[j] = -(f[j].value / f[kW].value);
        out.beta_by[j] =
            (by_state[kPX + j] + by_state[kPW] * out.p_w_by[j]) / rest;
      }
      if (i == kMostSteps || !any(moving)) break;
      const Number step = (least - out.beta) / rest;
      const Start next =
          left(p, where(moving, Number(out.beta + step), out.beta));
      out.beta = next.beta;
      out.y = next.y;
      moving = moving & (abs(step) > Number(kLastStep));
    }
    const Number none(std::numeric_limits<double>::quiet_NaN());
    out.beta = where(moving, none, out.beta);
    return out;
  }

 private:
  [[nodiscard]] Start left(const Costates& p, const Number& beta) const {
    const auto& problem = flow_.problem();
    const Number root = root_of_inertia(problem.bodies(), theta_m_, beta);
    const Number w = root * speed_;
    const Number x = radius_ * sin(beta), z = -(radius_ * cos(beta));
    const auto f =
        problem
            .template jets<typename Flow::FirstOrder>({x, z, theta_m_, w, beta})
            .states;
    Number sum = root;
    for (std::size_t j = 0; j < kCostates; ++j) sum = sum + p[j] * f[j].value;
    Start out;
    out.beta = beta;
    out.y = {x, z, theta_m_, w, p[0], p[1], p[2], -(sum / f[kW].value)};
    out.p_w_by.fill(Number(0.0));
    out.beta_by.fill(Number(0.0));
    out.turning.fill(Number(0.0));
    return out;
  }

  const Flow& flow_;
  const Number &theta_m_, &radius_, &speed_, &at_rest_;
};

}  // namespace brachisto::lanes::detail
