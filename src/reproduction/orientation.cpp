// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/orientation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"
#include "math/roots.hpp"
#include "reproduction/cases.hpp"

namespace brachisto::reproduction {

namespace {

/// τ(θ_m) as a polynomial on an interval.
class Interpolant {
 public:
  Interpolant(Scene scene, double centre, double half_width, int points,
              const Interrupt& interrupt)
      : low_(centre - half_width),
        high_(centre + half_width),
        basis_(chebyshev(centre, half_width, points)) {
    for (const double theta_m : basis_.nodes()) {
      scene.body.theta_m = theta_m;
      values_.push_back(verified_tau(scene, interrupt));
    }
  }

  [[nodiscard]] double operator()(double theta_m) const {
    std::vector<double> weights(values_.size());
    basis_.evaluate(theta_m, weights);
    return sum(weights);
  }
  [[nodiscard]] double slope(double theta_m) const {
    std::vector<double> values(values_.size()), weights(values_.size());
    basis_.evaluate(theta_m, values, weights);
    return sum(weights);
  }
  [[nodiscard]] bool falls_below() const { return slope(low_) > 0.0; }
  [[nodiscard]] bool falls_above() const { return slope(high_) < 0.0; }
  [[nodiscard]] double minimum() const {
    return math::find_root([this](double t) { return slope(t); }, low_, high_);
  }

 private:
  static std::vector<double> chebyshev(double centre, double half_width,
                                       int points) {
    std::vector<double> nodes;
    for (int i = points - 1; i >= 0; --i) {
      nodes.push_back(centre +
                      half_width *
                          std::cos((i + 0.5) * std::numbers::pi / points));
    }
    return nodes;
  }
  [[nodiscard]] double sum(const std::vector<double>& weights) const {
    double total = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      total += weights[i] * values_[i];
    }
    return total;
  }

  double low_, high_;
  math::LagrangeBasis basis_;
  std::vector<double> values_;
};

}  // namespace

Orientation fastest_orientation(Scene scene, double guess,
                                const Interrupt& interrupt) {
  constexpr double kHalfWidth = 0.3;
  constexpr int kPoints = 9;
  constexpr int kMostMoves = 6;
  double centre = guess;
  for (int move = 0; move < kMostMoves; ++move) {
    const Interpolant wide(scene, centre, kHalfWidth, kPoints, interrupt);
    if (wide.falls_below() == wide.falls_above()) {
      if (wide.falls_below()) break;  // a maximum
      const double first = wide.minimum();
      const Interpolant narrow(scene, first, 0.5 * kHalfWidth, kPoints,
                               interrupt);
      const double second = narrow.minimum();
      return {{second, std::abs(second - first)}, narrow(second)};
    }
    centre += wide.falls_above() ? kHalfWidth : -kHalfWidth;
  }
  throw NotVerified(fmt::format(
      "no θ_m of smallest τ near {:.6g} rad for η_m = {:.6g}, k = {:.6g}",
      guess, scene.body.eta_m, scene.body.k));
}

}  // namespace brachisto::reproduction
