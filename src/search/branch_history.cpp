// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/branch_history.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace brachisto {

BranchHistory::BranchHistory(BranchPoint start, const Prediction& prediction)
    : prediction_(prediction) {
  points_.push_back(std::move(start));
}

void BranchHistory::add(BranchPoint point) {
  points_.push_back(std::move(point));
  if (degree() > prediction_.degree) points_.pop_front();
}

double BranchHistory::distance(double fraction) const {
  const double knee = prediction_.knee;
  return knee > 0.0 ? std::log1p(fraction / knee) : fraction;
}

double BranchHistory::fraction_at(double distance) const {
  const double knee = prediction_.knee;
  return knee > 0.0 ? knee * std::expm1(distance) : distance;
}

BranchPoint BranchHistory::predict(double fraction) const {
  BranchPoint out = last();
  out.fraction = fraction;
  if (points_.size() == 1) return out;
  // The last point and what the others differ from it: Σ ℓ_i = 1.
  for (const BranchPoint& other : points_) {
    if (&other == &last()) continue;
    double weight = 1.0;  // ℓ_i of Lagrange's formula
    for (const BranchPoint& factor : points_) {
      if (&factor == &other) continue;
      const double there = distance(factor.fraction);
      weight *=
          (distance(fraction) - there) / (distance(other.fraction) - there);
    }
    const auto move = [weight](const std::vector<double>& from,
                               const std::vector<double>& to,
                               std::vector<double>& result) {
      for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] += weight * (to[i] - from[i]);
      }
    };
    move(last().point.x, other.point.x, out.point.x);
    move(last().point.lambda, other.point.lambda, out.point.lambda);
    if (prediction_.moving_mesh) {
      move(last().mesh.boundaries, other.mesh.boundaries, out.mesh.boundaries);
    }
    out.phi += weight * (other.phi - last().phi);
  }
  return out;
}

}  // namespace brachisto
