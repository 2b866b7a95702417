// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What all nonlinear programs along a mesh have in common.

#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/entries.hpp"
#include "brachisto/ocp/mesh.hpp"

namespace brachisto::ocp {

/// A program whose derivatives come from stencils, element by element. An
/// instance says what f, g and the stencils are; bounds, patterns, the current
/// point and refusals are here.
class Program : public nlp::Problem {
 public:
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  [[nodiscard]] int num_variables() const final {
    return static_cast<int>(lower_.size());
  }
  [[nodiscard]] int num_constraints() const final { return num_constraints_; }
  [[nodiscard]] std::span<const double> lower() const final { return lower_; }
  [[nodiscard]] std::span<const double> upper() const final { return upper_; }
  [[nodiscard]] std::span<const double> constraint_lower() const final {
    return row_lower_;
  }
  [[nodiscard]] std::span<const double> constraint_upper() const final {
    return row_upper_;
  }
  [[nodiscard]] std::span<const double> weights() const final {
    return weights_;
  }
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
  void bound(int variable, double lower, double upper);
  void release(int variable);
  /// A constraint that is not asked to be 0.
  void bound_row(int row, double lower, double upper);
  /// Of variables, then constraints.
  void weigh(std::vector<double> weights) { weights_ = std::move(weights); }
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
  std::vector<double> lower_, upper_;
  std::vector<double> row_lower_, row_upper_;  ///< empty: all 0
  std::vector<double> weights_;                ///< empty: ones
  struct Patterns {
    nlp::SparsityPattern jac_g, hess_lag;
  };
  std::shared_ptr<const Patterns> patterns_;  ///< those of all copies
  std::vector<double> x_;
  const char* place_;
  int refused_place_ = -1;
  const char* refused_because_ = "";
};

}  // namespace brachisto::ocp
