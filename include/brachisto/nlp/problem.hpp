// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The one interface between a nonlinear program and whoever solves it, and how
/// far a point is from its first-order conditions.

#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace brachisto::nlp {

/// Positions of the entries of a sparse matrix, 0-based, fixed for life. The
/// value arrays of a matrix follow the same order. A position may occur more
/// than once; its values then add up, as Ipopt and MUMPS have it.
///
/// Positions are stored one by one as they are added; what a mesh repeats from
/// element to element need not be, see repeat().
class SparsityPattern {
 public:
  struct Position {
    int row = 0, col = 0;
    friend bool operator==(const Position&, const Position&) = default;
  };
  /// Entries from `begin` to before end(): `length` of them, then the same
  /// with every row and column farther on by a constant of its own, and so on.
  struct Repetition {
    std::size_t begin = 0;   ///< the first entry
    std::size_t length = 0;  ///< how many there are each time
    std::size_t times = 0;   ///< all times, the first one too
    std::size_t stored = 0;  ///< place of the first one in memory
    [[nodiscard]] std::size_t end() const { return begin + length * times; }
    friend bool operator==(const Repetition&, const Repetition&) = default;
  };

  SparsityPattern() = default;
  SparsityPattern(std::initializer_list<Position> entries) : stored_(entries) {}

  void add(int row, int col) { stored_.push_back({row, col}); }
  /// Room for so many entries that are added one by one.
  void reserve(std::size_t entries) { stored_.reserve(entries); }
  /// The last `length` entries, each as far from the one `length` before it as
  /// its row and its column say, go on like that `times` more often. Memory and
  /// time are those of `length` entries.
  ///
  /// \throws std::invalid_argument  unless the last 2 `length` entries were
  ///                                added one by one
  void repeat(std::size_t length, std::size_t times);

  [[nodiscard]] std::size_t num_entries() const {
    return stored_.size() + not_stored_;
  }
  /// Position of one entry. Quick, but for_each() is quicker.
  [[nodiscard]] Position operator[](std::size_t entry) const;
  /// The repetition in which an entry is; null if it is in none.
  [[nodiscard]] const Repetition* repetition_of(std::size_t entry) const;

  /// Calls visit(entry, row, col) for all entries in their order.
  template <class Visit>
  void for_each(Visit&& visit) const;

  /// Stored alike.
  friend bool operator==(const SparsityPattern&,
                         const SparsityPattern&) = default;

 private:
  /// The last repetition that begins at or before an entry.
  [[nodiscard]] const Repetition* last_begun(std::size_t entry) const;

  /// Entries in their order; of a repetition those of the first time, then by
  /// how much each advances.
  std::vector<Position> stored_;
  std::vector<Repetition> repetitions_;
  std::size_t not_stored_ = 0;
};

template <class Visit>
void SparsityPattern::for_each(Visit&& visit) const {
  std::size_t entry = 0;
  const Position* next = stored_.data();
  const auto visit_until = [&](std::size_t end) {
    for (; entry < end; ++entry, ++next) visit(entry, next->row, next->col);
  };
  for (const Repetition& repetition : repetitions_) {
    visit_until(repetition.begin);
    const Position* const stride = next + repetition.length;
    std::vector<Position> now(next, stride);
    for (std::size_t i = 0; i < repetition.times; ++i) {
      for (std::size_t k = 0; k < now.size(); ++k, ++entry) {
        visit(entry, now[k].row, now[k].col);
      }
      for (std::size_t k = 0; k < now.size(); ++k) {
        now[k].row += stride[k].row;
        now[k].col += stride[k].col;
      }
    }
    next += 2 * repetition.length;
  }
  visit_until(num_entries());
}

}  // namespace brachisto::nlp

namespace brachisto {

/// Values of the unknowns and multipliers. The signs are Ipopt's: with the
/// Lagrangian
///
///     f + λᵀg − z_lᵀ(x − x_l) − z_uᵀ(x_u − x)
///
/// z_l, z_u ≥ 0 at a minimum, λ_i ≥ 0 where g_i is at its upper bound, λ_i ≤ 0
/// where it is at its lower one, and λ_i = 0 between. Derivatives of the least
/// f are z_l by x_l, −z_u by x_u, and −λ by a bound of g that holds.
struct PrimalDual {
  std::vector<double> x;       ///< num_variables() values
  std::vector<double> lambda;  ///< num_constraints() values; empty: unknown
  /// num_variables() values each; zero for fixed variables. Empty: zero, as for
  /// problems without inequalities, or unknown.
  std::vector<double> z_lower = {}, z_upper = {};
};

}  // namespace brachisto

namespace brachisto::nlp {

/// A symmetric matrix as a chain: links 0 … num_links − 1 in order, each with
/// unknowns of its own (its interior), neighbouring links joined by the
/// unknowns of a separator, and a border of few unknowns that couple with
/// everything:
///
///     separator 0 | interior 0 | separator 1 | interior 1 | … | separator N
///
/// Two unknowns may have a nonzero entry only if they belong to one link (its
/// interior and its two separators) or one of them to the border.
///
/// The unknowns of a KKT matrix are the variables, then the multipliers. Choose
/// as interior what is determined once the separators are known, states
/// together with the multipliers of the constraints that determine them: then
/// the block of the interior is regular, and all pivots can be found in it. The
/// multiplier of an inequality belongs into the interior of a link that has its
/// variables; the solver puts its slack beside it.
struct ChainStructure {
  static constexpr int kBorder = -1;  ///< the unknown couples with all links
  static constexpr int kAbsent = -2;  ///< the unknown is not in the matrix

