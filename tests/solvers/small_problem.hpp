// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Nonlinear programs of a few unknowns whose solution is known.

#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"

namespace brachisto::testing {

/// The functions of a problem, for something to happen in one of them.
enum class Function { SetPoint, F, GradF, G, JacG, HessLag };

/// Two free unknowns or more, one constraint, all entries dense; derived
/// classes give the formulas.
class SmallProblem : public nlp::Problem {
 public:
  /// Called at the beginning of each function.
  std::function<void(Function)> on_call = [](Function) {};
  /// Points that set_point() refuses.
  std::function<bool(std::span<const double>)> refuses =
      [](std::span<const double>) { return false; };

  void fix(int variable, double value) {
    ranges_[at(variable)] = {value, value};
  }

  [[nodiscard]] int num_variables() const override {
    return static_cast<int>(ranges_.size());
  }
  [[nodiscard]] int num_constraints() const override { return 1; }
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
    return "x" + std::to_string(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return "g" + std::to_string(index);
  }
  [[nodiscard]] std::string refusal() const override {
    return "the test says so";
  }

 protected:
  explicit SmallProblem(int num_variables)
      : x_(at(num_variables)),
        ranges_(at(num_variables), {-std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity()}) {
    for (int i = 0; i < num_variables; ++i) {
      jac_g_pattern_.add(0, i);
      for (int j = 0; j <= i; ++j) {
        hess_lag_pattern_.add(i, j);
      }
    }
  }

  std::vector<double> x_;  ///< the current point

 private:
  [[nodiscard]] virtual double f() const = 0;
  virtual void grad_f(std::span<double> values) const = 0;
  [[nodiscard]] virtual double g() const = 0;
  virtual void grad_g(std::span<double> values) const = 0;
  virtual void hess_lag(double factor, double lambda,
                        std::span<double> values) const = 0;

  bool do_set_point(std::span<const double> x) override {
    on_call(Function::SetPoint);
    x_.assign(x.begin(), x.end());
    return !refuses(x);
  }
  [[nodiscard]] double do_eval_f() const override {
    on_call(Function::F);
    return f();
  }
  void do_eval_grad_f(std::span<double> values) const override {
    on_call(Function::GradF);
    grad_f(values);
  }
  void do_eval_g(std::span<double> values) const override {
    on_call(Function::G);
    values[0] = g();
  }
  void do_eval_jac_g(std::span<double> values) const override {
    on_call(Function::JacG);
    grad_g(values);
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    on_call(Function::HessLag);
    hess_lag(objective_factor, lambda[0], values);
  }

  std::vector<nlp::Range> ranges_;
  nlp::SparsityPattern jac_g_pattern_, hess_lag_pattern_;
};

/// Problem 7 of Hock and Schittkowski:
///
///     minimise ln(1 + x₀²) − x₁  subject to  (1 + x₀²)² + x₁² = 4.
///
/// The solution is (0, √3) with f = −√3; there −1 + 2 √3 λ = 0.
class HockSchittkowski7 final : public SmallProblem {
 public:
  static constexpr std::array kStart{2.0, 2.0};
  static inline const double kSolution = std::sqrt(3.0);
  static inline const double kMultiplier = 0.5 / std::sqrt(3.0);

  HockSchittkowski7() : SmallProblem(2) {}

  bool nan_in_hessian = false;

 private:
  [[nodiscard]] double f() const override {
    return std::log1p(x_[0] * x_[0]) - x_[1];
  }
  void grad_f(std::span<double> values) const override {
    values[0] = 2.0 * x_[0] / (1.0 + x_[0] * x_[0]);
    values[1] = -1.0;
  }
  [[nodiscard]] double g() const override {
    const double a = 1.0 + x_[0] * x_[0];
    return a * a + x_[1] * x_[1] - 4.0;
  }
  void grad_g(std::span<double> values) const override {
    values[0] = 4.0 * x_[0] * (1.0 + x_[0] * x_[0]);
    values[1] = 2.0 * x_[1];
  }
  void hess_lag(double factor, double lambda,
                std::span<double> values) const override {
    const double square = x_[0] * x_[0];
    const double a = 1.0 + square;
    values[0] = factor * 2.0 * (1.0 - square) / (a * a) +
                lambda * (4.0 + 12.0 * square);
    values[1] = 0.0;
    values[2] = lambda * 2.0;
    if (nan_in_hessian) {
      values[0] = std::numeric_limits<double>::quiet_NaN();
    }
  }
};

/// minimise x₀ − ln x₀ subject to x₁ = x₀, defined for x₀ > 0 only; the
/// solution is (1, 1). Newton's step from x₀ = 3 goes to −3, half of it to 0.
class LogarithmicBowl final : public SmallProblem {
 public:
  LogarithmicBowl() : SmallProblem(2) {
    refuses = [](std::span<const double> x) { return !(x[0] > 0.0); };
  }

 private:
  [[nodiscard]] double f() const override { return x_[0] - std::log(x_[0]); }
  void grad_f(std::span<double> values) const override {
    values[0] = 1.0 - 1.0 / x_[0];
    values[1] = 0.0;
  }
  [[nodiscard]] double g() const override { return x_[1] - x_[0]; }
  void grad_g(std::span<double> values) const override {
    values[0] = -1.0;
    values[1] = 1.0;
  }
  void hess_lag(double factor, double /*lambda*/,
                std::span<double> values) const override {
    values[0] = factor / (x_[0] * x_[0]);
    values[1] = values[2] = 0.0;
  }
};

/// minimise Σ x_i² subject to Σ x_i = 6 in three unknowns; solution (2, 2, 2),
/// and with x₂ fixed at v: ((6 − v)/2, (6 − v)/2, v).
class NearestPoint final : public SmallProblem {
 public:
  NearestPoint() : SmallProblem(3) {}

 private:
  [[nodiscard]] double f() const override {
    return x_[0] * x_[0] + x_[1] * x_[1] + x_[2] * x_[2];
  }
  void grad_f(std::span<double> values) const override {
    for (std::size_t i = 0; i < 3; ++i) values[i] = 2.0 * x_[i];
  }
  [[nodiscard]] double g() const override {
    return x_[0] + x_[1] + x_[2] - 6.0;
  }
  void grad_g(std::span<double> values) const override {
    values[0] = values[1] = values[2] = 1.0;
  }
  void hess_lag(double factor, double /*lambda*/,
                std::span<double> values) const override {
    // Rows 0; 1, 1; 2, 2, 2 of the lower triangle.
    values[0] = values[2] = values[5] = 2.0 * factor;
    values[1] = values[3] = values[4] = 0.0;
  }
};

/// Where runs of HockSchittkowski7 begin.
inline const PrimalDual kStart{{2.0, 2.0}, {}};

[[nodiscard]] inline SolverResult with(LinearSolver solver,
                                       nlp::Problem& problem,
                                       const PrimalDual& start) {
  IpoptOptions options;
  options.linear_solver = solver;
  return solve_with_ipopt(problem, start, options);
}

}  // namespace brachisto::testing
