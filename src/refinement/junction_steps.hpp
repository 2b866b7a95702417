// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How far junctions and slopes are moved while the arcs of a path are fitted.

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <vector>

#include "math/dense.hpp"
#include "refinement/path_system.hpp"

namespace brachisto {

/// Steps of junctions and slopes, with the optimality conditions eliminated.
/// Columns and Jacobian are kept while they foretell what a step gains.
class JunctionSteps {
 public:
  /// Where the open conditions ask to go; nothing if steps, the shorter they
  /// are, gain no more of what they should, or are not determined.
  ///
  /// \param system  linearised
  /// \param open    with the optimality conditions met, to first order
  [[nodiscard]] std::optional<Eigen::VectorXd> step(
      PathSystem& system, const Eigen::VectorXd& open) {
    constexpr double kForeseen = 0.3, kPoor = 0.8, kLeastTrust = 1e-3;
    if (last_step_.size() > 0) {
      const Eigen::VectorXd gained = jacobian_ * last_step_;
      const Eigen::VectorXd missed = open - last_open_ - gained;
      const double share = missed.norm() / gained.norm();
      if (share < kForeseen) {
        trust_ = std::min(1.0, 3.0 * trust_);
        // By Broyden's formula.
        jacobian_ += missed * last_step_.transpose() / last_step_.squaredNorm();
      } else {
        columns_.clear();
        if (share >= kPoor) trust_ *= 0.3;
        if (trust_ < kLeastTrust) return std::nullopt;
      }
    }
    if (columns_.empty()) {
      columns_ = system.to_unknowns(RatesOf::Point);
      jacobian_ = jacobian_of(columns_);
    }
    last_open_ = open;
    const Eigen::VectorXd step = -trust_ * math::solve_square(jacobian_, open);
    if (!step.allFinite()) return std::nullopt;
    return step;
  }
  [[nodiscard]] Eigen::Index size() const { return last_open_.size(); }
  /// What was done of it; nothing if no step was.
  void went(const Eigen::VectorXd& step) { last_step_ = step; }

  /// Moves variables and multipliers as such a step asks them to.
  void follow(const Eigen::VectorXd& step, PrimalDual& point) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      move_along(point, columns_[i].point, step[static_cast<Eigen::Index>(i)]);
    }
  }

 private:
  std::vector<PathRates> columns_;
  Eigen::MatrixXd jacobian_;
  Eigen::VectorXd last_step_, last_open_;
  double trust_ = 1.0;
};

}  // namespace brachisto
