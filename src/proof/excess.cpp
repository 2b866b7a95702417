// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/excess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachisto::proof {

namespace {

constexpr int kBits = 80;  // intervals of slopes are wide
constexpr int kMostPieces = 64;
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

}  // namespace brachisto::proof
