// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Nonlinear programs with inequalities whose solutions are known.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/nlp/problem.hpp"

namespace brachisto::testing {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// Bounds, patterns and names; derived classes give the functions.
class BoundedProblem : public nlp::Problem {
 public:
  [[nodiscard]] int num_variables() const override {
    return static_cast<int>(ranges_.size());
  }
  [[nodiscard]] int num_constraints() const override {
    return static_cast<int>(row_ranges_.size());
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return ranges_[at(index)];
  }
  [[nodiscard]] nlp::Range constraint_range(int index) const override {
    return row_ranges_[at(index)];
  }
  [[nodiscard]] double weight(int index) const override {
    return weights_.empty() ? 1.0 : weights_[at(index)];
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_;
  }
  [[nodiscard]] nlp::ChainStructure chain_structure() const override {
    return chain_;
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return "x" + std::to_string(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return "g" + std::to_string(index);
  }
  [[nodiscard]] std::string refusal() const override { return "none"; }

 protected:
  void add_variable(double lower, double upper) {
    ranges_.push_back({lower, upper});
  }
  void add_constraint(double lower, double upper) {
    row_ranges_.push_back({lower, upper});
  }
  void add_jac(int row, int col) { jac_.add(row, col); }
  void add_hess(int row, int col) { hess_.add(row, col); }

  std::vector<double> x_, weights_;
  std::vector<nlp::Range> ranges_, row_ranges_;
  nlp::SparsityPattern jac_, hess_;
  nlp::ChainStructure chain_;

 private:
  bool do_set_point(std::span<const double> x) override {
    x_.assign(x.begin(), x.end());
    return true;
  }
};

/// A problem of a few unknowns from its formulas, derivatives by jets.
/// `Formula` has kVariables, kConstraints and, for any Scalar, f(x) and g(x).
template <class Formula>
class DenseProblem final : public BoundedProblem {
 public:
  static constexpr int kVariables = Formula::kVariables;
  static constexpr int kConstraints = Formula::kConstraints;

  DenseProblem() {
    for (const auto& [lower, upper] : Formula::kBounds) {
      add_variable(lower, upper);
    }
    for (const auto& [lower, upper] : Formula::kRanges) {
      add_constraint(lower, upper);
    }
    for (int i = 0; i < kVariables; ++i) {
      for (int j = 0; j <= i; ++j) add_hess(i, j);
      for (int row = 0; row < kConstraints; ++row) add_jac(row, i);
    }
  }

 private:
  using Jet = math::Jet2<double, kVariables>;

  [[nodiscard]] std::array<Jet, kVariables> jets() const {
    std::array<Jet, kVariables> out;
    for (int i = 0; i < kVariables; ++i) {
      out[at(i)] = Jet::variable(x_[at(i)], i);
    }
    return out;
  }
  [[nodiscard]] double do_eval_f() const override {
    return Formula::f(jets()).value;
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    std::ranges::copy(Formula::f(jets()).gradient, grad_f.begin());
  }
  void do_eval_g(std::span<double> g) const override {
    const auto rows = Formula::g(jets());
    for (std::size_t i = 0; i < rows.size(); ++i) g[i] = rows[i].value;
  }
  void do_eval_jac_g(std::span<double> values) const override {
    const auto rows = Formula::g(jets());
    for (std::size_t e = 0; e < values.size(); ++e) {
      values[e] = rows[at(jac_[e].row)].gradient[at(jac_[e].col)];
    }
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    Jet lagrangian = objective_factor * Formula::f(jets());
    const auto rows = Formula::g(jets());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      lagrangian += lambda[i] * rows[i];
    }
    std::ranges::copy(lagrangian.hessian, values.begin());
  }
};

/// A string between (0, 0) and (1, 0) over an obstacle: N pieces of length h,
///
///     minimise Σ (y_j − y_{j−1})²/2h  subject to  y_j ≥ ψ(t_j),
///
/// ψ(t) = 1 − 8 (t − ½)², as bounds or as constraints. The string lies on the
/// obstacle where |t − ½| ≤ ½ − √⅛, and is straight elsewhere. On the mesh the
/// same holds with the largest K for which node N/2 ± K still presses on it:
/// the slopes of the obstacle's pieces are known, so the forces, the
/// multipliers, are 16 h inside and, at the last nodes of the contact, the jump
/// of the slope.
class Obstacle final : public BoundedProblem {
 public:
  /// \param num_pieces  even
  Obstacle(int num_pieces, bool as_constraints) : N_(num_pieces) {
    chain_.num_links = N_;
    for (int j = 0; j <= N_; ++j) {
      const bool end = j == 0 || j == N_;
      add_variable(end              ? 0.0
                   : as_constraints ? -kNoBound
                                    : psi(j),
                   end ? 0.0 : kNoBound);
      add_hess(j, j);
      if (j > 0) add_hess(j, j - 1);
      chain_.block.push_back(2 * j);
    }
    for (int j = 1; as_constraints && j < N_; ++j) {
      add_constraint(psi(j), kNoBound);
      add_jac(j - 1, j);
      chain_.block.push_back(2 * j + 1);
    }
    weights_.assign(ranges_.size() + row_ranges_.size(), h());
  }

