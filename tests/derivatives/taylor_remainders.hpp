// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What first and second derivatives of a problem leave of its values at a
/// distance h.

#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::testing {

/// Steps small enough for the next term of the series not to show, and large
/// enough for h³ to stand above rounding.
inline constexpr std::array kSteps{0x1p-5, 0x1p-6, 0x1p-7, 0x1p-8, 0x1p-9};

/// Relative to the order, the next term bends the slope by a few h.
inline constexpr double kSlack = 0.15;

/// Of g and of the Lagrangian per step, the root of the sum of their squares:
/// over rows and, because the coefficient of h³ in one single number may happen
/// to be small, over several points and directions.
class TaylorRemainders {
 public:
  void add(nlp::Problem& problem, const std::vector<double>& x,
           const std::vector<double>& lambda,
           const std::vector<double>& direction) {
    const Evaluation here = evaluate(problem, x, lambda);
    std::vector<double> Jp(lambda.size());
    const auto& jac = problem.jac_g_pattern();
    for (std::size_t e = 0; e < jac.num_entries(); ++e) {
      Jp[static_cast<std::size_t>(jac[e].row)] +=
          here.jac_g[e] * direction[static_cast<std::size_t>(jac[e].col)];
    }
    double first = 0.0, second = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      first += here.grad_f[i] * direction[i];
    }
    for (std::size_t i = 0; i < lambda.size(); ++i) first += lambda[i] * Jp[i];
    const auto& hess = problem.hess_lag_pattern();
    for (std::size_t e = 0; e < hess.num_entries(); ++e) {
      const auto row = static_cast<std::size_t>(hess[e].row);
      const auto col = static_cast<std::size_t>(hess[e].col);
      const double twice = row == col ? 1.0 : 2.0;
      second += twice * here.hess_lag[e] * direction[row] * direction[col];
    }

    for (std::size_t s = 0; s < kSteps.size(); ++s) {
      const double h = kSteps[s];
      std::vector<double> moved = x;
      for (std::size_t i = 0; i < x.size(); ++i) moved[i] += h * direction[i];
      const Evaluation there = evaluate(problem, moved, lambda);
      double change = there.f - here.f;
      for (std::size_t i = 0; i < lambda.size(); ++i) {
        change += lambda[i] * (there.g[i] - here.g[i]);
        squares_g_[s] += std::pow(there.g[i] - here.g[i] - h * Jp[i], 2);
      }
      squares_lagrangian_[s] +=
          std::pow(change - h * first - 0.5 * h * h * second, 2);
    }
  }
  [[nodiscard]] std::array<double, kSteps.size()> g() const {
    return roots(squares_g_);
  }
  [[nodiscard]] std::array<double, kSteps.size()> lagrangian() const {
    return roots(squares_lagrangian_);
  }

 private:
  using PerStep = std::array<double, kSteps.size()>;

  /// f, g and their derivatives at one point.
  struct Evaluation {
    double f = 0.0;
    std::vector<double> grad_f, g, jac_g, hess_lag;
  };
  static Evaluation evaluate(nlp::Problem& problem,
                             const std::vector<double>& x,
                             const std::vector<double>& lambda) {
    Evaluation at_x;
    at_x.grad_f.resize(x.size());
    at_x.g.resize(lambda.size());
    at_x.jac_g.resize(problem.jac_g_pattern().num_entries());
    at_x.hess_lag.resize(problem.hess_lag_pattern().num_entries());
    if (!problem.set_point(x)) {
      ADD_FAILURE() << problem.refusal();
      return at_x;
    }
    at_x.f = problem.eval_f();
    problem.eval_grad_f(at_x.grad_f);
    problem.eval_g(at_x.g);
    problem.eval_jac_g(at_x.jac_g);
    problem.eval_hess_lag(1.0, lambda, at_x.hess_lag);
    return at_x;
  }
  static PerStep roots(PerStep squares) {
    for (double& square : squares) square = std::sqrt(square);
    return squares;
  }

  PerStep squares_g_{}, squares_lagrangian_{};
};

}  // namespace brachisto::testing