  int num_links = 0;
  /// Of every unknown: 2 e for separator e ≤ num_links, 2 e + 1 for the
  /// interior of link e, or one of the constants above.
  std::vector<int> block;
  /// By what to multiply rows and columns of the unknowns so that no entry is
  /// much larger than others: powers of two, which change no digit, 1 for
  /// absent ones. Empty: ones.
  std::vector<double> scale = {};

  /// True where a problem states no such structure.
  [[nodiscard]] bool empty() const { return num_links == 0; }
};

/// In which order to eliminate the unknowns of the KKT system, so that little
/// fill arises: entries below num_variables() stand for variables (columns) or
/// their stationarity conditions (rows), those from there on for multipliers
/// (columns) or constraints (rows).
struct EliminationOrder {
  std::vector<int> columns;
  std::vector<int> rows;  ///< rows[i] is the natural pivot row of columns[i]
  int border = 0;  ///< the last so many couple with everything and come last
};

/// What a variable or a constraint may be: ±infinity where there is no bound.
struct Range {
  double lower = 0.0, upper = 0.0;
  /// A fixed variable or an equation.
  [[nodiscard]] bool single() const { return lower == upper; }
  [[nodiscard]] bool bounded() const {
    return std::isfinite(lower) || std::isfinite(upper);
  }
};

/// A nonlinear program,
///
///     minimise f(x)  subject to  g_l ≤ g(x) ≤ g_u,  x_l ≤ x ≤ x_u,
///
/// where bounds may be infinite, a variable with x_l = x_u is fixed and a
/// constraint with g_l = g_u an equation. Unless a problem says otherwise its
/// constraints are the equations g(x) = 0.
///
/// Evaluation has two steps. set_point() evaluates what all functions share and
/// answers whether they are defined there; the eval_* functions then refer to
/// that point. None of them allocates. The Lagrangian is f + λᵀg, with bounds
/// of variables as PrimalDual has it.
///
/// Public functions check their arguments and call the private virtual ones.
class Problem {
 public:
  virtual ~Problem() = default;

  [[nodiscard]] virtual int num_variables() const = 0;
  [[nodiscard]] virtual int num_constraints() const = 0;

  /// Asked again and again, not kept by those who ask.
  [[nodiscard]] virtual Range variable_range(int index) const = 0;
  /// By default an equation.
  [[nodiscard]] virtual Range constraint_range(int /*index*/) const {
    return {};
  }
  /// Whether a variable that is not fixed, or a constraint that is no equation,
  /// has a bound.
  [[nodiscard]] bool has_inequalities() const;

  /// How much of the path a variable stands for, or behind those a constraint,
  /// such as its weight in a quadrature: multipliers and stationarity divided
  /// by it are functions of the path, the same on every mesh. Positive.
  [[nodiscard]] virtual double weight(int /*index*/) const { return 1.0; }

  [[nodiscard]] virtual const SparsityPattern& jac_g_pattern() const = 0;
  /// Lower triangle of the Hessian of the Lagrangian. Empty if there is none,
  /// or nobody knows it: then Ipopt builds one up from gradients.
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
  /// A copy has no current point.
  Problem(const Problem& /*other*/) {}
  Problem(Problem&&) = default;
  Problem& operator=(const Problem& /*other*/) {
    evaluable_ = false;
    return *this;
  }
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

/// Residual of the Karush–Kuhn–Tucker conditions. Stationarity and multipliers
/// are divided by Problem::weight(), so that one tolerance means the same on
/// every mesh; distances from bounds are in the units of the problem.
struct KktResidual {
  /// max |∂(f + λᵀg)/∂x_i − z_l,i + z_u,i| over variables that are not fixed
  double stationarity = 0.0;
  double infeasibility = 0.0;    ///< max distance of g_i from its range
  double bound_violation = 0.0;  ///< max distance of a variable from its range
  /// max |multiplier · distance from the bound it belongs to|
  double complementarity = 0.0;
  /// How far a multiplier is on the wrong side of zero, or from zero where
  /// there is no bound it could belong to.
  double sign = 0.0;
  std::string worst_variable;    ///< where the stationarity is worst
  std::string worst_constraint;  ///< where the infeasibility is worst
  std::string worst_multiplier;  ///< where the complementarity is worst
  /// Sum of multiplier · distance over all bounds, not weighted: to first order
  /// what the objective has yet to lose next to the path of an interior-point
  /// method; and its mean, which is the barrier parameter there.
  double gap = 0.0;
  double barrier_parameter = 0.0;

  [[nodiscard]] double max() const;
};

/// Residual at a point. The problem is moved to it.
///
/// \param weight  in place of the problem's; a function, not an empty one
/// \throws std::domain_error if the problem is not evaluable there
[[nodiscard]] KktResidual kkt_residual(
    Problem& problem, const PrimalDual& point,
    const std::function<double(int)>& weight);
[[nodiscard]] KktResidual kkt_residual(Problem& problem,
                                       const PrimalDual& point);

/// ∂(f + λᵀg)/∂x at the point the problem was moved to, summed in long double.
[[nodiscard]] std::vector<long double> lagrangian_gradient(
    const Problem& problem, const std::vector<double>& lambda);

}  // namespace brachisto::nlp