  /// y_j and the force on node j, in closed form.
  [[nodiscard]] double y(int j) const {
    const int from_middle = std::abs(j - N_ / 2);
    const int K = contact();
    if (from_middle <= K) return psi(j);
    return psi(N_ / 2 + K) * (0.5 * N_ - from_middle) / (0.5 * N_ - K);
  }
  [[nodiscard]] double force(int j) const {
    const int from_middle = std::abs(j - N_ / 2);
    if (from_middle < contact()) return 16.0 * h();
    return from_middle == contact() ? last_force(contact()) : 0.0;
  }
  [[nodiscard]] std::vector<double> start() const {
    return std::vector<double>(ranges_.size(), 0.5);
  }

 private:
  [[nodiscard]] double h() const { return 1.0 / N_; }
  [[nodiscard]] double psi(int j) const {
    const double t = (j - 0.5 * N_) * h();
    return 1.0 - 8.0 * t * t;
  }
  /// Slope before minus slope behind node N/2 + K, straight from there on.
  [[nodiscard]] double last_force(int K) const {
    const double here = psi(N_ / 2 + K);
    return (here - psi(N_ / 2 + K - 1)) / h() + here / (0.5 - K * h());
  }
  [[nodiscard]] int contact() const {
    int K = 0;
    while (K + 1 < N_ / 2 && last_force(K + 1) > 0.0) ++K;
    return K;
  }

  [[nodiscard]] double do_eval_f() const override {
    double sum = 0.0;
    for (int j = 1; j <= N_; ++j) {
      const double rise = x_[at(j)] - x_[at(j - 1)];
      sum += 0.5 * rise * rise / h();
    }
    return sum;
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    std::ranges::fill(grad_f, 0.0);
    for (int j = 1; j <= N_; ++j) {
      const double slope = (x_[at(j)] - x_[at(j - 1)]) / h();
      grad_f[at(j)] += slope;
      grad_f[at(j - 1)] -= slope;
    }
  }
  void do_eval_g(std::span<double> g) const override {
    for (std::size_t i = 0; i < g.size(); ++i) g[i] = x_[i + 1];
  }
  void do_eval_jac_g(std::span<double> values) const override {
    std::ranges::fill(values, 1.0);
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double>,
                        std::span<double> values) const override {
    for (std::size_t e = 0; e < values.size(); ++e) {
      const int i = hess_[e].row;
      const bool end = i == 0 || i == N_;
      const double entry = i != hess_[e].col ? -1.0 : end ? 1.0 : 2.0;
      values[e] = objective_factor * entry / h();
    }
  }

  int N_;
};

/// From rest at 0 to rest at 1 in the least time T with |u| ≤ 1, ẋ = v, v̇ = u,
/// the control constant on each of N pieces, on which the motion is exact:
///
///     x_{j+1} − x_j − h v_j − h² u_j/2 = 0,  v_{j+1} − v_j − h u_j = 0,
///
/// h = T/N. For odd N = 2M + 1 the control is 1 on M pieces, 0 on one and −1 on
/// M: the distance is h² M (M + 1) = 1, so that T = 2N/√(N² − 1). The costates
/// are p_x = −a, p_v = −a (T/2 − t), with a = T/2 from stationarity in T; the
/// multipliers are −p at the end of each piece and, of the bounds of u_j, the
/// integral of |p_v| over the piece. (For even N, where the switch falls on a
/// node, more constraints hold than there are free variables.)
///
/// Unknowns: (x_j, v_j, u_j) for each j < N, then x_N, v_N, T. Constraints: the
/// two of each piece and, with `as_constraints`, −1 ≤ u_j ≤ 1 behind them.
class DoubleIntegrator final : public BoundedProblem {
 public:
  /// \param num_pieces  odd
  DoubleIntegrator(int num_pieces, bool as_constraints)
      : N_(num_pieces), rows_(as_constraints ? 3 : 2) {
    chain_.num_links = N_;
    for (int j = 0; j <= N_; ++j) {
      const bool end = j == 0 || j == N_;
      const double place = j == 0 ? 0.0 : 1.0;
      add_variable(end ? place : -kNoBound, end ? place : kNoBound);
      add_variable(end ? 0.0 : -kNoBound, end ? 0.0 : kNoBound);
      chain_.block.insert(chain_.block.end(), {2 * j, 2 * j});
      if (j == N_) continue;
      add_variable(as_constraints ? -kNoBound : -1.0,
                   as_constraints ? kNoBound : 1.0);
      chain_.block.push_back(2 * j + 1);
    }
    add_variable(0.0, kNoBound);
    chain_.block.push_back(nlp::ChainStructure::kBorder);
    for (int j = 0; j < N_; ++j) {
      add_constraint(0.0, 0.0);
      add_constraint(0.0, 0.0);
      // The multipliers that lead to a node go with it.
      chain_.block.insert(chain_.block.end(), {2 * j + 2, 2 * j + 2});
      for (const int col : {x(j), v(j), u(j), x(j + 1), T()}) {
        add_jac(rows_ * j, col);
      }
      for (const int col : {v(j), u(j), v(j + 1), T()}) {
        add_jac(rows_ * j + 1, col);
      }
      add_hess(T(), v(j));
      add_hess(T(), u(j));
      add_hess(T(), T());
      if (!as_constraints) continue;
      add_constraint(-1.0, 1.0);
      chain_.block.push_back(2 * j + 1);
      add_jac(rows_ * j + 2, u(j));
    }
    weights_.assign(ranges_.size() + row_ranges_.size(), 1.0 / N_);
    weights_[at(T())] = 1.0;
  }

