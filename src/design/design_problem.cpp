// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_problem.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>

#include "brachisto/math/index.hpp"

namespace brachisto {

namespace {

/// What is asked of a margin: more than nothing, by what solves leave open.
constexpr double kLeastMargin = 1e-6;
/// And of that of the branch, at whose edge solves from the cycloid lose digits
/// and their way: τ there is less by this times the multiplier.
constexpr double kLeastOfBranch = 5e-3;
constexpr double kMostOfBranch = 0.5 * std::numbers::pi - kLeastOfBranch;

Eigen::Index count_of(Keep keep, bool with_grip) {
  if (keep == Keep::None) return 0;
  if (keep == Keep::Branch) return 1;
  return static_cast<Eigen::Index>(with_grip ? kMargins.size() : kGripMargin);
}

}  // namespace

DesignProblem::DesignProblem(const DesignSpace& space, ClosedTimes& times,
                             Keep keep)
    : space_(space),
      times_(times),
      num_margins_(count_of(keep, times.max_grip().has_value())) {
  for (const DesignSpace::Row& row : space.rows()) {
    row_ranges_.push_back({row.lower, row.upper});
  }
  const auto margins = static_cast<std::size_t>(num_margins_);
  row_ranges_.insert(row_ranges_.end(), margins,
                     {kLeastMargin, std::numeric_limits<double>::infinity()});
  if (margins > 0) {
    row_ranges_[space.rows().size()] = {kLeastOfBranch, kMostOfBranch};
  }
  for (int row = 0; row < num_constraints(); ++row) {
    for (int column = 0; column < num_variables(); ++column) {
      jacobian_.add(row, column);
    }
  }
}

std::string DesignProblem::variable_name(int index) const {
  return space_.names()[at(index)];
}

std::string DesignProblem::constraint_name(int index) const {
  const std::size_t row = at(index), own = space_.rows().size();
  return row < own ? space_.rows()[row].name : std::string(kMargins[row - own]);
}

std::vector<BoundOfDesign> DesignProblem::bounds_that_hold(
    const PrimalDual& point) const {
  std::vector<BoundOfDesign> out;
  const auto holds = [&](std::size_t i, double bound, double slope) {
    const double unit = space_.unit(i);
    out.push_back({space_.names()[i], bound * unit, slope / unit});
  };
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    // Derivatives of the least τ are z_l by x_l and −z_u by x_u.
    if (point.z_lower[i] != 0.0) {
      holds(i, space_.lower()[i], point.z_lower[i]);
    } else if (point.z_upper[i] != 0.0) {
      holds(i, space_.upper()[i], -point.z_upper[i]);
    }
  }
  const std::optional<double> at_corner = space_.corner_on_axis(point.lambda);
  if (at_corner)
    out.push_back({std::string(name(BodyKey::EtaM)), 0.0, *at_corner});
  for (std::size_t i = 0; i < point.lambda.size(); ++i) {
    if (point.lambda[i] == 0.0) continue;
    if (at_corner && i < space_.rows().size() &&
        space_.rows()[i].name == name(BodyKey::ThetaM)) {
      continue;
    }
    const std::size_t own = space_.rows().size();
    const DesignSpace::Stated stated =
        i >= own ? stated_margin(i - own, point.lambda[i] > 0.0)
                 : space_.stated(i, point.lambda[i] > 0.0, y_);
    out.push_back({constraint_name(static_cast<int>(i)), stated.bound,
                   -point.lambda[i] * stated.slope});
  }
  return out;
}

DesignSpace::Stated DesignProblem::stated_margin(std::size_t margin,
                                                 bool at_most) const {
  if (margin == 0) return {at_most ? kMostOfBranch : kLeastOfBranch, 1.0};
  if (margin != kGripMargin) return {0.0, 1.0};
  // atan μ − ρ ≥ 0: more μ is less of a bound.
  const double mu = times_.max_grip()->mu;
  return {mu, -1.0 / (1.0 + mu * mu)};
}

bool DesignProblem::do_set_point(std::span<const double> x) {
  y_ = Eigen::Map<const Eigen::VectorXd>(x.data(), num_variables());
  gradient_.reset();
  margin_rows_.reset();
  if (times_.move_to(space_.traits(y_), space_.moved_traits(y_))) {
    refused_in_a_row_ = 0;
    return true;
  }
  // Steps are halved, so that the last one was a thousandth of the first.
  constexpr int kMostRefused = 10;
  if (++refused_in_a_row_ > kMostRefused) {
    throw NoWayOn(
        "no body near the one that the search has come to is "
        "accepted, the last because " +
        times_.refusal());
  }
  return false;
}

void DesignProblem::do_eval_grad_f(std::span<double> grad_f) const {
  if (!gradient_) {
    times_.hold_on();
    gradient_ = space_.traits_jacobian(y_).transpose() * times_.gradient();
    path_.push_back({space_.values(y_), times_.tau()});
    note_place();
  }
  std::ranges::copy(*gradient_, grad_f.begin());
}

void DesignProblem::note_place() const {
  const double of_branch = times_.branch_margin();
  if (of_branch < kLeastOfBranch || of_branch > kMostOfBranch) return;
  last_on_branch_ = y_;
  // Bounds of several coordinates together need not hold on the way.
  const Eigen::VectorXd rows = space_.row_values(y_);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const DesignSpace::Row& row = space_.rows()[static_cast<std::size_t>(i)];
    if (rows[i] < row.lower || rows[i] > row.upper) return;
  }
  if (times_.tau() >= least_tau_) return;
  least_tau_ = times_.tau();
  quickest_ = y_;
}

void DesignProblem::do_eval_g(std::span<double> g) const {
  std::ranges::copy(space_.row_values(y_), g.begin());
  if (num_margins_ > 0) {
    std::ranges::copy(times_.margins().head(num_margins_),
                      g.end() - num_margins_);
  }
}

void DesignProblem::do_eval_jac_g(std::span<double> values) const {
  const auto num_own = static_cast<Eigen::Index>(space_.rows().size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(
      num_constraints(), num_variables());
  rows.topRows(num_own) = space_.row_jacobian(y_);
  if (num_margins_ > 0) {
    if (!margin_rows_) {
      margin_rows_ = times_.margin_gradient(space_.moved_traits(y_))
                         .topRows(num_margins_) *
                     space_.traits_jacobian(y_);
    }
    rows.bottomRows(num_margins_) = *margin_rows_;
  }
  std::copy_n(rows.data(), rows.size(), values.begin());
}

}  // namespace brachisto
