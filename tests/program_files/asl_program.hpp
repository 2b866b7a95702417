// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An .nl file as the AMPL Solver Library reads it: values and derivatives by
/// code of others.

#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"

namespace brachisto::testing {

class AslProgram final : public nlp::Problem {
 public:
  /// \throws std::runtime_error  if it cannot be read
  explicit AslProgram(const std::filesystem::path& nl_file);
  ~AslProgram() override;

  [[nodiscard]] int num_variables() const override;
  [[nodiscard]] int num_constraints() const override;
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return ranges_[at(index)];
  }
  [[nodiscard]] nlp::Range constraint_range(int index) const override {
    return row_ranges_[at(index)];
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jacobian_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hessian_;
  }
  /// From the files .col and .row.
  [[nodiscard]] std::string variable_name(int index) const override;
  [[nodiscard]] std::string constraint_name(int index) const override;
  [[nodiscard]] std::string refusal() const override {
    return "a function is not defined there";
  }
  /// x, and λ with the sign of PrimalDual, as far as the file has it.
  [[nodiscard]] const PrimalDual& start() const { return start_; }
  /// Writes the .sol file of an answer, with that sign too, beside the .nl
  /// file, as solvers do.
  void write_solution(const std::string& message, PrimalDual answer) const;

 private:
  struct Library;

  bool do_set_point(std::span<const double> x) override;
  [[nodiscard]] double do_eval_f() const override;
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void do_eval_jac_g(std::span<double> values) const override;
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override;

  std::unique_ptr<Library> library_;
  std::vector<nlp::Range> ranges_, row_ranges_;
  nlp::SparsityPattern jacobian_, hessian_;
  PrimalDual start_;
  std::vector<double> x_, g_;
  double f_ = 0.0;
};

}  // namespace brachisto::testing
