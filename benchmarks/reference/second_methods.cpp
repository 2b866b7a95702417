// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reference/second_methods.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "support/closed_forms.hpp"

namespace brachisto::benchmarks {

namespace {

using Real = long double;
constexpr Real kPi = std::numbers::pi_v<Real>;

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

/// Newton's method by differences.
///
/// \param sizes  of the unknowns, for the differences
template <std::size_t Size, class Residual>
State<Size> roots(State<Size> x, const State<Size>& sizes,
                  Residual&& residual) {
  constexpr Real kStep = 1e-8L, kGood = 1e-15L, kEnough = 1e-12L;
  Real last = 0.0L;
  for (int i = 0; i < 30; ++i) {
    State<Size> r = residual(x);
    last = 0.0L;
    for (const Real one : r) last = std::max(last, std::abs(one));
    if (last < kGood) return x;
    std::array<State<Size>, Size> J;
    for (std::size_t k = 0; k < Size; ++k) {
      State<Size> up = x, down = x;
      up[k] += kStep * sizes[k], down[k] -= kStep * sizes[k];
      const State<Size> a = residual(up), b = residual(down);
      for (std::size_t j = 0; j < Size; ++j) {
        J[j][k] = (a[j] - b[j]) / (2.0L * kStep * sizes[k]);
      }
    }
    // Elimination with the largest pivots, then back.
    for (std::size_t k = 0; k < Size; ++k) {
      std::size_t pivot = k;
      for (std::size_t j = k; j < Size; ++j) {
        if (std::abs(J[j][k]) > std::abs(J[pivot][k])) pivot = j;
      }
      std::swap(J[k], J[pivot]), std::swap(r[k], r[pivot]);
      for (std::size_t j = k + 1; j < Size; ++j) {
        const Real by = J[j][k] / J[k][k];
        for (std::size_t l = k; l < Size; ++l) J[j][l] -= by * J[k][l];
        r[j] -= by * r[k];
      }
    }
    for (std::size_t k = Size; k-- > 0;) {
      for (std::size_t l = k + 1; l < Size; ++l) r[k] -= J[k][l] * r[l];
      r[k] /= J[k][k];
      x[k] -= r[k];
    }
  }
  if (last < kEnough) return x;
  throw std::runtime_error("shooting has not converged");
}

template <class Residual>
State<2> two_roots(const State<2>& x, Residual&& residual) {
  return roots<2>(x, {1.0L, 1.0L}, residual);
}

}  // namespace

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
    t[0] = testing::bisected(
        [&](Real s) {
          return slope({s, t[1]}, 0);
        },
        0.1L, 0.2L);
    t[1] = testing::bisected(
        [&](Real s) {
          return slope({t[0], s}, 1);
        },
        0.6L, 0.8L);
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

double shuttle() {
  // Feet, seconds, radians; α in degrees. 𝓗 is least in α and β where the lift
  // points against (p_γ, p_ψ/cos γ), and α balances it with the drag.
  constexpr Real kEarth = 20902900.0L, kMu = 0.14076539e17L;
  constexpr Real kHalfArea = 0.5L * 0.002378L * 2690.0L / (203000.0L / 32.174L);
  constexpr Real kScale = 23800.0L, kDegree = kPi / 180.0L;
  constexpr Real kDrag[]{0.07854L, -0.0061592L, 0.000621408L};
  constexpr Real kLift[]{-0.20704L, 0.029244L};
  using Y = State<10>;
  struct At {
    Y slope;
    Real hamiltonian;
  };
  const auto at = [&](const Y& y) {
    const auto& [h, theta, v, gamma, psi, ph, pt, pv, pg, pp] = y;
    const Real r = h + kEarth, g = kMu / (r * r);
    const Real cg = std::cos(gamma), sg = std::sin(gamma);
    const Real cp = std::cos(psi), sp = std::sin(psi), tt = std::tan(theta);
    const Real q = kHalfArea * std::exp(-h / kScale) * v * v;
    const Real across = std::hypot(pg, pp / cg);
    const Real cb = -pg / across, sb = -pp / cg / across;
    // −p_v (d₁ + 2 d₂ α) = l₁ |(p_γ, p_ψ/cos γ)|/v
    const Real alpha =
        (-kLift[1] * across / (v * pv) - kDrag[1]) / (2.0L * kDrag[2]);
    const Real D = q * (kDrag[0] + alpha * (kDrag[1] + alpha * kDrag[2]));
    const Real L = q * (kLift[0] + alpha * kLift[1]);
    const Y f{v * sg, v / r * cg * cp, -D - g * sg,
              L * cb / v + cg * (v / r - g / v),
              L * sb / (v * cg) + v / r * cg * sp * tt};
    At out{f, ph * f[0] + pt * f[1] + pv * f[2] + pg * f[3] + pp * f[4]};
    out.slope[5] =
        -(-pt * v / (r * r) * cg * cp + pv * (D / kScale + 2.0L * g / r * sg) +
          pg * (-L * cb / (v * kScale) +
                cg * (-v / (r * r) + 2.0L * g / (r * v))) -
          pp * (L * sb / (v * cg * kScale) + v / (r * r) * cg * sp * tt));
    out.slope[6] = -pp * v / r * cg * sp * (1.0L + tt * tt);
    out.slope[7] = -(ph * sg + pt * cg * cp / r - pv * 2.0L * D / v +
                     pg * (L * cb / (v * v) + cg * (1.0L / r + g / (v * v))) +
                     pp * (L * sb / (v * v * cg) + cg * sp * tt / r));
    out.slope[8] = -(ph * v * cg - pt * v / r * sg * cp - pv * g * cg -
                     pg * sg * (v / r - g / v) +
                     pp * (L * sb * sg / (v * cg * cg) - v / r * sg * sp * tt));
    out.slope[9] = v / r * cg * (pt * sp - pp * cp * tt);
    return out;
  };
  // Costates at the start, of −θ(T), and T.
  const auto end = [&](const State<6>& x) {
    constexpr int kSteps = 500;
    boost::numeric::odeint::runge_kutta_fehlberg78<Y, Real> stepper;
    Y y{260000.0L, 0.0L, 25600.0L, -kDegree, 90.0L * kDegree,
        x[0],      x[1], x[2],     x[3],     x[4]};
    for (int i = 0; i < kSteps; ++i) {
      stepper.do_step(
          [&](const Y& here, Y& slope, Real) { slope = at(here).slope; }, y,
          0.0L, x[5] / kSteps);
    }
    return y;
  };
  const State<6> x = roots<6>({-0.0080327e-5L, -0.2535L, -0.741297e-4L,
                               -0.270619L, 0.967335L, 2008.588L},
                              {1e-7L, 1.0L, 1e-4L, 1.0L, 1.0L, 1e3L},
                              [&](const State<6>& unknown) {
                                const Y y = end(unknown);
                                return State<6>{y[0] / 80000.0L - 1.0L,
                                                y[2] / 2500.0L - 1.0L,
                                                y[3] + 5.0L * kDegree,
                                                y[6] + 1.0L,
                                                y[9],
                                                at(y).hamiltonian * 1e3L};
                              });
  return static_cast<double>(end(x)[1] / kDegree);
}

}  // namespace brachisto::benchmarks
