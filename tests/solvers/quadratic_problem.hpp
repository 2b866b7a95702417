// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Quadratic programs with any Hessian and Jacobian.

#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "support/random_points.hpp"

namespace brachisto::testing {

/// Entries in [−1, 1].
[[nodiscard]] inline Eigen::MatrixXd random_matrix(Random& random, int rows,
                                                   int cols) {
  Eigen::MatrixXd out(rows, cols);
  for (int j = 0; j < cols; ++j) {
    for (int i = 0; i < rows; ++i) out(i, j) = random.uniform(-1.0, 1.0);
  }
  return out;
}

/// minimise ½ xᵀ H x subject to J x = 0, all entries dense and every entry of
/// H given in two halves at the same position.
class QuadraticProblem final : public nlp::Problem {
 public:
  QuadraticProblem(Eigen::MatrixXd H, Eigen::MatrixXd J)
      : H_(std::move(H)),
        J_(std::move(J)),
        ranges_(at(H_.rows()), {-std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::infinity()}) {
    for (int i = 0; i < H_.rows(); ++i) {
      for (int j = 0; j <= i; ++j) {
        for (int half = 0; half < 2; ++half) {
          hess_pattern_.add(i, j);
        }
      }
      for (int row = 0; row < J_.rows(); ++row) {
        jac_pattern_.add(row, i);
      }
    }
  }

  void fix(int variable, double value) {
    ranges_[at(variable)] = {value, value};
  }

  [[nodiscard]] int num_variables() const override {
    return static_cast<int>(H_.rows());
  }
  [[nodiscard]] int num_constraints() const override {
    return static_cast<int>(J_.rows());
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return ranges_[at(index)];
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_pattern_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_pattern_;
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return "x" + std::to_string(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return "g" + std::to_string(index);
  }
  [[nodiscard]] std::string refusal() const override { return ""; }

 private:
  template <class Index>
  [[nodiscard]] static std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
  }
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> x() const {
    return {x_.data(), H_.rows()};
  }

  bool do_set_point(std::span<const double> x) override {
    x_.assign(x.begin(), x.end());
    return true;
  }
  [[nodiscard]] double do_eval_f() const override {
    return 0.5 * x().dot(H_ * x());
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    Eigen::Map<Eigen::VectorXd>(grad_f.data(), H_.rows()) = H_ * x();
  }
  void do_eval_g(std::span<double> g) const override {
    Eigen::Map<Eigen::VectorXd>(g.data(), J_.rows()) = J_ * x();
  }
  void do_eval_jac_g(std::span<double> values) const override {
    for (std::size_t e = 0; e < values.size(); ++e) {
      values[e] = J_(jac_pattern_[e].row, jac_pattern_[e].col);
    }
  }
  void do_eval_hess_lag(double objective_factor,
                        std::span<const double> /*lambda*/,
                        std::span<double> values) const override {
    for (std::size_t e = 0; e < values.size(); ++e) {
      values[e] = 0.5 * objective_factor *
                  H_(hess_pattern_[e].row, hess_pattern_[e].col);
    }
  }

  Eigen::MatrixXd H_, J_;
  std::vector<double> x_;
  std::vector<nlp::Range> ranges_;
  nlp::SparsityPattern jac_pattern_, hess_pattern_;
};

}  // namespace brachisto::testing
