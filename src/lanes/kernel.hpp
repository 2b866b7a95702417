// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Shooting with scenes side by side, a register full of them. What stands here
/// is compiled once for each set of instructions; nothing but numbers goes in
/// and out.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "lanes/by_share.hpp"
#include "lanes/departure.hpp"
#include "lanes/falling_lanes.hpp"
#include "lanes/kernels.hpp"
#include "lanes/newton_step.hpp"
#include "lanes/second_order.hpp"
#include "lanes/shot.hpp"
#include "ocp/flow.hpp"
#include "ocp/integration.hpp"

namespace brachisto::lanes {

namespace detail {

template <Instructions Set, Surroundings In>
class Shooting {
 public:
  static constexpr std::size_t kLanes = lanes_of(Set);
  using Number = Lane<static_cast<int>(Set), kLanes>;
  using Problem = FallingLanes<Number, In>;
  using Flow = ocp::Flow<Problem, Number>;
  using State = typename Flow::State;
  using Mask = typename Number::Mask;
  static constexpr std::size_t kUnknowns = Extremal::kUnknowns;
  using Unknowns = std::array<Number, kUnknowns>;
  using Shot = detail::Shot<Number, State>;

  Shooting(const Targets& targets, const Fineness& fineness)
      : targets_(targets), fineness_(fineness) {
    world_.side = targets.front().side;
    each([&](std::size_t i, const Target& target) {
      for (std::size_t j = 0; j < kUnknowns; ++j) {
        by_[j].set(i, target.unknowns[j]);
      }
      sign_.set(i, target.sign);
    });
  }

  void run(Extremals& out) {
    good_ = Number(1.0) > Number(0.0);
    follow_way();
    finish(out);
  }
  /// Where the unknowns lead at the end of the way.
  void land(Landings& out) {
    pass(last_step());
    const Shot shot = shoot<false>(by_, half(), kIgnore);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (std::size_t j = 0; j < kUnknowns; ++j) {
        out[lane].residual[j] = shot.residual[j][lane];
      }
      out[lane].transit_time = shot.T[lane];
      out[lane].beta = shot.beta[lane];
      out[lane].start_beta = shot.start_beta[lane];
    }
  }
  /// And how that answers to them.
  void respond(Responses& out) {
    pass(last_step());
    const Shot shot = shoot<true>(by_, half(), kIgnore);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (std::size_t j = 0; j < kUnknowns; ++j) {
        Landing& by = out[lane][j];
        for (std::size_t i = 0; i < kUnknowns; ++i) {
          by.residual[i] = shot.jacobian[i][j][lane];
        }
        by.transit_time = shot.time_by[j][lane];
        by.beta = shot.beta_by[j][lane];
        by.start_beta = shot.start_beta_by[j][lane];
      }
    }
  }

 private:
  static constexpr auto kIgnore = [](auto&&...) {};

  template <class Do>
  void each(Do&& act) const {
    for (std::size_t i = 0; i < kLanes; ++i) act(i, targets_[i]);
  }

  void pass(int step) {
    each([&](std::size_t i, const Target& target) {
      const Milestone& at = target.way[static_cast<std::size_t>(step)];
      bodies_.set(i, at);
      world_.set(i, at);
      radius_.set(i, at.contact_radius);
      turn_.set(i, at.rotation_per_length);
      L_.set(i, at.L);
      H_.set(i, at.H);
      start_angle_.set(i, at.start_angle);
      start_speed_.set(i, at.start_speed);
    });
  }
  [[nodiscard]] int last_step() const { return targets_.front().steps; }
  /// Steps of shots that are doubled for the error.
  [[nodiscard]] int half() const {
    return fineness_.places * fineness_.within / 2;
  }

  [[nodiscard]] Flow flow() const {
    return Flow(Problem(bodies_, turn_, world_));
  }

  [[nodiscard]] Departures<Flow> departures(const Flow& flow) const {
    return {flow, bodies_.theta_m, radius_, start_speed_, start_angle_};
  }

