// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/friction.hpp"

#include <algorithm>
#include <utility>

namespace brachisto::proof {

// g = R_t/R_n over u by g(m) + g'(u) (u − m).
Real FrictionAlong::needed(const Step& step, const Real& u) const {
  const Node &t = equations_.tangential, &n = equations_.normal;
  const Real middle = u.middle();
  const Real normal = step.value(n, u), tangential = step.value(t, u);
  const Real slope = (step.rate(t, u) * normal - tangential * step.rate(n, u)) /
                     (normal * normal);
  const Real there = step.value(t, middle) / step.value(n, middle);
  return (there + slope * (u - middle)).abs();
}

// Where t(u), which grows, is the share of T.
Real FrictionAlong::first_time(const Step& step) const {
  constexpr int kHalvings = 200;
  Real low(0.0), high = step.length;
  for (int i = 0; i < kHalvings; ++i) {
    const Real middle = ((low + high) * Real(0x1p-1)).middle();
    const Real off = step.value(kTime, middle) - from_;
    if (off.has_zero()) break;
    (off.positive() ? high : low) = middle;
  }
  return hull(low, high);
}

void FrictionAlong::look(const Step& step) {
  constexpr int kMostPieces = 20000;
  Real begin(0.0);
  if (!inside_) {
    if (!(step.value(kTime, step.length) - from_).positive()) return;
    inside_ = true;
    begin = first_time(step);
  }
  std::vector<std::pair<Real, Real>> pieces{{begin, step.length}};
  for (int count = 0; !pieces.empty(); ++count) {
    const auto [from, to] = pieces.back();
    pieces.pop_back();
    const Real u = hull(from, to);
    const Real mu = needed(step, u);
    if (mu.finite() && mu.upper() <= least_) continue;
    if (mu.finite() &&
        mu.radius().upper() <= kTolerance * std::max(mu.near(), kTolerance)) {
      // Some of every piece belongs to the way.
      least_ = std::max(least_, mu.lower());
      narrow_.push_back({mu, step.value(kX, u)});
      continue;
    }
    const Real middle = ((from + to) * Real(0x1p-1)).middle();
    if (count > kMostPieces || !(middle - from).positive() ||
        !(to - middle).positive()) {
      enclosed_ = false;
      return;
    }
    least_ = std::max(least_, needed(step, middle).lower());
    pieces.emplace_back(middle, to);
    pieces.emplace_back(from, middle);
  }
}

Friction FrictionAlong::found() const {
  Friction out;
  out.share = share_;
  bool any = false;
  double most = least_;
  for (const Piece& piece : narrow_) {
    if (piece.mu.upper() < least_) continue;
    most = std::max(most, piece.mu.upper());
    out.place = any ? hull(out.place, piece.x) : piece.x;
    any = true;
  }
  out.mu = Real::between(least_, most);
  if (!enclosed_ || !any) arb_indeterminate(out.mu.get());
  return out;
}

}  // namespace brachisto::proof
