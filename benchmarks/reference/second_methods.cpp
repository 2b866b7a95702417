// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reference/second_methods.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace brachisto::benchmarks {

namespace {

using Real = long double;
constexpr Real kPi = std::numbers::pi_v<Real>;

/// Where a function that ascends or descends vanishes.
Real root(const std::function<Real(Real)>& f, Real low, Real high) {
  const bool ascends = f(high) > 0.0L;
  for (int i = 0; i < 80; ++i) {
    const Real middle = 0.5L * (low + high);
    ((f(middle) > 0.0L) == ascends ? high : low) = middle;
  }
  return 0.5L * (low + high);
}

template <std::size_t Size>
using State = std::array<Real, Size>;

/// From 0 to `until`.
template <std::size_t Size, class Rates>
State<Size> integrated(State<Size> y, Real from, Real until, Rates&& rates) {
  namespace odeint = boost::numeric::odeint;
  constexpr Real kTolerance = 1e-15L;
  odeint::integrate_adaptive(
      odeint::make_controlled(
          kTolerance, kTolerance,
          odeint::runge_kutta_fehlberg78<State<Size>, Real>()),
      [&](const State<Size>& at, State<Size>& slope, Real t) {
        rates(at, slope, t);
      },
      y, from, until, (until - from) * 1e-3L);
  return y;
}

/// By steps of one length, backwards in time, each with one phase of the
/// control: where another one begins a step ends, found by bisection.
///
/// \param rates     of a state in a phase
/// \param phase_of  −1, 0, 1: at the lower bound, between, at the upper one
template <std::size_t Size, class Rates, class PhaseOf>
State<Size> integrated_by_phases(State<Size> y, Real duration, Rates&& rates,
                                 PhaseOf&& phase_of) {
  boost::numeric::odeint::runge_kutta_fehlberg78<State<Size>, Real> stepper;
  constexpr int kSteps = 1000, kHalvings = 70;
  int phase = phase_of(y);
  const auto after = [&](Real h) {
    State<Size> out = y;
    stepper.do_step(
        [&](const State<Size>& at, State<Size>& slope, Real) {
          slope = rates(at, phase);
          for (Real& s : slope) s = -s;
        },
        out, 0.0L, h);
    return out;
  };
  for (int i = 0; i < kSteps; ++i) {
    Real left = duration / kSteps;
    while (phase_of(after(left)) != phase) {
      Real low = 0.0L, high = left;
      for (int k = 0; k < kHalvings; ++k) {
        const Real middle = 0.5L * (low + high);
        (phase_of(after(middle)) == phase ? low : high) = middle;
      }
      const State<Size> there = after(high);
      y = there;
      phase = phase_of(there);
      left -= high;
    }
    y = after(left);
  }
  return y;
}

/// Newton's method for two unknowns, by differences.
template <class Residual>
State<2> two_roots(State<2> x, Residual&& residual) {
  constexpr Real kStep = 1e-8L, kGood = 1e-15L;
  for (int i = 0; i < 30; ++i) {
    const State<2> r = residual(x);
    if (std::max(std::abs(r[0]), std::abs(r[1])) < kGood) return x;
    Real J[2][2];
    for (std::size_t k = 0; k < 2; ++k) {
      State<2> up = x, down = x;
      up[k] += kStep, down[k] -= kStep;
      const State<2> a = residual(up), b = residual(down);
      for (std::size_t j = 0; j < 2; ++j) {
        J[j][k] = (a[j] - b[j]) / (2.0L * kStep);
      }
    }
    const Real det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    x[0] -= (r[0] * J[1][1] - r[1] * J[0][1]) / det;
    x[1] -= (r[1] * J[0][0] - r[0] * J[1][0]) / det;
  }
  const State<2> r = residual(x);
  constexpr Real kEnough = 1e-12L;
  if (std::max(std::abs(r[0]), std::abs(r[1])) < kEnough) return x;
  throw std::runtime_error("shooting has not converged");
}

}  // namespace

