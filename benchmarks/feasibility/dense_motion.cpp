// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "feasibility/dense_motion.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace brachisto::benchmarks {

namespace {

using Real = long double;
/// x, z, θ, w, p_θ, p_w.
using State = std::array<Real, 6>;

struct Vector {
  Real x, z;
};

/// The canonical equations in the rolling time, g = `g`.
class Flow {
 public:
  explicit Flow(const ExtremalCurve& curve)
      : r_(curve.scene().body.radius),
        eta_(curve.scene().body.eta_m),
        k_(curve.scene().body.k),
        g_(curve.scene().gravity),
        p_x_(curve.p_x()),
        p_z_(curve.p_z()) {}

  /// Newton's method on ∂𝓗/∂β = 0.
  [[nodiscard]] Real slope(const State& y, Real near) const {
    Real beta = near;
    for (int i = 0; i < 50; ++i) {
      const Real delta = y[2] - beta;
      const Real root = std::sqrt(inertia(delta));
      const Real c = eta_ * std::cos(delta) / root;
      const Real push_x = y[3] * p_x_;
      const Real push_z = y[3] * p_z_ + g_ * y[5];
      const Real first = c + push_z * std::cos(beta) - push_x * std::sin(beta);
      const Real second = (eta_ * std::sin(delta) - c * c) / root -
                          push_z * std::sin(beta) - push_x * std::cos(beta);
      const Real step = first / second;
      beta -= step;
      if (std::abs(step) < 1e-17L) break;
    }
    return beta;
  }

  void rates(const State& y, State& dy, Real beta) const {
    const Real delta = y[2] - beta;
    const Real c = eta_ * std::cos(delta) / std::sqrt(inertia(delta));
    dy = {y[3] * std::cos(beta),
          y[3] * std::sin(beta),
          y[3] / r_,
          g_ * (std::sin(beta) + eta_ * std::cos(y[2])),
          c + y[5] * g_ * eta_ * std::sin(y[2]),
          -(p_x_ * std::cos(beta) + p_z_ * std::sin(beta) + y[4] / r_)};
  }

  /// Velocity of the centre of mass: momentum over mass.
  [[nodiscard]] Vector momentum(const State& y, Real beta) const {
    const Real v = y[3] / std::sqrt(inertia(y[2] - beta));
    return {v * (std::cos(beta) - eta_ * std::sin(y[2])),
            v * (std::sin(beta) + eta_ * std::cos(y[2]))};
  }
  [[nodiscard]] Vector track(const State& y, Real beta) const {
    return {y[0] - r_ * std::sin(beta), y[1] + r_ * std::cos(beta)};
  }
  /// R_n from dP/du, the rate of momentum in the rolling time.
  [[nodiscard]] Real normal_force(const State& y, Real beta,
                                  Vector rate) const {
    const Real root = std::sqrt(inertia(y[2] - beta));
    const Real R_x = rate.x / (root * g_);
    const Real R_z = rate.z / (root * g_) - 1;
    return R_x * std::sin(beta) - R_z * std::cos(beta);
  }

