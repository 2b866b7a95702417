// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/tails.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brachisto::proof {

namespace {

using Op = Tape::Op;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kHalf = 0.5;

// Sums and products of some thousand numbers ≥ 0 of 64 bits are off by less
// than a share of 2^−40, and by less than 1e−200 where they underflow, be it to
// nothing.
double outward(double number) {
  return number * (1.0 + 0x1p-40) + 1e-200;
}

/// |c| 2^power, upward.
double modulus(arb_srcptr c, slong power) {
  mag_t bound;
  mag_init(bound);
  arb_get_mag(bound, c);
  mag_mul_2exp_si(bound, bound, power);
  const double out = mag_get_d(bound);  // upward
  mag_clear(bound);
  return out;
}

}  // namespace

Tails::Tails(const TaylorSeries& series)
    : series_(series),
      terms_(static_cast<std::size_t>(series.terms())),
      stride_(terms_ + 1),
      nodes_(series.tape().entries().size()),
      scaled_(nodes_ * stride_),
      last_(series.rates().size()),
      terms_at_(nodes_ * stride_),
      sums_(nodes_ * stride_),
      last_at_(series.rates().size()),
      inputs_(series.rates().size()),
      tails_(nodes_) {}

void Tails::take(double rho) {
  int power = 0;
  (void)std::frexp(rho, &power);
  taken_ = std::ldexp(1.0, power);
  for (std::size_t node = 0; node < nodes_; ++node) {
    double* out = scaled_.data() + node * stride_;
    const arb_srcptr of = series_.of(series_.tape().node(node));
    const std::size_t count = series_.fixed(node) ? 1 : terms_;
    std::fill(out, out + stride_, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      out[k] = modulus(of + k, static_cast<slong>(k) * power);
    }
  }
  for (std::size_t i = 0; i < last_.size(); ++i) {
    last_[i] =
        modulus(series_.input(i) + terms_, static_cast<slong>(terms_) * power);
  }
}

bool Tails::bound(double rho) {
  constexpr int kTries = 16;
  constexpr double kSpare = 1.25;
  std::vector<double> powers(stride_, 1.0);
  for (std::size_t k = 1; k < stride_; ++k) {
    powers[k] = powers[k - 1] * (rho / taken_);
  }
  for (std::size_t node = 0; node < nodes_; ++node) {
    double sum = 0.0;
    for (std::size_t k = terms_; k-- > 0;) {
      const std::size_t at = node * stride_ + k;
      terms_at_[at] = scaled_[at] * powers[k];
      sums_[at] = sum += terms_at_[at];
    }
    if (!(sum < kNone)) return false;
  }
  for (std::size_t i = 0; i < last_.size(); ++i) {
    last_at_[i] = outward(last_[i] * powers[terms_]);
  }
  std::fill(inputs_.begin(), inputs_.end(), 0.0);
  for (int i = 0; i < kTries; ++i) {
    if (!pass()) return false;
    bool holds = true;
    std::vector<double> next(inputs_.size());
    for (std::size_t j = 0; j < next.size(); ++j) {
      next[j] = outward(of(series_.rates()[j]) * rho /
                        static_cast<double>(terms_ + 1));
      if (!(next[j] < kNone)) return false;
      holds = holds && next[j] <= inputs_[j];
    }
    if (holds) return true;
    for (std::size_t j = 0; j < next.size(); ++j) {
      if (next[j] > inputs_[j]) inputs_[j] = kSpare * next[j];
    }
  }
  return false;
}

bool Tails::pass() {
  for (std::size_t node = 0; node < nodes_; ++node) {
    tails_[node] = series_.fixed(node) ? 0.0 : outward(tail(node));
    if (!(tails_[node] < kNone)) return false;
  }
  return true;
}

/// Σ_{i+j ≥ N} |a_i| |b_j| ρ^{i+j} over the known terms.
double Tails::spill(std::size_t a, std::size_t b) const {
  if (series_.fixed(a) || series_.fixed(b)) return 0.0;
  const double* terms = terms_at_.data() + a * stride_;
  const double* sums = sums_.data() + b * stride_;
  double out = 0.0;
  for (std::size_t i = 1; i < terms_; ++i) out += terms[i] * sums[terms_ - i];
  return out;
}

// Each from the equation that the node obeys, of which its known terms h leave
// terms from u^N on.
double Tails::tail(std::size_t node) const {
  const Tape::Entry& e = series_.tape().entries()[node];
  const auto a = static_cast<std::size_t>(e.a);
  const auto b = static_cast<std::size_t>(e.b);
  switch (e.op) {
    case Op::Constant:
      return 0.0;
    case Op::Input:
      return inputs_[a] + last_at_[a];
    case Op::Negate:
      return tails_[a];
    case Op::Add:
    case Op::Subtract:
      return tails_[a] + tails_[b];
    case Op::Multiply:
      return spill(a, b) + norm(a) * tails_[b] +
             tails_[a] * (norm(b) + tails_[b]);
    case Op::Reciprocal: {
      // h a = 1 + d: 1/a − h = −h d/(1 + d)
      const double d = outward(spill(node, a) + norm(node) * tails_[a]);
      return d <= kHalf ? norm(node) * d / (1.0 - d) : kNone;
    }
    case Op::Sqrt: {
      // (h + t)² = a: t = (a − h² − t²)/(2 h), and ‖t‖ is at most the smaller
      // root of t = G (d + t²)
      const auto inverse = series_.tape().find(Op::Reciprocal, node);
      const double off = outward(spill(inverse, node));
      if (!(off <= kHalf)) return kNone;
      const double G = outward(norm(inverse) / (1.0 - off) * kHalf);
      const double d = outward(spill(node, node) + tails_[a]);
      // With G² d ≤ 3/16 that root is at most 4/3 of G d.
      return 16.0 * G * G * d <= 3.0 ? 4.0 / 3.0 * G * d : kNone;
    }
    case Op::Sin:
      return sine(a, node, series_.partner(node));
    case Op::Cos:
      return sine(a, series_.partner(node), node);
  }
  return kNone;
}

// For the known terms h of the argument s = sin h and c = cos h obey s' = h' c
// and c' = −h' s: with D = Σ k |h_k| ρ^k both leave at most t,
//
//     N t ≤ Σ_{j+k ≥ N} j |h_j| ρ^j max(|s_k|, |c_k|) ρ^k + D t.
//
// Then sin(h + α) − s = s (cos α − 1) + c sin α, and of the cosine likewise;
// cosh ‖α‖ − 1 and sinh ‖α‖ are less than 5/4 ‖α‖ together for ‖α‖ ≤ 1/5.
double Tails::sine(std::size_t argument, std::size_t sine,
                   std::size_t cosine) const {
  const double* h = terms_at_.data() + argument * stride_;
  const double* s = sums_.data() + sine * stride_;
  const double* c = sums_.data() + cosine * stride_;
  double D = 0.0, spilt = 0.0;
  for (std::size_t j = 1; j < terms_; ++j) {
    const double weighted = static_cast<double>(j) * h[j];
    D += weighted;
    spilt += weighted * std::max(s[terms_ - j], c[terms_ - j]);
  }
  const double share = outward(D / static_cast<double>(terms_));
  if (!(share <= kHalf)) return kNone;
  const double t = outward(spilt / static_cast<double>(terms_) / (1.0 - share));
  const double alpha = tails_[argument];
  if (!(alpha <= 0.2)) return kNone;
  return t + (std::max(s[0], c[0]) + t) * 1.25 * alpha;
}

}  // namespace brachisto::proof