double cycloid_time(double L) {
  // x = R (φ − sin φ), y = R (1 − cos φ).
  const Real phi =
      root([&](Real p) { return (p - std::sin(p)) - L * (1.0L - std::cos(p)); },
           0.1L, 2.0L * kPi - 1e-6L);
  const Real R = 1.0L / (1.0L - std::cos(phi));
  return static_cast<double>(std::sqrt(R / 0.5L) * phi);
}

double time_to_line(double g) {
  return static_cast<double>(std::sqrt(kPi / static_cast<Real>(g)));
}

double time_along_wall(double g_as_given) {
  const Real g = g_as_given, slope = 0.5L, offset = 0.1L;
  // The slope of a cycloid is cot(φ/2).
  const Real phi = 2.0L * std::atan(1.0L / slope);
  const Real x = phi - std::sin(phi), y = 1.0L - std::cos(phi);
  const Real first = offset / (y - slope * x);
  // From a place of the same slope to the horizontal at x = 1.
  const Real rest = kPi - phi + std::sin(phi);
  const Real second = (offset + slope) / (y + slope * rest);
  const Real from = first * y, to = second * y;
  const Real sine = slope / std::hypot(1.0L, slope);
  const auto speed = [&](Real depth) { return std::sqrt(2.0L * g * depth); };
  return static_cast<double>(std::sqrt(first / g) * phi +
                             (speed(to) - speed(from)) / (g * sine) +
                             std::sqrt(second / g) * (kPi - phi));
}

double hanging_chain() {
  const Real a = root(
      [](Real s) { return 2.0L * s * std::sinh(0.5L / s) - std::sqrt(12.0L); },
      0.05L, 10.0L);
  const Real b = 0.5L - a * std::atanh(0.5L);
  const Real c = 1.0L - a * std::cosh(b / a);
  return static_cast<double>(
      0.5L * a +
      0.25L * a * a *
          (std::sinh(2.0L * (1.0L - b) / a) + std::sinh(2.0L * b / a)) +
      4.0L * c);
}

double van_der_pol() {
  // p' = −∂𝓗/∂x, u = −p₁/2 within its bounds, from p(5) = 0.
  const auto rates = [](const State<5>& y, int phase) {
    const auto [x1, x2, p1, p2, J] = y;
    const Real u = phase < 0 ? -0.3L : phase > 0 ? 1.0L : -0.5L * p1;
    return State<5>{(1.0L - x2 * x2) * x1 - x2 + u, x1,
                    -(2.0L * x1 + p1 * (1.0L - x2 * x2) + p2),
                    -(2.0L * x2 - p1 * (2.0L * x1 * x2 + 1.0L)),
                    x1 * x1 + x2 * x2 + u * u};
  };
  const auto phase = [](const State<5>& y) {
    const Real u = -0.5L * y[2];
    return u < -0.3L ? -1 : u > 1.0L ? 1 : 0;
  };
  const auto start = [&](const State<2>& end) {
    return integrated_by_phases<5>({end[0], end[1], 0.0L, 0.0L, 0.0L}, 5.0L,
                                   rates, phase);
  };
  const State<2> end = two_roots({0.067L, -0.052L}, [&](const State<2>& x) {
    const State<5> at = start(x);
    return State<2>{at[0], at[1] - 1.0L};
  });
  return static_cast<double>(-start(end)[4]);
}