  [[nodiscard]] static int x(int j) { return 3 * j; }
  [[nodiscard]] static int v(int j) { return 3 * j + 1; }
  [[nodiscard]] static int u(int j) { return 3 * j + 2; }
  [[nodiscard]] int T() const { return 3 * N_ + 2; }
  /// Of the constraint on u_j.
  [[nodiscard]] static int control_row(int j) { return 3 * j + 2; }

  [[nodiscard]] PrimalDual solution() const {
    const double time = 2.0 * N_ / std::sqrt(1.0 * N_ * N_ - 1.0);
    const double h = time / N_;
    const double a = 0.5 * time;
    PrimalDual out;
    out.x.resize(ranges_.size());
    out.lambda.resize(row_ranges_.size());
    out.z_lower.assign(ranges_.size(), 0.0);
    out.z_upper.assign(ranges_.size(), 0.0);
    for (int j = 0; j <= N_; ++j) {
      const bool first_half = 2 * j < N_;
      const double from_end = h * (first_half ? j : N_ - j);
      const double way = 0.5 * from_end * from_end;
      out.x[at(x(j))] = first_half ? way : 1.0 - way;
      out.x[at(v(j))] = from_end;
      if (j == N_) break;
      const int pieces_to_middle = N_ / 2 - j;
      const double pressure = a * h * h * pieces_to_middle;  // −∫ p_v dt
      out.x[at(u(j))] = (pieces_to_middle > 0) - (pieces_to_middle < 0);
      out.lambda[at(rows_ * j)] = a;
      out.lambda[at(rows_ * j + 1)] = a * h * (0.5 * N_ - (j + 1));
      if (rows_ == 3) {
        out.lambda[at(control_row(j))] = pressure;
      } else {
        out.z_upper[at(u(j))] = std::max(0.0, pressure);
        out.z_lower[at(u(j))] = std::max(0.0, -pressure);
      }
    }
    out.x[at(T())] = time;
    return out;
  }
  [[nodiscard]] std::vector<double> start() const {
    std::vector<double> out(ranges_.size(), 0.0);
    for (int j = 0; j <= N_; ++j) {
      out[at(x(j))] = static_cast<double>(j) / N_;
      if (j > 0 && j < N_) out[at(v(j))] = 0.3;
    }
    out[at(T())] = 3.0;
    return out;
  }

 private:
  [[nodiscard]] double value(int i) const { return x_[at(i)]; }

  [[nodiscard]] double do_eval_f() const override { return value(T()); }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    std::ranges::fill(grad_f, 0.0);
    grad_f[at(T())] = 1.0;
  }
  void do_eval_g(std::span<double> g) const override {
    const double h = value(T()) / N_;
    for (int j = 0; j < N_; ++j) {
      g[at(rows_ * j)] = value(x(j + 1)) - value(x(j)) - h * value(v(j)) -
                         0.5 * h * h * value(u(j));
      g[at(rows_ * j + 1)] = value(v(j + 1)) - value(v(j)) - h * value(u(j));
      if (rows_ == 3) g[at(control_row(j))] = value(u(j));
    }
  }
  void do_eval_jac_g(std::span<double> values) const override {
    const double h = value(T()) / N_;
    std::size_t e = 0;
    for (int j = 0; j < N_; ++j) {
      const double by_T = -(value(v(j)) + h * value(u(j))) / N_;
      for (const double entry : {-1.0, -h, -0.5 * h * h, 1.0, by_T, -1.0, -h,
                                 1.0, -value(u(j)) / N_}) {
        values[e++] = entry;
      }
      if (rows_ == 3) values[e++] = 1.0;
    }
  }
  void do_eval_hess_lag(double, std::span<const double> lambda,
                        std::span<double> values) const override {
    const double h = value(T()) / N_;
    std::size_t e = 0;
    for (int j = 0; j < N_; ++j) {
      const double lambda_x = lambda[at(rows_ * j)] / N_;
      const double lambda_v = lambda[at(rows_ * j + 1)] / N_;
      values[e++] = -lambda_x;
      values[e++] = -h * lambda_x - lambda_v;
      values[e++] = -lambda_x * value(u(j)) / N_;
    }
  }

  int N_, rows_;
};

}  // namespace brachisto::testing
