// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All equations of a path whose arcs are known.

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "refinement/arcs.hpp"
#include "refinement/time_rates.hpp"
#include "solvers/bordered_chain.hpp"
#include "solvers/kkt_system.hpp"

namespace brachisto {

/// What the optimality conditions of a path of fixed arcs depend on.
struct PathSetting {
  std::vector<PathInequality> limits;
  std::vector<Arc> arcs;
  LimitedEnds ends;
  /// Another one than the system's, with which the point's θ turns as θ_m does:
  /// only for to() and lagrangian().
  std::optional<Scene> scene = {};
};

/// A direction of variables and multipliers, and the rates of the time and of
/// the open conditions along it, what it follows included.
struct PathRates {
  std::vector<double> point;
  double time = 0.0;
  Eigen::VectorXd open;
};

/// Moves variables and multipliers so far along a direction.
void move_along(PrimalDual& point, std::span<const double> direction,
                double by);

/// The optimality conditions of a path with limits held along its arcs, for
/// variables and multipliers, and the open conditions (open_conditions()), for
/// junctions and the slopes that are sought: a chain with a dense border, which
/// is eliminated by one solution with the chain for each of its columns.
///
/// What the path touches asks for certain junctions, and where limits hold the
/// control everywhere so does the place where it ends: these equations are
/// released from the chain. They are open conditions too, and their multipliers
/// unknowns beside the junctions.
class PathSystem {
 public:
  /// \param scene  must outlive this
  PathSystem(const Scene& scene, PathSetting setting, int degree);
  PathSystem(const PathSystem&) = delete;
  PathSystem& operator=(const PathSystem&) = delete;

  [[nodiscard]] const LimitedTime& problem() const { return problem_; }
  [[nodiscard]] const PathSetting& setting() const { return setting_; }

  /// Moves to a setting with the same arcs, perhaps of other lengths. False if
  /// the point is refused.
  [[nodiscard]] bool move_to(PathSetting setting, PrimalDual point);
  [[nodiscard]] const PrimalDual& point() const { return point_; }
  [[nodiscard]] LimitedCurve curve() const { return {problem_, point_}; }
  /// The largest of the optimality conditions that are not released.
  [[nodiscard]] double residual() const;
  [[nodiscard]] const Eigen::VectorXd& open() const { return open_; }

  /// Of the optimality conditions, for all that follows. False if they are
  /// singular. If it takes that, another one is released for good, by which
  /// open() grows.
  [[nodiscard]] bool linearise();

  /// Newton's step of the optimality conditions, everything else fixed.
  [[nodiscard]] PathRates newton();
  /// To the junctions, the slopes that are sought and the multipliers of what
  /// is released, in the order of the open conditions that determine them, the
  /// optimality conditions being kept.
  [[nodiscard]] std::vector<PathRates> to_unknowns();
  /// The same to scene, bounds and ends, by central differences of residuals,
  /// which are explicit in the setting.
  /// \param width  of the step from `less` to `more`, in whatever changes
  [[nodiscard]] PathRates to(const PathSetting& less, const PathSetting& more,
                             double width);

  /// f + λᵀ(g − bounds) of the point where the setting is another: its rate is
  /// that of the time, whatever the optimality conditions leave to move.
  [[nodiscard]] double lagrangian(const PathSetting& changed) const;
  /// What the values that fixed variables have there add to it, to first order.
  [[nodiscard]] double of_fixed(const PathSetting& changed) const;

 private:
  [[nodiscard]] LimitedTime problem_of(const PathSetting& changed) const;
  /// A point, θ turned as in the scene of a setting.
  [[nodiscard]] PrimalDual turned(PrimalDual point,
                                  const PathSetting& changed) const;
  [[nodiscard]] std::vector<double> residual_of(const PathSetting& changed);
  void release(std::vector<int> rows);
  /// What is touched, and the place where the path ends.
  [[nodiscard]] std::vector<int> with_end() const;
  [[nodiscard]] Eigen::VectorXd open_at(LimitedCurve there,
                                        const PathSetting& setting) const;
  [[nodiscard]] PathRates along(std::span<const double> rhs,
                                const PathSetting& less,
                                const PathSetting& more, double width);

  const Scene& scene_;
  PathSetting setting_;
  LimitedTime problem_;
  std::vector<int> released_;  ///< constraints
  std::unique_ptr<KktSystem> system_;
  std::unique_ptr<BorderedChain> chain_;
  PrimalDual point_;
  Eigen::VectorXd open_;
};

}  // namespace brachisto
