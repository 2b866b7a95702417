// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a path of fixed arcs responds to what it depends on.

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "refinement/arcs.hpp"
#include "solvers/bordered_chain.hpp"
#include "solvers/kkt_system.hpp"

namespace brachisto {

/// What the optimality conditions of a path of fixed arcs depend on.
struct PathSetting {
  std::vector<PathInequality> limits;
  std::vector<Arc> arcs;
  LimitedEnds ends;
};

/// Rates of the time and of the open conditions, the optimality conditions
/// being kept.
struct PathRates {
  double time = 0.0;
  Eigen::VectorXd open;
};

/// The linearised optimality conditions of a solution.
class PathResponse {
 public:
  /// \param curve  of a problem whose limits are held as the setting has it
  PathResponse(const LimitedCurve& curve, PathSetting setting);

  /// False if they are singular.
  [[nodiscard]] bool regular() const { return chain_ != nullptr; }

  /// By central differences of residuals, which are explicit in the setting,
  /// and of time and open conditions along the tangent of the solutions. \param
  /// width  of the step from `less` to `more`, in whatever changes
  [[nodiscard]] PathRates to(const PathSetting& less, const PathSetting& more,
                             double width) const;

  /// f + λᵀ(g − bounds) of the solution where the setting is another: its rate
  /// is that of the time, whatever the optimality conditions leave to move.
  [[nodiscard]] double lagrangian(const PathSetting& changed) const;

  /// To the junctions and the slopes that are sought, in the order of the open
  /// conditions that determine them.
  [[nodiscard]] std::vector<PathRates> to_unknowns() const;

  [[nodiscard]] const PathSetting& setting() const { return setting_; }

 private:
  [[nodiscard]] LimitedTime problem_of(const PathSetting& changed) const;
  [[nodiscard]] std::vector<double> residual_of(LimitedTime changed) const;

  const LimitedCurve& curve_;
  PathSetting setting_;
  LimitedTime problem_;
  nlp::ActiveSet active_;
  KktSystem system_;
  std::unique_ptr<BorderedChain> chain_;
  Eigen::Index num_open_ = 0;
};

/// The open conditions of each unknown as columns.
[[nodiscard]] Eigen::MatrixXd jacobian_of(const std::vector<PathRates>& rates);

}  // namespace brachisto
