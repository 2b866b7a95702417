// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/along.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace brachisto::proof {

namespace {

constexpr int kBits = 80;      // intervals of slopes are wide
constexpr int kMostParts = 8;  // of a sector

}  // namespace

// kHalf sectors of this width reach a little beyond π.
ExcessAlong::Sectors ExcessAlong::over(const std::vector<Real>& y,
                                       const Sectors& asked) const {
  const double width =
      std::nextafter(std::numbers::pi / kHalf, std::numbers::pi);
  // Edges that neighbours share are the same number: i and its parts are exact.
  const auto at = [&](double from, double to) {
    std::vector<Real> there = y;
    there[kBeta] = y[kBeta] + Real::between(from * width, to * width);
    return of_slope_(there);
  };
  Sectors shown{};
  for (const int side : {1, -1}) {
    bool bends = true;  // E'' > 0 from 0 up to here
    for (int i = 0; i < kHalf; ++i) {
      const int sector = side > 0 ? kHalf + i : kHalf - 1 - i;
      const double from = side > 0 ? i : -(i + 1);
      const auto place = static_cast<std::size_t>(sector);
      const auto [value, bend] = at(from, from + 1.0);
      bends = bends && bend.positive();
      shown[place] = bends || value.positive();
      if (!asked[place] || shown[place]) continue;
      for (int parts = 2; parts <= kMostParts && !shown[place] && i > 0;
           parts *= 2) {
        const double part = 1.0 / parts;
        shown[place] = true;
        for (int j = 0; j < parts && shown[place]; ++j) {
          shown[place] =
              at(from + j * part, from + (j + 1) * part)[0].positive();
        }
      }
    }
  }
  return shown;
}

void ExcessAlong::look(const Step& step, const Real& from, const Real& to,
                       int pieces) {
  const Sectors asked = wanted_;
  const Sectors shown = over(step.values(hull(from, to), kBeta + 1), asked);
  Sectors left{};
  bool any = false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = asked[i] && !shown[i] && !missing_[i];
    any = any || left[i];
  }
  if (!any) return;
  const Real middle = ((from + to) * Real(0x1p-1)).middle();
  const double width = std::numbers::pi / kHalf;
  std::vector<Real> y = step.values(middle, kBeta + 1);
  const Real beta = y[kBeta];
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i] || theorem_.refuted) continue;
    const double off = (static_cast<double>(i) - kHalf + 0.5) * width;
    y[kBeta] = beta + Real(off);
    if (!(-of_slope_(y)[0]).positive()) continue;
    theorem_.holds = false;
    theorem_.refuted = true;
    theorem_.why_not =
        fmt::format("the slope β {:+.3f} costs less near u = {:.4f}", off,
                    step.begin + middle.near());
  }
  constexpr int kMostPieces = 64;
  if (2 * pieces > kMostPieces) {
    for (std::size_t i = 0; i < left.size(); ++i) {
      missing_[i] = missing_[i] || left[i];
    }
    if (theorem_.holds) {
      theorem_.holds = false;
      theorem_.why_not = fmt::format(
          "that all other slopes cost more is not shown near u = {:.4f}",
          step.begin + middle.near());
    }
    return;
  }
  wanted_ = left;
  look(step, from, middle, 2 * pieces);
  wanted_ = left;
  look(step, middle, to, 2 * pieces);
}

void ExcessAlong::look(const Step& step) {
  const Bits bits(kBits);
  wanted_.fill(true);
  look(step, Real(0.0), step.length, 1);
}

Excess ExcessAlong::found() const {
  Excess out{.positive = theorem_};
  // Sectors told are a little narrower than those looked at, and where some are
  // missing one less is told: a check that cuts otherwise shows these too.
  const double width = std::numbers::pi / kHalf;
  int least = kHalf, most = kHalf;
  while (least > 0 && !missing_[static_cast<std::size_t>(least - 1)]) --least;
  while (most < 2 * kHalf && !missing_[static_cast<std::size_t>(most)]) ++most;
  const int spare = out.positive.holds ? 0 : 1;
  out.least = std::min(least + spare - kHalf, 0) * width;
  out.most = std::max(most - spare - kHalf, 0) * width;
  return out;
}

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
