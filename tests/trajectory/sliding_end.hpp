// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The wrong way to ask for a smooth contact.

#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::testing {

/// The minimisation in which the end of the centre's path may slide on the
/// circle about B, tied to the last slope: an optimiser bends the last element.
class SlidingEnd final : public nlp::Problem {
 public:
  explicit SlidingEnd(RollingTime& problem)
      : problem_(problem),
        jac_(problem.jac_g_pattern()),
        hess_(problem.hess_lag_pattern()) {
    const VariableLayout& layout = problem.layout();
    x_end_ = layout.state(layout.num_points(), StateComponent::X);
    z_end_ = layout.state(layout.num_points(), StateComponent::Z);
    beta_ = layout.beta(layout.num_points() - 1);
    for (const int end : {x_end_, z_end_}) {
      const int row = problem.num_constraints() + (end == z_end_ ? 1 : 0);
      jac_.add(row, end);
      jac_.add(row, beta_);
    }
    hess_.add(beta_, beta_);
  }

  [[nodiscard]] int num_variables() const override {
    return problem_.num_variables();
  }
  [[nodiscard]] int num_constraints() const override {
    return problem_.num_constraints() + 2;
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    if (index != x_end_ && index != z_end_) {
      return problem_.variable_range(index);
    }
    return {-std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_;
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return problem_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return "g" + std::to_string(index);
  }
  [[nodiscard]] std::string refusal() const override {
    return problem_.refusal();
  }
  /// The slope that the end is tied to.
  [[nodiscard]] double phi(const PrimalDual& point) const {
    return point.x[at(beta_)];
  }

 private:
  bool do_set_point(std::span<const double> x) override {
    x_.assign(x.begin(), x.end());
    return problem_.set_point(x);
  }
  [[nodiscard]] double do_eval_f() const override { return problem_.eval_f(); }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    problem_.eval_grad_f(grad_f);
  }
  void do_eval_g(std::span<double> g) const override {
    const Scene& scene = problem_.scene();
    const double r = scene.body.radius;
    const std::size_t m = g.size() - 2;
    problem_.eval_g(g.first(m));
    g[m] = x_[at(x_end_)] - scene.L - r * std::sin(x_[at(beta_)]);
    g[m + 1] = x_[at(z_end_)] - scene.H + r * std::cos(x_[at(beta_)]);
  }
  void do_eval_jac_g(std::span<double> values) const override {
    const double r = problem_.scene().body.radius;
    const std::size_t n = values.size() - 4;
    problem_.eval_jac_g(values.first(n));
    values[n] = values[n + 2] = 1.0;
    values[n + 1] = -r * std::cos(x_[at(beta_)]);
    values[n + 3] = -r * std::sin(x_[at(beta_)]);
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    const double r = problem_.scene().body.radius;
    const std::size_t m = lambda.size() - 2;
    problem_.eval_hess_lag(objective_factor, lambda.first(m),
                           values.first(values.size() - 1));
    values.back() = r * (lambda[m] * std::sin(x_[at(beta_)]) -
                         lambda[m + 1] * std::cos(x_[at(beta_)]));
  }

  RollingTime& problem_;
  std::vector<double> x_;
  nlp::SparsityPattern jac_, hess_;
  int x_end_, z_end_, beta_;
};

}  // namespace brachisto::testing