  /// From the start to σ = 1; `on_step(i, stack, control)` sees every step.
  template <bool Derivatives, class OnStep>
  [[nodiscard]] Shot shoot(const Unknowns& by, int steps, OnStep&& on_step,
                           Leaving leaving = Leaving::Turning) const {
    const Flow flow = this->flow();
    using Inner = ocp::FlowRates<Flow, Derivatives, kPX, kPTheta + 1>;
    using Path = ocp::AdaptiveIntegration<ByShare<Inner, Number>>;
    const auto start = departures(flow).with({by[0], by[1], by[2]});
    LastControls<Number> controls;
    Path path({Inner{flow, start.beta}, by[3], &controls},
              start.template stack<Inner>(leaving));
    on_step(0, flow, path.now(), path.rates().inner.control);
    Jacobi<Number> jacobi{Neighbours<Inner>::sign_at_first(path.slope())};
    const Pull<Number> first = flow.problem().pull(start.y);
    for (int i = 1; i <= steps; ++i) {
      path.step_unchecked(1.0 / steps);
      on_step(i, flow, path.now(), path.rates().inner.control);
      if constexpr (Derivatives) {
        const auto beside = neighbours<Inner>(flow, path, first);
        if (i > beside.kUnseen * steps) jacobi.see(beside.share());
      }
    }
    Shot out = arrived<Derivatives, Inner>(flow, path, by, jacobi, first);
    out.start_beta = start.beta;
    out.start_beta_by = {start.beta_by[0], start.beta_by[1], start.beta_by[2],
                         Number(0.0)};
    return out;
  }

  template <class Inner>
  using Neighbours = std::conditional_t<In.air, BrakedNeighbours<Inner>,
                                        FreeNeighbours<Inner>>;

  template <class Inner, class Path>
  [[nodiscard]] auto neighbours(const Flow& flow, const Path& path,
                                const Pull<Number>& first) const {
    const Number& beta = path.rates().inner.control;
    return Neighbours<Inner>(path.now(), path.slope(), flow.problem(), first,
                             cos(beta), sin(beta));
  }

  template <bool Derivatives, class Inner, class Path>
  [[nodiscard]] Shot arrived(const Flow& flow, const Path& path,
                             const Unknowns& by, const Jacobi<Number>& jacobi,
                             const Pull<Number>& first) const {
    const auto& now = path.now();
    Shot out;
    out.y = Inner::state_of(now);
    out.T = now[Inner::kCost];
    out.beta = path.rates().inner.control;
    const Number c = cos(out.beta), s = sin(out.beta);
    out.residual = {out.y[kX] - (L_ + radius_ * s),
                    out.y[kZ] - (H_ - radius_ * c), out.y[kPTheta] * turn_,
                    out.y[kPW]};
    for (std::size_t i = 0; i < Flow::kSize; ++i) {
      out.rates[i] = path.slope()[i] / by[3];
    }
    if constexpr (Derivatives) {
      typename Flow::template At<typename Flow::SecondOrder> at;
      Number control = out.beta;
      static_cast<void>(flow.find(out.y, control, at));
      const State beta_by = flow.eliminated(at).control;
      for (std::size_t j = 0; j < kUnknowns; ++j) {
        State change;
        for (std::size_t i = 0; i < Flow::kSize; ++i) {
          change[i] =
              j == 3 ? out.rates[i] : Inner::derivative(now, i, kPX + j);
        }
        Number beta(0.0);
        for (std::size_t i = 0; i < Flow::kSize; ++i) {
          beta = beta + beta_by[i] * change[i];
        }
        out.jacobian[0][j] = change[kX] - radius_ * c * beta;
        out.jacobian[1][j] = change[kZ] - radius_ * s * beta;
        out.jacobian[2][j] = change[kPTheta] * turn_;
        out.jacobian[3][j] = change[kPW];
        out.beta_by[j] = beta;
        out.time_by[j] = j == 3 ? path.slope()[Inner::kCost] / by[3]
                                : Inner::derivative(now, Inner::kCost, kPX + j);
      }
      out.least_jacobian = jacobi.least;
      out.last_jacobian = jacobi.last;
      out.by_length = neighbours<Inner>(flow, path, first).by_length(by[3]);
    }
    return out;
  }

  /// The largest part of a step, costates and times in units of their own.
  [[nodiscard]] Number size(const Unknowns& step) const {
    const Number p = sqrt(by_[0] * by_[0] + by_[1] * by_[1]);
    Number largest = abs(step[0]) / p;
    for (const Number& other :
         {Number(abs(step[1]) / p), Number(abs(step[2]) * turn_ / p),
          Number(abs(step[3]) / by_[3])}) {
      // Written so that no number is the largest.
      largest = where(!(other < largest), other, largest);
    }
    return largest;
  }

