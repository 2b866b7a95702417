// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/faster_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brachisto/math/polynomial_basis.hpp"
#include "brachisto/model/body.hpp"
#include "math/roots.hpp"

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

namespace {

/// Follows the boundary from body to body.
class Boundary {
 public:
  Boundary(const Scene& scene, bool best, const Interrupt& interrupt)
      : one_(scene), best_(best), interrupt_(interrupt) {
    Scene bead = scene;
    bead.body = Body::bead();
    bead_ = verified_tau(bead, interrupt);
  }

  /// Moves to another offset; false if even a body on the rim is faster.
  bool move_to(double eta_m) {
    one_.body.eta_m = eta_m;
    const double largest = largest_k(eta_m);
    orient(std::min(k_, largest));
    if (excess(largest) <= 0.0) return false;
    settle([&] { return k_ = equal_time_k(largest); });
    return true;
  }

  /// The body on the rim between an offset where it is slower and one where it
  /// is faster.
  void move_to_rim(double slower, double faster) {
    settle([&] {
      const double eta_m = math::find_root(
          [&](double eta) {
            one_.body.eta_m = eta;
            return excess(largest_k(eta));
          },
          slower, faster);
      one_.body.eta_m = eta_m;
      return k_ = largest_k(eta_m);
    });
  }

  [[nodiscard]] BoundaryBody body() const {
    return {one_.body.eta_m, k_, {one_.body.theta_m, theta_m_error_}};
  }

 private:
  static constexpr double kClose = 1e-9;

  void orient(double k) {
    if (!best_ || one_.body.eta_m == 0.0) return;
    one_.body.k = k;
    const Measured best =
        fastest_orientation(one_, one_.body.theta_m, interrupt_).theta_m;
    one_.body.theta_m = best.value;
    theta_m_error_ = best.error;
  }

  /// Finds the k of a body with the orientation that was best for the body
  /// before, and orients the new one, until k stays. An error of θ_m matters to
  /// the time, and so to k, only squared: it takes two or three rounds.
  template <class FindK>
  void settle(const FindK& find_k) {
    constexpr int kMostRounds = 10;
    double before = find_k();
    for (int round = 0; best_ && round < kMostRounds; ++round) {
      orient(k_);
      const double k = find_k();
      if (std::abs(k - before) < kClose) return;
      before = k;
    }
    if (!best_) return;
    throw NotVerified(fmt::format(
        "the best orientation of the body as fast as the bead was not found "
        "for η_m = {:.6g}",
        one_.body.eta_m));
  }

  /// τ² − τ_bead², nearly linear in k, for η_m = 0 exactly.
  [[nodiscard]] double excess(double k) {
    one_.body.k = k;
    const double tau = verified_tau(one_, interrupt_);
    return (tau - bead_) * (tau + bead_);
  }

  /// Secant steps in k.
  [[nodiscard]] double equal_time_k(double largest) {
    constexpr int kMostSteps = 20;
    double before = largest;
    double f_before = excess(before);
    double k = std::min(k_, 0.9 * largest);
    for (int step = 0; step < kMostSteps; ++step) {
      const double f = excess(k);
      const double next =
          std::clamp(k - f * (k - before) / (f - f_before), 0.0, largest);
      before = k;
      f_before = f;
      k = next;
      if (std::abs(k - before) < kClose) return k;
    }
    throw NotVerified(
        fmt::format("no body as fast as the bead was found for η_m = {:.6g}",
                    one_.body.eta_m));
  }

  Scene one_;
  bool best_;
  const Interrupt& interrupt_;
  double bead_ = 0.0;
  double k_ = 0.1;
  double theta_m_error_ = 0.0;
};

}  // namespace

std::vector<BoundaryBody> bead_boundary(const Scene& scene,
                                        const std::vector<double>& eta_m,
                                        bool best, const Interrupt& interrupt) {
  Boundary boundary(scene, best, interrupt);
  std::vector<BoundaryBody> bodies;
  for (const double eta : eta_m) {
    if (boundary.move_to(eta)) {
      bodies.push_back(boundary.body());
      continue;
    }
    if (!bodies.empty()) boundary.move_to_rim(bodies.back().eta_m, eta);
    bodies.push_back(boundary.body());
    return bodies;
  }
  throw NotVerified(
      "the boundary of the bodies faster than the bead does not "
      "end at the rim");
}

}  // namespace brachisto::reproduction
