// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/program.hpp"

#include <fmt/format.h>

#include <algorithm>
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
      x_(at(num_variables)),
      place_(place) {}

nlp::Range Program::variable_range(int index) const {
  const auto at_or_behind =
      std::ranges::lower_bound(fixed_, index, {}, &Fixed::variable);
  if (at_or_behind == fixed_.end() || at_or_behind->variable != index) {
    return {-kInfinity, kInfinity};
  }
  return {at_or_behind->value, at_or_behind->value};
}

void Program::fix(int variable, double value) {
  release(variable);
  fixed_.insert(
      std::ranges::upper_bound(fixed_, variable, {}, &Fixed::variable),
      {variable, value});
}

void Program::release(int variable) {
  std::erase_if(fixed_,
                [&](const Fixed& fixed) { return fixed.variable == variable; });
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