 private:
  [[nodiscard]] Real inertia(Real delta) const {
    return 1 + eta_ * eta_ + k_ - 2 * eta_ * std::sin(delta);
  }
  Real r_, eta_, k_, g_, p_x_, p_z_;
};

struct Sampled {
  std::vector<State> states;
  std::vector<Real> slopes;
  std::vector<Vector> momenta;
};

/// The states at u = first · h, (first + 1) · h, …, from that at u = 0.
Sampled integrate(const Flow& flow, const State& start, Real beta_0, Real h,
                  int first, int last) {
  using Stepper =
      boost::numeric::odeint::runge_kutta_fehlberg78<State, Real, State, Real>;
  const auto run = [&](Real step, int count) {
    Sampled out;
    State y = start;
    Real beta = beta_0;
    Stepper stepper;
    const auto rates = [&](const State& at, State& dy, Real) {
      flow.rates(at, dy, flow.slope(at, beta));
    };
    for (int i = 0; i <= count; ++i) {
      if (i > 0) stepper.do_step(rates, y, i * step, step);
      beta = flow.slope(y, beta);
      out.states.push_back(y);
      out.slopes.push_back(beta);
      out.momenta.push_back(flow.momentum(y, beta));
    }
    return out;
  };
  Sampled back = run(-h, -first);
  const Sampled on = run(h, last);
  const auto join = [](auto& before, const auto& after) {
    std::reverse(before.begin(), before.end());
    before.insert(before.end(), after.begin() + 1, after.end());
  };
  join(back.states, on.states);
  join(back.slopes, on.slopes);
  join(back.momenta, on.momenta);
  return back;
}

/// dP/du at sample i, of the fourth order.
Vector rate(const std::vector<Vector>& P, std::size_t i, Real h) {
  const auto difference = [&](Real Vector::*c) {
    return (8 * (P[i + 1].*c - P[i - 1].*c) - (P[i + 2].*c - P[i - 2].*c)) /
           (12 * h);
  };
  return {difference(&Vector::x), difference(&Vector::z)};
}

}  // namespace

DenseMotion look_densely(const ExtremalCurve& curve) {
  constexpr int kSamples = 10'000;
  constexpr int kMargin = 2;  // for the differences
  constexpr Real kNextToStart = 1e-6L;
  const Flow flow(curve);
  const ExtremalPoint at = curve.at(0.0);
  const State start{at.centre.x, at.centre.z,  at.theta,
                    0,           at.p.p_theta, at.p.p_w};
  const Real U = curve.rolling_time();
  const Real beta_0 = flow.slope(start, at.beta);

  DenseMotion out;
  {
    const Real h = kNextToStart * U;
    const Sampled near = integrate(flow, start, beta_0, h, -3, 3);
    const auto force = [&](std::size_t i) {
      return flow.normal_force(near.states[i], near.slopes[i],
                               rate(near.momenta, i, h));
    };
    out.start_force_rate = static_cast<double>((force(4) - force(2)) / (2 * h));
    out.start_slope_rate =
        static_cast<double>((near.slopes[4] - near.slopes[2]) / (2 * h));
  }

  const Real h = U / kSamples;
  const Sampled path =
      integrate(flow, start, beta_0, h, -kMargin, kSamples + kMargin);
  out.least_force = std::numeric_limits<double>::infinity();
  out.least_margin = std::numeric_limits<double>::infinity();
  for (int j = 1; j <= kSamples; ++j) {
    const auto i = static_cast<std::size_t>(j + kMargin);
    const Real force = flow.normal_force(path.states[i], path.slopes[i],
                                         rate(path.momenta, i, h));
    const Vector here = flow.track(path.states[i], path.slopes[i]);
    if (!(force >= out.least_force)) {
      out.least_force = static_cast<double>(force);
      out.least_force_x = static_cast<double>(here.x);
    }
    const Vector before = flow.track(path.states[i - 1], path.slopes[i - 1]);
    const Real mean = (path.slopes[i] + path.slopes[i - 1]) / 2;
    const auto along = [&](Vector from, Vector to) {
      return (to.x - from.x) * std::cos(mean) +
             (to.z - from.z) * std::sin(mean);
    };
    const State& y = path.states[i];
    const State& y_before = path.states[i - 1];
    const Real margin =
        along(before, here) / along({y_before[0], y_before[1]}, {y[0], y[1]});
    out.least_margin = std::min(out.least_margin, static_cast<double>(margin));
  }
  const State& end = path.states[static_cast<std::size_t>(kSamples + kMargin)];
  const ExtremalPoint wanted = curve.at(1.0);
  out.miss = static_cast<double>(
      std::hypot(end[0] - wanted.centre.x, end[1] - wanted.centre.z) /
      (curve.scene().L + curve.scene().H));
  return out;
}

}  // namespace brachisto::benchmarks