  void follow_way();
  void finish(Extremals& out);

  const Targets& targets_;
  const Fineness& fineness_;
  Bodies<Number> bodies_;
  Number radius_, turn_, L_, H_, start_angle_, start_speed_;
  Worlds<Number> world_;
  Unknowns by_;
  Mask good_;
  Number sign_;
};

template <Instructions Set, Surroundings In>
void Shooting<Set, In>::follow_way() {
  constexpr double kFarthest = 0.5;  // of a prediction from the branch
  constexpr double kNear = 5e-3;     // the next step would be its square
  constexpr int kMostSteps = 4;
  std::array<Unknowns, 3> past{by_, by_, by_};
  for (int step = 1; step <= last_step(); ++step) {
    pass(step);
    // By the polynomial through the last ones, equally far apart, on this side
    // of where the way turns into the world.
    const int here = step - (step > fineness_.offsets ? fineness_.offsets : 0);
    for (std::size_t j = 0; j < kUnknowns; ++j) {
      const Number &a = past[0][j], &b = past[1][j], &c = past[2][j];
      by_[j] = here == 1   ? a
               : here == 2 ? Number(a * 2.0 - b)
                           : Number((a - b) * 3.0 + c);
    }
    auto moving = good_;
    for (int i = 0; i < kMostSteps && any(moving); ++i) {
      const Shot shot = shoot<true>(by_, fineness_.on_the_way, kIgnore);
      const auto solved = newton_step(shot.jacobian, shot.residual);
      if (step == 1 && i == 0) {
        sign_ = where(Number(sign_ * sign_) > Number(0.0), sign_, solved.sign);
      }
      const Number far = size(solved.step);
      const auto bad =
          (!(far < Number(kFarthest))) | (!(solved.sign * sign_ > Number(0.0)));
      good_ = good_ & !(moving & bad);
      moving = moving & !bad;
      for (std::size_t j = 0; j < kUnknowns; ++j) {
        by_[j] = where(moving, Number(by_[j] + solved.step[j]), by_[j]);
      }
      moving = moving & (far > Number(kNear));
    }
    good_ = good_ & !moving;
    past = {by_, past[0], past[1]};
  }
}

