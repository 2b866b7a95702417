// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A nonlinear program whose inequalities give way at a price.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::nlp {

/// Adds one variable t ≥ 0, the last one, to a program:
///
///     minimise f(x) + π t  subject to  g_l − d t ≤ g(x) ≤ g_u + d t,
///
/// d ≥ 0 for each constraint. It is an exact penalty: a local minimum of the
/// program with multipliers Σ d |λ| < π is one of this with t = 0. At a minimum
/// with t > 0 the bounds cannot all be kept nearby, unless at such a price.
///
/// A constraint with two bounds becomes two rows, the lower bound with the row
/// of the program, the upper one with a row behind those.
class Elastic final : public Problem {
 public:
  /// \param problem  must outlive this
  /// \param give     d of each constraint, 0 for equations
  Elastic(Problem& problem, std::vector<double> give, double price);

  /// x without t, the multipliers of the program's constraints; those of bounds
  /// as they are.
  [[nodiscard]] PrimalDual without_elasticity(PrimalDual point) const;
  /// The program's point with t and its multiplier π.
  [[nodiscard]] PrimalDual with_elasticity(PrimalDual point, double t) const;

  [[nodiscard]] int num_variables() const override { return inner_n_ + 1; }
  [[nodiscard]] int num_constraints() const override {
    return inner_m_ + static_cast<int>(twins_.size());
  }
  [[nodiscard]] Range variable_range(int index) const override;
  [[nodiscard]] Range constraint_range(int index) const override {
    return ranges_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] double weight(int index) const override;
  [[nodiscard]] const SparsityPattern& jac_g_pattern() const override {
    return jac_;
  }
  [[nodiscard]] const SparsityPattern& hess_lag_pattern() const override {
    return problem_.hess_lag_pattern();
  }
  /// t belongs to the border, rows that were added to their twins' blocks.
  [[nodiscard]] ChainStructure chain_structure() const override;
  [[nodiscard]] std::string variable_name(int index) const override;
  [[nodiscard]] std::string constraint_name(int index) const override;
  [[nodiscard]] std::string refusal() const override {
    return problem_.refusal();
  }

 private:
  [[nodiscard]] bool do_set_point(std::span<const double> x) override;
  [[nodiscard]] double do_eval_f() const override;
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void do_eval_jac_g(std::span<double> values) const override;
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override;
  /// The row of the program that a row comes from.
  [[nodiscard]] int row_of(int row) const {
    return row < inner_m_ ? row
                          : twins_[static_cast<std::size_t>(row - inner_m_)];
  }

  Problem& problem_;
  double price_;
  int inner_n_, inner_m_;
  std::vector<int> twins_;         ///< rows with two bounds
  std::vector<int> twin_entries_;  ///< of the Jacobian, of these rows
  std::vector<double> give_;       ///< by row: g + give t keeps its bounds
  std::vector<Range> ranges_;      ///< by row
  SparsityPattern jac_;
  mutable std::vector<double> joined_;  ///< multipliers by row of the program
  double t_ = 0.0;
};

}  // namespace brachisto::nlp
