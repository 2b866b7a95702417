// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "nlp/elastic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/index.hpp"

namespace brachisto::nlp {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Elastic::Elastic(Problem& problem, std::vector<double> give, double price)
    : problem_(problem),
      price_(price),
      inner_n_(problem.num_variables()),
      inner_m_(problem.num_constraints()),
      give_(std::move(give)),
      jac_(problem.jac_g_pattern()),
      joined_(at(inner_m_)) {
  std::vector<int> twin_of(at(inner_m_), -1);
  for (int row = 0; row < inner_m_; ++row) {
    const Range range = problem.constraint_range(row);
    ranges_.push_back(range);
    double& give_of_row = give_[at(row)];
    if (give_of_row == 0.0) continue;
    if (!std::isfinite(range.lower)) {
      give_of_row = -give_of_row;
    } else if (std::isfinite(range.upper)) {
      twin_of[at(row)] = inner_m_ + static_cast<int>(twins_.size());
      twins_.push_back(row);
      ranges_.back().upper = kInfinity;
    }
  }
  for (const int row : twins_) {
    ranges_.push_back({-kInfinity, problem.constraint_range(row).upper});
    give_.push_back(-give_[at(row)]);
  }
  problem.jac_g_pattern().for_each([&](std::size_t entry, int row, int col) {
    const int twin = twin_of[at(row)];
    if (twin < 0) return;
    twin_entries_.push_back(static_cast<int>(entry));
    jac_.add(twin, col);
  });
  for (int row = 0; row < num_constraints(); ++row) {
    if (give_[at(row)] == 0.0) continue;
    jac_.add(row, inner_n_);
  }
}

Range Elastic::variable_range(int index) const {
  return index == inner_n_ ? Range{0.0, kInfinity}
                           : problem_.variable_range(index);
}

double Elastic::weight(int index) const {
  if (index < inner_n_) return problem_.weight(index);
  if (index == inner_n_) return 1.0;
  return problem_.weight(inner_n_ + row_of(index - inner_n_ - 1));
}

PrimalDual Elastic::with_elasticity(PrimalDual point, double t) const {
  point.x.push_back(t);
  if (point.lambda.empty()) return point;
  for (const int row : twins_) {
    const double lambda = point.lambda[at(row)];
    point.lambda[at(row)] = std::min(0.0, lambda);
    point.lambda.push_back(std::max(0.0, lambda));
  }
  point.z_lower.resize(at(inner_n_), 0.0);
  point.z_upper.resize(at(inner_n_), 0.0);
  point.z_lower.push_back(price_);
  point.z_upper.push_back(0.0);
  return point;
}

PrimalDual Elastic::without_elasticity(PrimalDual point) const {
  for (std::size_t k = 0; k < twins_.size(); ++k) {
    point.lambda[at(twins_[k])] += point.lambda[at(inner_m_) + k];
  }
  point.lambda.resize(at(inner_m_));
  for (std::vector<double>* of_variables :
       {&point.x, &point.z_lower, &point.z_upper}) {
    if (!of_variables->empty()) of_variables->pop_back();
  }
  return point;
}

ChainStructure Elastic::chain_structure() const {
  ChainStructure chain = problem_.chain_structure();
  if (chain.empty()) return chain;
  const auto widened = [&](auto& values, auto of_t) {
    values.insert(values.begin() + inner_n_, of_t);
    for (const int row : twins_) {
      values.push_back(values[at(inner_n_ + 1 + row)]);
    }
  };
  widened(chain.block, ChainStructure::kBorder);
  if (!chain.scale.empty()) widened(chain.scale, 1.0);
  return chain;
}

std::string Elastic::variable_name(int index) const {
  return index == inner_n_ ? "t" : problem_.variable_name(index);
}

std::string Elastic::constraint_name(int index) const {
  return problem_.constraint_name(row_of(index));
}

bool Elastic::do_set_point(std::span<const double> x) {
  t_ = x.back();
  return problem_.set_point(x.first(at(inner_n_)));
}

double Elastic::do_eval_f() const {
  return problem_.eval_f() + price_ * t_;
}

void Elastic::do_eval_grad_f(std::span<double> grad_f) const {
  problem_.eval_grad_f(grad_f.first(at(inner_n_)));
  grad_f.back() = price_;
}

void Elastic::do_eval_g(std::span<double> g) const {
  problem_.eval_g(g.first(at(inner_m_)));
  for (std::size_t k = 0; k < twins_.size(); ++k) {
    g[at(inner_m_) + k] = g[at(twins_[k])];
  }
  for (std::size_t row = 0; row < g.size(); ++row) g[row] += give_[row] * t_;
}

void Elastic::do_eval_jac_g(std::span<double> values) const {
  std::size_t next = problem_.jac_g_pattern().num_entries();
  problem_.eval_jac_g(values.first(next));
  for (const int entry : twin_entries_) values[next++] = values[at(entry)];
  for (const double give : give_) {
    if (give != 0.0) values[next++] = give;
  }
}

void Elastic::do_eval_hess_lag(double objective_factor,
                               std::span<const double> lambda,
                               std::span<double> values) const {
  std::copy_n(lambda.begin(), inner_m_, joined_.begin());
  for (std::size_t k = 0; k < twins_.size(); ++k) {
    joined_[at(twins_[k])] += lambda[at(inner_m_) + k];
  }
  problem_.eval_hess_lag(objective_factor, joined_, values);
}

}  // namespace brachisto::nlp
