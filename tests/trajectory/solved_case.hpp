// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A solution to tamper with, and a problem with other fixed values.

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "refinement/mesh_solve.hpp"
#include "support/reference_values.hpp"
#include "trajectory/certify.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto::testing {

/// Relative error of T on a mesh that resolves it to about 1e-12, with room.
inline constexpr double kSolvedError = 1e-10;

/// The base case on such a mesh.
class SolvedCase : public ::testing::Test {
 protected:
  SolvedCase() {
    const auto arc = axisymmetric_optimum(problem.scene());
    const MeshSolution solution =
        solve_on_mesh(problem, {cycloid_guess(problem, *arc), 0.0}, {});
    solved = solution.solved();
    point = solution.point;
    phi = solution.tangency.phi;
  }
  void SetUp() override { ASSERT_TRUE(solved) << "base case"; }

  [[nodiscard]] double& unknown(int index) {
    return point.x[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] Certificate certificate() {
    return certify(problem, point, phi, kSolvedError);
  }
  [[nodiscard]] bool passes(const std::string& check) {
    const Certificate result = certificate();
    const Check* found = result.find(check);
    return found != nullptr && found->passed;
  }

  RollingTime problem{in_natural_units(reference("reference_case").scene()),
                      uniform_mesh(5, 24), 0.0};
  PrimalDual point;
  double phi = 0.0;
  bool solved = false;
};

/// A problem with other values of its fixed variables.
class MovedBounds final : public nlp::Problem {
 public:
  explicit MovedBounds(RollingTime& problem) : problem_(problem) {}
  void fix(int variable, double value) { fixed_[variable] = value; }

  [[nodiscard]] int num_variables() const override {
    return problem_.num_variables();
  }
  [[nodiscard]] int num_constraints() const override {
    return problem_.num_constraints();
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    const auto fixed = fixed_.find(index);
    if (fixed == fixed_.end()) return problem_.variable_range(index);
    return {fixed->second, fixed->second};
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return problem_.jac_g_pattern();
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return problem_.hess_lag_pattern();
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return problem_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return problem_.constraint_name(index);
  }
  [[nodiscard]] std::string refusal() const override {
    return problem_.refusal();
  }

 private:
  bool do_set_point(std::span<const double> x) override {
    return problem_.set_point(x);
  }
  [[nodiscard]] double do_eval_f() const override { return problem_.eval_f(); }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    problem_.eval_grad_f(grad_f);
  }
  void do_eval_g(std::span<double> g) const override { problem_.eval_g(g); }
  void do_eval_jac_g(std::span<double> values) const override {
    problem_.eval_jac_g(values);
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    problem_.eval_hess_lag(objective_factor, lambda, values);
  }

  RollingTime& problem_;
  std::map<int, double> fixed_;
};

}  // namespace brachisto::testing
