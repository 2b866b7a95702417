// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The optimality conditions of a problem and its tangency condition as a square
// system of equations, residual and Jacobian.

#pragma once

#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "nlp/active_set.hpp"
#include "nlp/tangency_condition.hpp"

namespace brachisto {

/// Rows: stationarity of free variables or the value of those that are held
/// (n), then constraints that are held, or λ_i = 0 for others (m), then the
/// tangency condition. Columns: x (n), λ (m), φ.
class KktSystem {
 public:
  /// \param tangency  may be null; both must outlive this
  KktSystem(nlp::Problem& problem, nlp::TangencyCondition* tangency,
            nlp::ActiveSet active);

  [[nodiscard]] int size() const { return n_ + m_ + (tangency_ ? 1 : 0); }
  /// Variables and multipliers, without φ.
  [[nodiscard]] int num_unknowns() const { return n_ + m_; }
  [[nodiscard]] const nlp::Problem& problem() const { return problem_; }
  [[nodiscard]] const nlp::TangencyCondition* tangency() const {
    return tangency_;
  }
  [[nodiscard]] const nlp::ActiveSet& active() const { return active_; }

  /// That of the problem, φ and the tangency condition at the end.
  [[nodiscard]] nlp::EliminationOrder elimination_order() const;

  /// Moves to (x, λ, φ) and evaluates the residual. False if the problem
  /// refuses the point.
  ///
  /// \param lambda  has to stay until evaluate_jacobian() was called
  [[nodiscard]] bool evaluate(std::span<const double> x,
                              std::span<const double> lambda, double phi);
  [[nodiscard]] std::span<const double> residual() const { return residual_; }
  [[nodiscard]] double max_residual() const;

  /// Second derivatives at the same point, then available below.
  void evaluate_jacobian();
  [[nodiscard]] std::span<const double> hess_lag() const { return hess_lag_; }
  [[nodiscard]] std::span<const double> jac_g() const { return jac_g_; }
  [[nodiscard]] const nlp::TangencyCondition::Linearisation& tangency_row()
      const {
    return tangency_at_;
  }

  /// The Jacobian by coordinates, and its entries in that order.
  /// \pre evaluate_jacobian() was called
  [[nodiscard]] nlp::SparsityPattern pattern() const;
  void jacobian(std::vector<double>& values) const;

  /// Whether the value of a variable or, from num_variables() on, of a
  /// multiplier is given: its row says so, and has no other entry but by φ.
  [[nodiscard]] bool given(int unknown) const {
    return given_[static_cast<std::size_t>(unknown)] != 0;
  }

 private:
  /// Calls put(row, col, value) for every entry in a fixed order.
  template <class Put>
  void visit(Put&& put) const;

  nlp::Problem& problem_;
  nlp::TangencyCondition* tangency_;
  nlp::ActiveSet active_;
  int n_, m_;
  std::vector<char> given_;
  std::span<const double> lambda_;
  std::vector<double> jac_g_, hess_lag_, residual_;
  nlp::TangencyCondition::Linearisation tangency_at_;
};

}  // namespace brachisto
