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
  /// only for to() and of_fixed().
  std::optional<Scene> scene = {};
};

/// A direction of variables and multipliers, or the rate of the time along it,
/// and the rates of the open conditions, what it follows included.
struct PathRates {
  std::vector<double> point;
  Eigen::VectorXd open;
  double time = 0.0;
};
/// Which of the two.
enum class RatesOf { Point, Time };

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

  [[nodiscard]] const LimitedTime& problem() const { return *problem_; }
  [[nodiscard]] const PathSetting& setting() const { return setting_; }

  /// Moves to a setting with the same arcs, perhaps of other lengths. False if
  /// the point is refused.
  [[nodiscard]] bool move_to(PathSetting setting, PrimalDual point);
  [[nodiscard]] const PrimalDual& point() const { return point_; }
  [[nodiscard]] LimitedCurve curve() const { return {*problem_, point_}; }
  /// The same, after which this has none: matrix and factors are freed first.
  [[nodiscard]] LimitedCurve take_curve() &&;
  /// The largest of the optimality conditions that are not released.
  [[nodiscard]] double residual() const;
  /// What a unit of rounding in the variables makes of an equation, the most
  /// of all of them: Σ|∂g/∂x_i x_i| ε.
  [[nodiscard]] double rounding() const;
  /// What T feels of what is left of the equations, to the first order.
  [[nodiscard]] double cost_of_residuals();
  [[nodiscard]] const Eigen::VectorXd& open() const { return open_; }

  /// Of the optimality conditions, for all that follows, at points nearby too.
  /// False if they are singular. If it takes that, another one is released for
  /// good, by which open() grows.
  [[nodiscard]] bool linearise();

  /// Newton's step of the optimality conditions, everything else fixed.
  /// \param enough  what may be left of the residual by the factors of another
  ///                point, if not those of this one: relative
  [[nodiscard]] PathRates newton(double enough);
  /// To the junctions, the slopes that are sought and the multipliers of what
  /// is released, in the order of the open conditions that determine them, the
  /// optimality conditions being kept.
  [[nodiscard]] std::vector<PathRates> to_unknowns(RatesOf asked);
  /// The same to scene, bounds and ends, by central differences of residuals,
  /// which are explicit in the setting.
  /// \param width       of the step from `less` to `more`, in whatever changes
  /// \param lagrangian  [out] the rate of f + λᵀ(g − bounds), the point being
  ///                    kept: that of the time, whatever the optimality
  ///                    conditions leave to move
  [[nodiscard]] PathRates to(const PathSetting& less, const PathSetting& more,
                             double width, double& lagrangian);

  /// What the values that fixed variables have in another setting add to the
  /// Lagrangian, to first order.
  [[nodiscard]] double of_fixed(const PathSetting& changed);

 private:
  /// That of another setting. Until it is asked for the next.
  [[nodiscard]] std::shared_ptr<LimitedTime> problem_of(
      const PathSetting& changed);
  /// A point, θ turned as in the scene of a setting.
  [[nodiscard]] PrimalDual turned(PrimalDual point,
                                  const PathSetting& changed) const;
  /// The same point where the setting is another.
  struct Elsewhere {
    std::vector<double> residual;
    double lagrangian;
  };
  [[nodiscard]] Elsewhere evaluated(const PathSetting& changed);
  [[nodiscard]] bool evaluate();
  void release(std::vector<int> rows);
  /// What is touched, and the place where the path ends.
  [[nodiscard]] std::vector<int> with_end() const;
  [[nodiscard]] Eigen::VectorXd open_at(LimitedCurve there,
                                        const PathSetting& setting) const;
  [[nodiscard]] PathRates along(std::span<const double> rhs,
                                const PathSetting& less,
                                const PathSetting& more, double width,
                                RatesOf asked, double enough = 1e-6);

  const Scene& scene_;
  PathSetting setting_;
  std::shared_ptr<LimitedTime> problem_;
  std::shared_ptr<LimitedTime> moved_;  ///< of settings next to it
  std::vector<int> released_;           ///< constraints
  std::unique_ptr<KktSystem> system_;
  std::unique_ptr<BorderedChain> chain_;
  PrimalDual point_;
  Eigen::VectorXd open_;
};

}  // namespace brachisto