double batch_reactor() {
  // 𝓗 depends on the temperature through k₁ and k₂ = 0.03875 k₁²: where it is
  // least k₁ = x₁² (p₂ − p₁)/(2 · 0.03875 x₂ p₂), within its bounds.
  constexpr Real kRatio = 620000.0L / (4000.0L * 4000.0L);
  const Real low = 4000.0L * std::exp(-2500.0L / 298.0L);
  const Real high = 4000.0L * std::exp(-2500.0L / 398.0L);
  const auto above = [](const State<4>& y) {
    return y[0] * y[0] * (y[3] - y[2]);
  };
  const auto below = [](const State<4>& y) {
    return 2.0L * kRatio * y[1] * y[3];
  };
  const auto rates = [&](const State<4>& y, int phase) {
    const auto [x1, x2, p1, p2] = y;
    const Real k1 = phase < 0 ? low : phase > 0 ? high : above(y) / below(y);
    const Real k2 = kRatio * k1 * k1;
    return State<4>{-k1 * x1 * x1, k1 * x1 * x1 - k2 * x2,
                    2.0L * k1 * x1 * (p1 - p2), p2 * k2};
  };
  const auto phase = [&](const State<4>& y) {
    return above(y) < low * below(y) ? -1 : above(y) > high * below(y) ? 1 : 0;
  };
  const auto start = [&](const State<2>& end) {
    return integrated_by_phases<4>({end[0], end[1], 0.0L, 1.0L}, 1.0L, rates,
                                   phase);
  };
  const State<2> end = two_roots({0.298L, 0.611L}, [&](const State<2>& x) {
    const State<4> at = start(x);
    return State<2>{at[0] - 1.0L, at[1]};
  });
  return static_cast<double>(end[1]);
}

double catalyst() {
  const auto remaining = [](const State<2>& t) {
    // u = 1, then what keeps r = x₂/x₁, then u = 0.
    const Real x2 = (1.0L - std::exp(-11.0L * t[0])) / 11.0L, x1 = 1.0L - x2;
    const Real r = x2 / x1, u = r / (1.0L - 8.0L * r - 10.0L * r * r);
    const Real grown = std::exp(u * (10.0L * r - 1.0L) * (t[1] - t[0]));
    return grown * (x1 + x2 * std::exp(-(1.0L - t[1])));
  };
  constexpr Real kStep = 1e-5L;
  const auto slope = [&](const State<2>& t, std::size_t k) {
    const auto by = [&](Real h) {
      State<2> up = t, down = t;
      up[k] += h, down[k] -= h;
      return (remaining(up) - remaining(down)) / (2.0L * h);
    };
    return (4.0L * by(0.5L * kStep) - by(kStep)) / 3.0L;
  };
  // A saddle or a minimum: the sum is least along the first switch.
  State<2> t{0.1363L, 0.7247L};
  for (int i = 0; i < 60; ++i) {
    t[0] = root([&](Real s) { return slope({s, t[1]}, 0); }, 0.1L, 0.2L);
    t[1] = root([&](Real s) { return slope({t[0], s}, 1); }, 0.6L, 0.8L);
  }
  return static_cast<double>(remaining(t) - 1.0L);
}

double robot_arm() {
  constexpr Real L = 5.0L;
  // ρ is drawn in for a quarter of the time and slowed for the next one.
  const auto inertia = [&](Real t, Real T) {
    const Real quarter = 0.25L * T;
    const Real rho = t < quarter ? 4.5L - t * t / (2.0L * L)
                                 : 4.5L - (quarter * quarter +
                                           2.0L * quarter * (t - quarter) -
                                           (t - quarter) * (t - quarter)) /
                                              (2.0L * L);
    return (std::pow(L - rho, 3) + std::pow(rho, 3)) / 3.0L;
  };
  /// φ, φ', θ, θ' at the middle.
  const auto middle = [&](Real T, Real turn) {
    State<4> y{kPi / 4.0L, 0.0L, 0.0L, 0.0L};
    Real from = 0.0L;
    for (const Real to :
         {std::min(turn, 0.25L * T), std::max(turn, 0.25L * T), 0.5L * T}) {
      const Real push = 0.5L * (from + to) < turn ? -1.0L : 1.0L;
      y = integrated<4>(y, from, to,
                        [&](const State<4>& at, State<4>& slope, Real t) {
                          const Real I = inertia(t, T), s = std::sin(at[0]);
                          slope = {at[1], push / I, at[3], 1.0L / (I * s * s)};
                        });
      from = to;
    }
    return y;
  };
  const auto solved = two_roots({9.14L, 2.8L}, [&](const State<2>& x) {
    const State<4> y = middle(x[0], x[1]);
    return State<2>{y[1], y[2] - kPi / 3.0L};
  });
  return static_cast<double>(solved[0]);
}

}  // namespace brachisto::benchmarks
