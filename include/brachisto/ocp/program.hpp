// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What all nonlinear programs along a mesh have in common: stencils, which
/// make sparse matrices, and the chain of elements in the KKT matrix.

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"

namespace brachisto {

/// Receives the entries of a sparse matrix from the stencil that makes them,
/// always in the same order: where they stand, or their values, so that pattern
/// and values cannot drift apart.
class Entries {
 public:
  explicit Entries(nlp::SparsityPattern& pattern) : pattern_(&pattern) {}
  explicit Entries(std::span<double> values) : next_(values.data()) {}

  void operator()(int row, int col, double value) {
    if (next_ != nullptr) {
      *next_++ = value;
    } else {
      pattern_->add(row, col);
    }
  }

  /// factor · shares[i] in a row, at columns `stride` apart.
  void row(int row, int col, int stride, std::span<const double> shares,
           double factor = 1.0) {
    if (put_values(shares, factor)) return;
    for (std::size_t i = 0; i < shares.size(); ++i, col += stride) {
      pattern_->add(row, col);
    }
  }
  /// The same of a symmetric matrix, below the diagonal, whichever of the two
  /// the row is.
  void lower(int one, int other, int stride, std::span<const double> shares,
             double factor = 1.0) {
    if (put_values(shares, factor)) return;
    for (std::size_t i = 0; i < shares.size(); ++i, other += stride) {
      pattern_->add(std::max(one, other), std::min(one, other));
    }
  }

  /// Calls put_one(i) for i from `begin` to before `end`, elements or pieces.
  /// Each but the first has the entries of the one before, every row and every
  /// column farther on by a constant of its own: of positions three are asked.
  template <class PutOne>
  void each(int begin, int end, PutOne&& put_one);

 private:
  /// False where positions are asked for.
  bool put_values(std::span<const double> shares, double factor) {
    if (next_ == nullptr) return false;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      next_[i] = factor * shares[i];
    }
    next_ += shares.size();
    return true;
  }

  double* next_ = nullptr;
  nlp::SparsityPattern* pattern_ = nullptr;
};

template <class PutOne>
void Entries::each(int begin, int end, PutOne&& put_one) {
  constexpr int kAsked = 3;
  const bool all = pattern_ == nullptr || end - begin <= kAsked;
  const int last = all ? end : begin + kAsked;
  std::size_t before_last = 0;
  for (int i = begin; i < last; ++i) {
    check_stop(i);
    if (!all) before_last = pattern_->num_entries();
    put_one(i);
  }
  if (all) return;
  pattern_->repeat(pattern_->num_entries() - before_last,
                   static_cast<std::size_t>(end - last));
}

}  // namespace brachisto

namespace brachisto::ocp {

/// A program whose derivatives come from stencils, element by element. An
/// instance says what f, g and the stencils are, and what is bounded; fixed
/// variables, patterns, the current point and refusals are here.
class Program : public nlp::Problem {
 public:
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  [[nodiscard]] int num_variables() const final {
    return static_cast<int>(x_.size());
  }
  [[nodiscard]] int num_constraints() const final { return num_constraints_; }
  /// Free, unless it has been fixed.
  [[nodiscard]] nlp::Range variable_range(int index) const override;
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const final {
    return patterns_->jac_g;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const final {
    return patterns_->hess_lag;
  }
  [[nodiscard]] std::string refusal() const final;

 protected:
  /// \param place  what a refusal names: "node"
  Program(Mesh mesh, int num_variables, int num_constraints, const char* place);

  void fix(int variable, double value);
  void release(int variable);
  void forget_point();
  /// As many elements of other lengths. The current point is forgotten.
  void change_lengths(Mesh mesh);
  /// Once all that stencils need has its size.
  void build_patterns();
  /// \param place  negative: none
  bool refuse(int place, const char* reason);
  /// The current point.
  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  [[nodiscard]] double x(int index) const {
    return x_[static_cast<std::size_t>(index)];
  }

 private:
  bool do_set_point(std::span<const double> x) final;
  [[nodiscard]] std::span<const double> current_point() const final {
    return x_;
  }
  void do_eval_jac_g(std::span<double> values) const final;
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const final;

  /// What f, g and their derivatives share at the current point; false after
  /// refuse().
  virtual bool evaluate() = 0;
  /// The stencils.
  virtual void put_jac_g(Entries& put) const = 0;
  virtual void put_hess_lag(double objective_factor,
                            std::span<const double> lambda,
                            Entries& put) const = 0;

  Mesh mesh_;
  int num_constraints_;
  struct Fixed {
    int variable;
    double value;
  };
  std::vector<Fixed> fixed_;  ///< few, in ascending order
  struct Patterns {
    nlp::SparsityPattern jac_g, hess_lag;
  };
  std::shared_ptr<const Patterns> patterns_;  ///< those of all copies
  std::vector<double> x_;
  const char* place_;
  int refused_place_ = -1;
  const char* refused_because_ = "";
};

/// A link is an element. Its separators are its end nodes, the right one with
/// the multipliers of the last point, which determine that node; the interior
/// is the rest. The global unknown is the border.
///
/// \param num_constraints  those behind the points' are left with the first
///                         node, block 0
[[nodiscard]] nlp::ChainStructure element_chain(const Layout& layout,
                                                const Mesh& mesh,
                                                int num_constraints);

/// The same where points are nodes. Control and limits of the last point of an
/// element stand with its right end: equations about the state of a separator
/// would leave the interior singular. With what rows and columns are
/// multiplied.
///
/// \param of_control  whether a limit depends on the control, by its number
[[nodiscard]] nlp::ChainStructure element_chain(
    const Layout& layout, const Mesh& mesh, int num_constraints,
    const std::vector<bool>& of_control);

/// √h of an element as a power of two: the Hessian by states and controls is of
/// the order of h, as an integral over the element, the Jacobian of order one;
/// both are with √h between them.
[[nodiscard]] double root_of_length(const Mesh& mesh, int element);

/// Problem::weight() of a variable, or behind those of a constraint, where
/// points are nodes: h b of a point's states and limits, b of its control and
/// its defects, 1 of others.
[[nodiscard]] double element_weight(const Layout& layout,
                                    const CollocationScheme& scheme,
                                    const Mesh& mesh, int index);

}  // namespace brachisto::ocp