template <Instructions Set, Surroundings In>
void Shooting<Set, In>::finish(Extremals& out) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  constexpr double kClosed = 1e-10;
  constexpr int kMostSteps = 5;
  const int half = this->half(), steps = 2 * half;
  Shot whole{};
  // T to B itself, to the second order of what is missed.
  const auto time_of = [&](const Shot& shot, const Unknowns& step) {
    Number T = shot.T;
    for (std::size_t j = 0; j < kUnknowns; ++j) {
      T = T + whole.time_by[j] * step[j];
    }
    return T;
  };
  Number T_half(0.0);
  auto moving = good_;
  for (int i = 0; i < kMostSteps && any(moving); ++i) {
    // What has arrived keeps what it arrived with, however long others go on.
    if (i < 2) {
      whole.take(shoot<true>(by_, half, kIgnore), moving);
    } else {
      whole.take_values(shoot<false>(by_, half, kIgnore), moving);
    }
    const auto solved = newton_step(whole.jacobian, whole.residual);
    const Number far = size(solved.step);
    T_half = where(moving, time_of(whole, solved.step), T_half);
    for (std::size_t j = 0; j < kUnknowns; ++j) {
      by_[j] = where(moving, Number(by_[j] + solved.step[j]), by_[j]);
    }
    moving = moving & !(far < Number(kClosed));
  }
  good_ = good_ & !moving;
  const bool pushed = any(start_speed_ > Number(0.0));
  if (pushed) {
    const Shot held = shoot<true>(by_, half, kIgnore, Leaving::Held);
    whole.least_jacobian = held.least_jacobian;
    whole.last_jacobian = held.last_jacobian;
    whole.by_length = held.by_length;
  }

  // Once to take up what doubled steps change, once for the path.
  const Shot first = shoot<In.air>(by_, steps, kIgnore, Leaving::Held);
  const Shot& finest = In.air ? first : whole;
  if constexpr (In.air) {
    // The determinant goes as the drag squared: it is seen where doubled steps
    // change little of it, and it is more than rounding.
    constexpr double kSeen = 0.1;
    const Number changed =
        abs(first.last_jacobian - whole.last_jacobian) + Number(kUlp * steps);
    good_ = good_ & (changed < Number(first.last_jacobian * kSeen));
  }
  good_ = good_ & (finest.least_jacobian > Number(0.0)) &
          (finest.by_length > Number(0.0));
  const auto solved = newton_step(whole.jacobian, first.residual);
  for (std::size_t j = 0; j < kUnknowns; ++j) {
    by_[j] = by_[j] + solved.step[j];
  }
  Number least_legendre(std::numeric_limits<double>::infinity());
  const Shot last = shoot<false>(
      by_, steps,
      [&](int i, const Flow& flow, const auto& stack, const Number& control) {
        if (i % fineness_.within != 0) return;
        State y;
        std::copy_n(stack.begin(), Flow::kSize, y.begin());
        typename Flow::template At<typename Flow::SecondOrder> at;
        Number beta = control;
        static_cast<void>(flow.find(y, beta, at));
        const Number legendre = Flow::legendre(at);
        least_legendre =
            where(!(legendre > least_legendre), legendre, least_legendre);
        const State by_state = flow.eliminated(at).control;
        const State rates = Flow::rates(at);
        Number beta_rate(0.0);
        for (std::size_t j = 0; j < Flow::kSize; ++j) {
          beta_rate = beta_rate + by_state[j] * rates[j];
        }
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          out[lane].path[static_cast<std::size_t>(i / fineness_.within)] = {
              .x = y[kX][lane],
              .z = y[kZ][lane],
              .theta = y[kTheta][lane],
              .w = y[kW][lane],
              .p_x = y[kPX][lane],
              .p_z = y[kPZ][lane],
              .p_theta = y[kPTheta][lane],
              .p_w = y[kPW][lane],
              .beta = beta[lane],
              .beta_rate = beta_rate[lane],
              .t = stack[Flow::kSize][lane],
              .root = at.rates.cost.value[lane]};
        }
      });
  const auto missed = [&](const Unknowns& residual) {
    return newton_step(whole.jacobian, residual).step;
  };
  const Number T = time_of(last, missed(last.residual));
  // Every step rounds the states, which T feels through the costates; these
  // errors are independent.
  const Number touched = abs(by_[0] * L_) + abs(by_[1] * H_) + abs(T);
  Number error = abs(T - T_half) + touched * (kUlp * std::sqrt(1.0 + steps));
  if (pushed) {
    // The costates round as well, and pushed the start goes with them: what is
    // left of p_θ and p_w at B tells by how much.
    const Number none(0.0);
    for (const Unknowns& costate :
         {Unknowns{none, none, last.residual[2], none},
          Unknowns{none, none, none, last.residual[3]}}) {
      error = error + abs(time_of(last, missed(costate)) - last.T);
    }
  }
  error = error / T;
  Number mismatch(0.0);
  for (const Number& off : last.residual) {
    mismatch = where(!(abs(off) < mismatch), abs(off), mismatch);
  }
  const Number one = where(good_, Number(1.0), Number(0.0));
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    Extremal& found = out[lane];
    found.found = one[lane] > 0.0 && std::isfinite(error[lane]) &&
                  std::isfinite(mismatch[lane]);
    found.transit_time = T[lane];
    found.error_estimate = error[lane];
    found.phi = last.beta[lane];
    found.mismatch = mismatch[lane];
    found.min_legendre = least_legendre[lane];
    found.by_length = finest.by_length[lane];
    found.least_jacobian = finest.least_jacobian[lane];
    found.places = fineness_.places;
    found.sign = sign_[lane];
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      found.unknowns[i] = by_[i][lane];
    }
  }
}

}  // namespace detail

template <Instructions Set, Surroundings In>
void Kernel<Set, In>::shoot(const Targets& targets, const Fineness& fineness,
                            Extremals& out) {
  detail::Shooting<Set, In>(targets, fineness).run(out);
}

template <Instructions Set, Surroundings In>
void Kernel<Set, In>::land(const Targets& targets, const Fineness& fineness,
                           Landings& out) {
  detail::Shooting<Set, In>(targets, fineness).land(out);
}

template <Instructions Set, Surroundings In>
void Kernel<Set, In>::respond(const Targets& targets, const Fineness& fineness,
                              Responses& out) {
  detail::Shooting<Set, In>(targets, fineness).respond(out);
}

}  // namespace brachisto::lanes
