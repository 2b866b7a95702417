// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A problem small enough to solve by hand.

#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"

namespace brachisto::testing {

/// minimise x_0² + x_1² + 5 x_2 subject to x_0 + x_1 − x_2 = 0 and
/// x_0 x_1 − 1 = 0, x_2 fixed at 2; defined for x_0 ≥ 0. The only feasible
/// point is (1, 1, 2).
class TinyProblem final : public nlp::Problem {
 public:
  /// Added to ∂f/∂x_i, g_i, and entries of derivatives, to stand for mistakes.
  std::vector<double> spoil_grad_f{0.0, 0.0, 0.0};
  std::vector<double> spoil_g{0.0, 0.0};
  std::vector<double> spoil_jac_g = std::vector<double>(5);
  std::vector<double> spoil_hess_lag = std::vector<double>(4);
  /// Whether a point need not be evaluated again, as of a problem that follows
  /// from x alone.
  bool remembers = false;
  /// Whether the next evaluation of a point throws, its work half done.
  bool throws = false;
  int points = 0;  ///< evaluated so far

  TinyProblem() {
    jac_g_pattern_ = {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}};
    // x_0 twice: values at one position add up.
    hess_lag_pattern_ = {{0, 0}, {0, 0}, {1, 0}, {1, 1}};
  }

  [[nodiscard]] int num_variables() const override { return 3; }
  [[nodiscard]] int num_constraints() const override { return 2; }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return ranges_[at(index)];
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_g_pattern_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_lag_pattern_;
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return "x[" + std::to_string(index) + "]";
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return "g[" + std::to_string(index) + "]";
  }
  [[nodiscard]] std::string refusal() const override {
    return "x[0] is negative";
  }

 private:
  bool do_set_point(std::span<const double> x) override {
    ++points;
    x_.assign(x.begin(), x.end());
    if (throws) throw std::runtime_error("half a point");
    return !(x_[0] < 0.0);
  }
  [[nodiscard]] std::span<const double> current_point() const override {
    if (!remembers) return {};
    return x_;
  }
  [[nodiscard]] double do_eval_f() const override {
    return x_[0] * x_[0] + x_[1] * x_[1] + 5.0 * x_[2];
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    grad_f[0] = 2.0 * x_[0] + spoil_grad_f[0];
    grad_f[1] = 2.0 * x_[1] + spoil_grad_f[1];
    grad_f[2] = 5.0 + spoil_grad_f[2];
  }
  void do_eval_g(std::span<double> g) const override {
    g[0] = x_[0] + x_[1] - x_[2] + spoil_g[0];
    g[1] = x_[0] * x_[1] - 1.0 + spoil_g[1];
  }
  void do_eval_jac_g(std::span<double> values) const override {
    values[0] = 1.0;
    values[1] = 1.0;
    values[2] = -1.0;
    values[3] = x_[1];
    values[4] = x_[0];
    for (std::size_t i = 0; i < 5; ++i) values[i] += spoil_jac_g[i];
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    values[0] = objective_factor;
    values[1] = objective_factor;
    values[2] = lambda[1];
    values[3] = 2.0 * objective_factor;
    for (std::size_t i = 0; i < 4; ++i) values[i] += spoil_hess_lag[i];
  }

  static constexpr double kFree = std::numeric_limits<double>::infinity();
  std::vector<nlp::Range> ranges_{{-kFree, kFree}, {-kFree, kFree}, {2.0, 2.0}};
  nlp::SparsityPattern jac_g_pattern_, hess_lag_pattern_;
  std::vector<double> x_;
};

}  // namespace brachisto::testing
