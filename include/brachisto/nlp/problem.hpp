// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The one interface between a nonlinear program and whoever solves it.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "brachisto/nlp/chain_structure.hpp"
#include "brachisto/nlp/sparsity.hpp"

namespace brachisto::nlp {

/// In which order to eliminate the unknowns of the KKT system, so that little
/// fill arises: entries below num_variables() stand for variables (columns) or
/// their stationarity conditions (rows), those from there on for multipliers
/// (columns) or constraints (rows).
struct EliminationOrder {
  std::vector<int> columns;
  std::vector<int> rows;  ///< rows[i] is the natural pivot row of columns[i]
  int border = 0;  ///< the last so many couple with everything and come last
};

/// A nonlinear program with equality constraints,
///
///     minimise f(x)  subject to  g(x) = 0,  lower ≤ x ≤ upper,
///
/// where a variable is either free or fixed (lower = upper).
///
/// Evaluation has two steps. set_point() evaluates what all functions share and
/// answers whether they are defined there; the eval_* functions then refer to
/// that point. None of them allocates. The Lagrangian is f + λᵀg.
///
/// Public functions check their arguments and call the private virtual ones.
class Problem {
 public:
  virtual ~Problem() = default;

  [[nodiscard]] virtual int num_variables() const = 0;
  [[nodiscard]] virtual int num_constraints() const = 0;

  /// Bounds of the variables; num_variables() values each, ±infinity if free.
  [[nodiscard]] virtual std::span<const double> lower() const = 0;
  [[nodiscard]] virtual std::span<const double> upper() const = 0;

  [[nodiscard]] virtual const SparsityPattern& jac_g_pattern() const = 0;
  /// Lower triangle of the Hessian of the Lagrangian.
  [[nodiscard]] virtual const SparsityPattern& hess_lag_pattern() const = 0;

  /// For factorisations of the KKT matrix. By default variables, then
  /// multipliers, as they are numbered.
  [[nodiscard]] virtual EliminationOrder elimination_order() const;

  /// For factorisations of the KKT matrix: its structure as a chain. By default
  /// none. Fixed variables are part of it as if they were free.
  [[nodiscard]] virtual ChainStructure chain_structure() const { return {}; }

  /// Printable name of a variable or constraint, such as "theta[12]".
  [[nodiscard]] virtual std::string variable_name(int index) const = 0;
  [[nodiscard]] virtual std::string constraint_name(int index) const = 0;

  /// Moves to x (num_variables() values). False if the functions are not
  /// defined there; refusal() then says why, and the eval_* functions must not
  /// be called.
  [[nodiscard]] bool set_point(std::span<const double> x);
  /// Why the last set_point() failed.
  [[nodiscard]] virtual std::string refusal() const = 0;

  /// f at the current point.
  [[nodiscard]] double eval_f() const;
  /// ∇f; num_variables() values.
  void eval_grad_f(std::span<double> grad_f) const;
  /// g; num_constraints() values.
  void eval_g(std::span<double> g) const;
  /// Entries of ∂g/∂x in the order of jac_g_pattern().
  void eval_jac_g(std::span<double> values) const;
  /// Entries of the Hessian of objective_factor·f + λᵀg in the order of
  /// hess_lag_pattern(); λ has num_constraints() values.
  void eval_hess_lag(double objective_factor, std::span<const double> lambda,
                     std::span<double> values) const;

 protected:
  Problem() = default;
  Problem(const Problem&) = default;
  Problem(Problem&&) = default;
  Problem& operator=(const Problem&) = default;
  Problem& operator=(Problem&&) = default;

 private:
  virtual bool do_set_point(std::span<const double> x) = 0;
  /// The x of the last do_set_point(), if what that computes follows from x
  /// alone: then it is not called for the same x again. Else empty.
  [[nodiscard]] virtual std::span<const double> current_point() const {
    return {};
  }
  [[nodiscard]] virtual double do_eval_f() const = 0;
  virtual void do_eval_grad_f(std::span<double> grad_f) const = 0;
  virtual void do_eval_g(std::span<double> g) const = 0;
  virtual void do_eval_jac_g(std::span<double> values) const = 0;
  virtual void do_eval_hess_lag(double objective_factor,
                                std::span<const double> lambda,
                                std::span<double> values) const = 0;

  bool evaluable_ = false;
};

}  // namespace brachisto::nlp
