// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/flow.hpp"

#include <arb_poly.h>

#include <algorithm>
#include <cmath>

#include "brachisto/math/clock.hpp"

namespace brachisto::proof {

namespace {

/// E |u|^{terms−drop}/ρ^terms.
Real rest(double bound, double rho, int terms, const Real& u, int drop) {
  if (bound == 0.0) return Real(0.0);
  Real size, power, scale;
  arb_get_abs_ubound_arf(arb_midref(size.get()), u.get(), working_bits);
  arb_pow_ui(power.get(), size.get(), static_cast<ulong>(terms - drop),
             working_bits);
  arb_pow_ui(scale.get(), Real(rho).get(), static_cast<ulong>(terms),
             working_bits);
  return Real(bound) * power / scale;
}

Real polynomial(arb_srcptr coefficients, int terms, const Real& u) {
  Real out;
  _arb_poly_evaluate(out.get(), coefficients, terms, u.get(), working_bits);
  return out;
}

/// Refuses to divide out what does not vanish.
void vanish(arb_srcptr coefficients, int count, double at_zero) {
  for (int k = 0; k < count; ++k) {
    Real left(k == 0 ? -at_zero : 0.0);
    arb_add(left.get(), left.get(), coefficients + k, working_bits);
    if (!left.has_zero()) {
      throw NotProven("a function does not vanish at an end of its arc");
    }
  }
}

/// With nothing divided out `at_zero` is taken off the value.
Real less(const Real& value, int drop, double at_zero) {
  return drop > 0 || at_zero == 0.0 ? value : value - Real(at_zero);
}

}  // namespace

Real Step::value(std::size_t i, const Real& u, int drop, double at_zero) const {
  vanish(series_.input(i), drop, at_zero);
  const int terms = series_.terms() + 1;
  return less(polynomial(series_.input(i) + drop, terms - drop, u)
                  .widened(rest(tails_.input(i), rho_, terms, u, drop)),
              drop, at_zero);
}

Real Step::value(const Node& node, const Real& u, int drop,
                 double at_zero) const {
  vanish(series_.of(node), drop, at_zero);
  const int terms = series_.terms();
  return less(polynomial(series_.of(node) + drop, terms - drop, u)
                  .widened(rest(tails_.of(node), rho_, terms, u, drop)),
              drop, at_zero);
}

// Σ_{k ≥ N} k |c_k| |u|^{k−1}: for |u| ≤ ρ/2 and N > 1, k (|u|/ρ)^{k−1} does
// not grow with k.
Real Step::rate(const Node& node, const Real& u) const {
  const int terms = series_.terms();
  if (!(u.abs().upper() <= rho_ * 0x1p-1)) {
    throw std::logic_error("a rate beyond half its disc");
  }
  Real value, out;
  _arb_poly_evaluate2(value.get(), out.get(), series_.of(node), terms, u.get(),
                      working_bits);
  return out.widened(Real(static_cast<double>(terms)) *
                     rest(tails_.of(node), rho_, terms, u, 1));
}

State Step::values(const Real& u, std::size_t count) const {
  State out;
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(value(i, u));
  return out;
}

Integration::Integration(const Tape& tape, const std::vector<Node>& rates,
                         const Accuracy& accuracy)
    : accuracy_(accuracy),
      series_(tape, rates, accuracy.terms),
      tails_(series_) {}

Flow::Flow(const Scene& scene, int directions, const Accuracy& accuracy)
    : equations_(scene, directions),
      plain_(scene, 0),
      integration_(equations_.tape, equations_.rates, accuracy) {}

State Flow::rates(const State& state) const {
  const State components(state.begin(), state.begin() + kComponents);
  const std::vector<Real> at = plain_.tape.values(components);
  State out;
  for (const Node& rate : plain_.rates) {
    out.push_back(at[static_cast<std::size_t>(rate.id)]);
  }
  return out;
}

int Integration::go(State& state, const Real& length, bool backward,
                    const std::function<void(const Step&)>& look) {
  const Bits bits(accuracy_.bits);
  constexpr double kGrid = 1048576.0;  // steps are multiples of its inverse
  constexpr double kGrow = 1.15, kShrink = 0.85, kFirst = 1.0;
  constexpr double kLeast = 1.0 / 64.0;  // of the largest disc
  int steps = 0;
  double done = 0.0, rho = kFirst, largest = 0.0;
  for (bool last = false; !last; ++steps) {
    for (const Real& number : state) {
      if (!number.finite()) throw TooFewBits("the state has no bound");
    }
    check_stop();
    series_.expand(state);
    tails_.take(rho);
    while (!tails_.bound(rho)) {
      rho *= kShrink;
      if (!(rho > kLeast * largest && rho * accuracy_.share * kGrid > 8.0)) {
        throw TooFewBits("the boxes grow too wide for a step");
      }
    }
    largest = std::max(largest, rho);
    Step step(series_, tails_, rho);
    step.begin = done;
    const Real left = length - Real(done);
    const double whole = std::floor(rho * accuracy_.share * kGrid) / kGrid;
    last = left.upper() <= whole;
    step.length = last ? left : Real(whole);
    if (last && left.upper() < 0.0) throw NotProven("a negative length of u");
    if (look) look(step);
    state = step.values(backward ? -step.length : step.length, state.size());
    if (accuracy_.near) {
      for (Real& number : state) number = number.middle();
    }
    done += whole;
    rho *= kGrow;
  }
  return steps;
}

}  // namespace brachisto::proof
