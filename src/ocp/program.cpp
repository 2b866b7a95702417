// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/program.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Program::Program(Mesh mesh, int num_variables, int num_constraints,
                 const char* place)
    : mesh_(std::move(mesh)),
      num_constraints_(num_constraints),
      lower_(at(num_variables), -kInfinity),
      upper_(at(num_variables), kInfinity),
      x_(at(num_variables)),
      place_(place) {}

void Program::bound(int variable, double lower, double upper) {
  lower_[at(variable)] = lower;
  upper_[at(variable)] = upper;
}

void Program::fix(int variable, double value) {
  bound(variable, value, value);
}

void Program::release(int variable) {
  bound(variable, -kInfinity, kInfinity);
}

void Program::bound_row(int row, double lower, double upper) {
  if (row_lower_.empty()) {
    row_lower_.resize(at(num_constraints_));
    row_upper_.resize(at(num_constraints_));
  }
  row_lower_[at(row)] = lower;
  row_upper_[at(row)] = upper;
}

void Program::change_lengths(Mesh mesh) {
  mesh_ = std::move(mesh);
  forget_point();
}

void Program::forget_point() {
  // No point is equal to this one.
  x_.front() = std::numeric_limits<double>::quiet_NaN();
}

bool Program::refuse(int place, const char* reason) {
  refused_place_ = place;
  refused_because_ = reason;
  return false;
}

std::string Program::refusal() const {
  if (refused_place_ < 0) return refused_because_;
  return fmt::format("{} at {} {} of {}", refused_because_, place_,
                     refused_place_, mesh_.num_points());
}

void Program::build_patterns() {
  const PhaseTimer timer(Phase::SetUp);
  auto patterns = std::make_shared<Patterns>();
  Entries jac_g(patterns->jac_g);
  put_jac_g(jac_g);
  // Zeros of calloc() of which a few are read need a few pages.
  const std::size_t m = at(num_constraints());
  const std::unique_ptr<double, decltype(&std::free)> no_lambda(
      static_cast<double*>(std::calloc(m, sizeof(double))), &std::free);
  if (!no_lambda) throw std::bad_alloc();
  Entries hess_lag(patterns->hess_lag);
  put_hess_lag(0.0, {no_lambda.get(), m}, hess_lag);
  patterns_ = std::move(patterns);
}

bool Program::do_set_point(std::span<const double> x) {
  x_.assign(x.begin(), x.end());
  return evaluate();
}

void Program::do_eval_jac_g(std::span<double> values) const {
  Entries put(values);
  put_jac_g(put);
}

void Program::do_eval_hess_lag(double objective_factor,
                               std::span<const double> lambda,
                               std::span<double> values) const {
  Entries put(values);
  put_hess_lag(objective_factor, lambda, put);
}

}  // namespace brachisto::ocp
