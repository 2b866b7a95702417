// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/flow.hpp"

#include <arb_poly.h>

#include <algorithm>
#include <cmath>

namespace brachisto::proof {

namespace {

constexpr int kBoxBits = 64;  // of a-priori boxes, which are wide

/// Σ_{k ≥ first} (B ρ/k)(u/ρ)^k / u^drop ≤
/// (B ρ/first) ρ^{−drop} (u/ρ)^{first−drop}/(1 − u/ρ).
Real tail(double bound, double rho, int first, const Real& u, int drop) {
  if (bound == 0.0) return Real(0.0);
  Real ratio;
  arb_get_abs_ubound_arf(arb_midref(ratio.get()), u.get(), working_bits);
  ratio = ratio / Real(rho);
  const Real left = Real(1.0) - ratio;
  if (!left.positive()) throw std::logic_error("a step beyond its disc");
  Real power, scale;
  arb_pow_ui(power.get(), ratio.get(), static_cast<ulong>(first - drop),
             working_bits);
  arb_pow_ui(scale.get(), Real(rho).get(), static_cast<ulong>(drop),
             working_bits);
  return Real(bound) * Real(rho) / Real(static_cast<double>(first)) * power /
         (left * scale);
}

Real polynomial(arb_srcptr coefficients, int terms, const Real& u) {
  Real out;
  _arb_poly_evaluate(out.get(), coefficients, terms, u.get(), working_bits);
  return out;
}

}  // namespace

Real Step::value(std::size_t i, const Real& u, int drop) const {
  const int terms = series_.terms() + 1;
  Real rest;
  if (i < kComponents) {
    rest = tail(bounds_[i], rho_, terms, u, drop);
  } else {
    const std::size_t direction = i / kComponents - 1;
    Real size;
    for (std::size_t j = 0; j < kComponents; ++j) {
      if (shifts_[j] == 0.0) continue;
      Real at;
      arb_set(at.get(), series_.input(Equations::place(j, direction)));
      size += at.abs() / Real(shifts_[j]);
    }
    rest = tail(bounds_[i % kComponents], rho_, terms, u, drop) * size;
  }
  return polynomial(series_.input(i) + drop, terms - drop, u).widened(rest);
}

State Step::values(const Real& u, bool derivatives) const {
  State out;
  const std::size_t count = derivatives ? size_ : kComponents;
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(value(i, u));
  return out;
}

// |c_k| ≤ M/ρ^k = (M k/ρ) ρ^{1−k}/k; summed without the 1/k of tail().
Real Step::slope(const Node& node, double bound, const Real& u) const {
  const int terms = series_.terms();
  const Real rest = tail(bound, rho_, terms, u, 1) *
                    Real(static_cast<double>(terms)) / Real(rho_);
  return polynomial(series_.of(node) + 1, terms - 1, u).widened(rest);
}

Flow::Flow(const Scene& scene, int directions, const Accuracy& accuracy)
    : accuracy_(accuracy),
      equations_(scene, directions),
      plain_(scene, 0),
      series_(equations_.tape, equations_.rates, accuracy.terms) {}

State Flow::rates(const State& state) const {
  const State components(state.begin(), state.begin() + kComponents);
  const std::vector<Real> at = plain_.tape.values<Real>(components);
  State out;
  for (const Node& rate : plain_.rates) {
    out.push_back(at[static_cast<std::size_t>(rate.id)]);
  }
  return out;
}

// Let P be the Taylor polynomial of degree N of a solution, and y = P + e the
// solution from a complex start that is off by no more than σ. In the tube
// |e_i| ≤ E_i over the disc |u| ≤ ρ', covered by small squares, f is analytic;
// let G_i there bound what f_i(P + e) and f_i(P) differ by, and D_i the defect
// d = f(P) − P'. Schwarz's lemma, once along e and once from the centre, where
// d vanishes like u^N, gives for t = max |e_i|/E_i along every ray
//
//     t' ≤ λ t + δ,  λ = max G_i/E_i,  δ = max D_i/E_i (ρ/ρ')^N  on |u| ≤ ρ,
//
// and so t < 1 all over that disc if (t(0) + δ/λ) e^{λρ} < 1.
bool Flow::encloses(const State& rates, double wide, Disc& disc) const {
  constexpr int kSquares = 4;         // across a radius
  constexpr double kTube = 1.0;       // E over the way along a square
  constexpr double kLeastRate = 1.0;  // of components that hardly move
  constexpr double kFill = 0x1p-24;   // t(0)
  constexpr double kGrowth = 14.0;    // λ ρ; e^14 is 2^20
  constexpr double kShare = 0.8;      // ρ/ρ' at most
  const Bits bits(kBoxBits);
  const double side = wide / kSquares;
  std::vector<double> tube(kComponents, 0.0), defect(kComponents, 0.0);
  disc = {0.0, wide, std::vector<double>(kComponents, 0.0),
          std::vector<double>(kComponents, 0.0), 0.0};
  const auto feeds = [](std::size_t i) {
    return i != kX && i != kZ && i != kTime && i != kLength;
  };
  for (std::size_t i = 0; i < kComponents; ++i) {
    if (!feeds(i)) continue;
    tube[i] = kTube * side * std::max(rates[i].abs().upper(), kLeastRate);
    disc.shifts[i] = kFill * tube[i];
  }
  double lambda = 1e-3;
  std::vector<double> growth(kComponents, 0.0);
  std::vector<Complex> box(kComponents);
  for (int row = 0; row < kSquares; ++row) {  // below it is the same
    for (int column = -kSquares; column < kSquares; ++column) {
      const int nearest = column < 0 ? -column - 1 : column;
      if (row * row + nearest * nearest >= kSquares * kSquares) continue;
      const Complex u =
          Complex::rectangle(Real::between(column * side, (column + 1) * side),
                             Real::between(row * side, (row + 1) * side));
      for (std::size_t i = 0; i < kComponents; ++i) {
        box[i] = feeds(i)
                     ? Complex::value(series_.input(i), series_.terms() + 1, u)
                           .widened(tube[i])
                     : Complex(0.0);
      }
      const std::vector<Complex> at = plain_.tape.values(box);
      for (std::size_t i = 0; i < kComponents; ++i) {
        const Complex& f = at[static_cast<std::size_t>(plain_.rates[i].id)];
        if (!f.finite()) return false;
        disc.bounds[i] = std::max(disc.bounds[i], f.modulus());
        if (!feeds(i)) continue;
        const Complex slope =
            Complex::value(series_.of(equations_.rates[i]), series_.terms(), u);
        defect[i] = std::max(defect[i], (f - slope).modulus());
        growth[i] =
            std::max(growth[i], Real::quotient((f - f).modulus(), tube[i]));
      }
      const Complex& normal = at[static_cast<std::size_t>(plain_.normal.id)];
      if (!normal.finite()) return false;
      disc.normal = std::max(disc.normal, normal.modulus());
    }
  }
  for (double each : growth) lambda = std::max(lambda, each);
  disc.rho = std::min(kShare * wide, kGrowth / lambda);
  const Real rho(disc.rho);
  double delta = 0.0;
  for (std::size_t i = 0; i < kComponents; ++i) {
    if (!feeds(i)) continue;
    delta = std::max(delta, Real::quotient(defect[i], tube[i]));
  }
  Real power, grown;
  arb_pow_ui(power.get(), (rho / Real(wide)).get(),
             static_cast<ulong>(series_.terms()), working_bits);
  arb_exp(grown.get(), (Real(lambda) * rho).get(), working_bits);
  const Real end = (Real(kFill) + Real(delta) * power / Real(lambda)) * grown;
  return end.finite() && end.upper() < 1.0;
}

int Flow::go(State& state, const Real& length, bool backward,
             const std::function<void(const Step&)>& look) {
  const Bits bits(accuracy_.bits);
  constexpr double kGrid = 1048576.0;  // steps are multiples of its inverse
  constexpr double kGrow = 1.1, kShrink = 0.85, kFirst = 0.2;
  constexpr double kGood = 0.6;  // of ρ/ρ'
  int steps = 0;
  double done = 0.0, wide = kFirst;
  for (bool last = false; !last; ++steps) {
    Disc disc;
    const State here = rates(state);
    for (const Real& rate : here) {
      if (!rate.finite()) throw NotProven("the rates have no bound");
    }
    series_.expand(state);
    while (!encloses(here, wide, disc)) {
      wide *= kShrink;
      if (!(wide * accuracy_.share * kGrid > 8.0)) {
        throw NotProven("the boxes grow too wide for a step: more bits");
      }
    }
    const double rho = disc.rho;
    wide = rho > kGood * wide ? wide * kGrow : wide * kShrink;
    Step step(series_, equations_.size(), rho, disc.bounds, disc.shifts);
    step.begin = done;
    step.normal_bound = disc.normal;
    const Real rest = length - Real(done);
    const double whole = std::floor(rho * accuracy_.share * kGrid) / kGrid;
    last = rest.upper() <= whole;
    step.length = last ? rest : Real(whole);
    if (last && rest.upper() < 0.0) throw NotProven("a negative length of u");
    if (look) look(step);
    state = step.values(backward ? -step.length : step.length, true);
    done += whole;
  }
  return steps;
}

}  // namespace brachisto::proof
