// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The outer problem of a design: least τ over the bodies of a space.

#pragma once

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "design/closed_times.hpp"
#include "design/design_space.hpp"

namespace brachisto {

/// All bodies around the one that a search has come to are refused.
class NoWayOn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which margins a design has to keep positive, each with all before it.
enum class Keep { None, Branch, All };

/// min τ(y) over a DesignSpace, with the margins positive that are to be kept.
/// Its functions are closed solutions; none of their unknowns is a variable
/// here, for the contacts are conditions and not choices (docs/theory.md, "The
/// quickest body"). It has no second derivatives.
///
/// Where so many bodies in a row are refused that no step is left it throws
/// NoWayOn.
///
/// Gradients belong to points that a search accepts: there the times hold on.
class DesignProblem final : public nlp::Problem {
 public:
  /// All arguments must outlive the problem.
  DesignProblem(const DesignSpace& space, ClosedTimes& times, Keep keep);

  [[nodiscard]] int num_variables() const override { return space_.size(); }
  [[nodiscard]] int num_constraints() const override {
    return static_cast<int>(row_ranges_.size());
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return {space_.lower()[at(index)], space_.upper()[at(index)]};
  }
  [[nodiscard]] nlp::Range constraint_range(int index) const override {
    return row_ranges_[at(index)];
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jacobian_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return no_hessian_;
  }
  [[nodiscard]] std::string variable_name(int index) const override;
  [[nodiscard]] std::string constraint_name(int index) const override;
  [[nodiscard]] std::string refusal() const override {
    return times_.refusal();
  }

  /// Solves with other options from now on, where it stands too.
  void use(const SolveOptions& options) {
    times_.use(options);
    y_.resize(0);
  }

  /// The points at which gradients were asked for, in their order.
  [[nodiscard]] const std::vector<DesignStep>& path() const { return path_; }
  /// The last of them whose track is a minimum between its ends, if any was,
  /// and the quickest of those.
  [[nodiscard]] const std::optional<Eigen::VectorXd>& last_on_branch() const {
    return last_on_branch_;
  }
  [[nodiscard]] const std::optional<Eigen::VectorXd>& quickest() const {
    return quickest_;
  }
  [[nodiscard]] double least_tau() const { return least_tau_; }
  /// The bounds of a solution that hold, with what τ does as they move.
  [[nodiscard]] std::vector<BoundOfDesign> bounds_that_hold(
      const PrimalDual& point) const;

 private:
  bool do_set_point(std::span<const double> x) override;
  [[nodiscard]] std::span<const double> current_point() const override {
    return {y_.data(), static_cast<std::size_t>(y_.size())};
  }
  [[nodiscard]] double do_eval_f() const override { return times_.tau(); }
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void do_eval_jac_g(std::span<double> values) const override;
  void do_eval_hess_lag(double, std::span<const double>,
                        std::span<double>) const override {}

  /// How a margin that holds is told: the bound, and d(margin)/d(bound) where
  /// that is a number of the plan.
  [[nodiscard]] DesignSpace::Stated stated_margin(std::size_t margin,
                                                  bool at_most) const;
  void note_place() const;

  const DesignSpace& space_;
  ClosedTimes& times_;
  Eigen::Index num_margins_;  ///< that are kept, the first ones
  std::vector<nlp::Range> row_ranges_;
  nlp::SparsityPattern jacobian_, no_hessian_;
  Eigen::VectorXd y_;
  int refused_in_a_row_ = 0;
  // Made when they are asked for, at most once at a point.
  mutable std::optional<Eigen::VectorXd> gradient_;
  mutable std::optional<Eigen::MatrixXd> margin_rows_;
  mutable std::vector<DesignStep> path_;
  mutable std::optional<Eigen::VectorXd> last_on_branch_, quickest_;
  mutable double least_tau_ = std::numeric_limits<double>::infinity();
};

}  // namespace brachisto
