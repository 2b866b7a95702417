// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/branch_history.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace brachisto {

namespace {

constexpr double kShortest = 0.5;  // step, of the one before it
constexpr double kNoError = 1e-6;

}  // namespace

BranchHistory::BranchHistory(BranchPoint start, const Prediction& prediction)
    : prediction_(prediction) {
  points_.push_back(std::move(start));
}

void BranchHistory::push(BranchPoint point) {
  points_.push_front(std::move(point));
  if (available_degree() > prediction_.most_degree) points_.pop_back();
}

double BranchHistory::add(BranchPoint point, double error, double wanted,
                          double growth) {
  const double gone = distance(point.fraction) - distance(last().fraction);
  // The error is of the order that follows the prediction's.
  const int order = std::max(degree_, 1) + 1;
  push(std::move(point));
  degree_ = available_degree();
  return gone *
         std::clamp(std::pow(wanted / std::max(error, kNoError), 1.0 / order),
                    kShortest, growth);
}

double BranchHistory::add(BranchPoint point, const BranchDistance& error,
                          double wanted, double growth) {
  const double t = distance(point.fraction);
  const double gone = t - distance(last().fraction);
  const int tried = available_degree();
  std::vector<double> constants;  // C_k
  for (int k = 0; k <= tried; ++k) {
    constants.push_back(
        std::max(error(predict(point.fraction, k), point), kNoError) /
        product(t, k));
  }
  push(std::move(point));

  double longest = 0.0;
  for (int k = 0; k <= tried; ++k) {
    const auto allowed = [&](double step) {
      return constants[static_cast<std::size_t>(k)] * product(t + step, k) <=
             wanted;
    };
    double step = growth * gone;
    while (step > kShortest * gone && !allowed(step)) step *= 0.95;
    if (step < longest) continue;
    longest = step;
    degree_ = k;
  }
  // What goes further with each degree will with the next one, too.
  if (degree_ == tried) degree_ = available_degree();
  return longest;
}

double BranchHistory::distance(double fraction) const {
  const double knee = prediction_.knee;
  return knee > 0.0 ? std::log1p(fraction / knee) : fraction;
}

double BranchHistory::fraction_at(double distance) const {
  const double knee = prediction_.knee;
  return knee > 0.0 ? knee * std::expm1(distance) : distance;
}

double BranchHistory::product(double t, int degree) const {
  double out = 1.0;
  for (int i = 0; i <= degree; ++i) {
    out *= t - distance(points_[static_cast<std::size_t>(i)].fraction);
  }
  return out;
}

BranchPoint BranchHistory::predict(double fraction, int degree) const {
  BranchPoint out = last();
  out.fraction = fraction;
  const auto count = static_cast<std::size_t>(degree) + 1;
  // The last point and what the others differ from it: Σ ℓ_i = 1.
  for (std::size_t i = 1; i < count; ++i) {
    const BranchPoint& other = points_[i];
    double weight = 1.0;  // ℓ_i of Lagrange's formula
    for (std::size_t j = 0; j < count; ++j) {
      if (j == i) continue;
      const double there = distance(points_[j].fraction);
      weight *=
          (distance(fraction) - there) / (distance(other.fraction) - there);
    }
    const auto move = [weight](const std::vector<double>& from,
                               const std::vector<double>& to,
                               std::vector<double>& result) {
      for (std::size_t n = 0; n < result.size(); ++n) {
        result[n] += weight * (to[n] - from[n]);
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
