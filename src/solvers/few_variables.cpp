// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/few_variables.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <optional>

#include "math/dense.hpp"

namespace brachisto {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using nlp::Held;

/// Gradient, rows and their Jacobian at a point.
struct Linearised {
  VectorXd gradient, values;
  MatrixXd jacobian;

  [[nodiscard]] VectorXd of_lagrangian(const VectorXd& lambda) const {
    return gradient + jacobian.transpose() * lambda;
  }
};

std::optional<Linearised> linearise(nlp::Problem& problem, const VectorXd& y) {
  const auto span = [](auto& vector) {
    return std::span(vector.data(), static_cast<std::size_t>(vector.size()));
  };
  if (!problem.set_point(span(y))) return std::nullopt;
  const int n = problem.num_variables(), m = problem.num_constraints();
  Linearised out{VectorXd(n), VectorXd(m), {}};
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(
      m, n);
  problem.eval_grad_f(span(out.gradient));
  problem.eval_g(span(out.values));
  problem.eval_jac_g(span(rows));
  out.jacobian = rows;
  return out;
}

/// Column i of the Hessian of the Lagrangian; one-sided where the problem is
/// not defined on the other side.
std::optional<VectorXd> hessian_column(nlp::Problem& problem,
                                       const Linearised& here,
                                       const VectorXd& y,
                                       const VectorXd& lambda, Eigen::Index i,
                                       double step) {
  const auto at = [&](double shift) -> std::optional<VectorXd> {
    VectorXd moved = y;
    moved[i] += shift;
    const auto there = linearise(problem, moved);
    if (!there) return std::nullopt;
    return there->of_lagrangian(lambda);
  };
  const auto above = at(step), below = at(-step);
  if (above && below) return (*above - *below) / (2.0 * step);
  const VectorXd middle = here.of_lagrangian(lambda);
  if (above) return (*above - middle) / step;
  if (below) return (middle - *below) / step;
  return std::nullopt;
}

VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(),
                                    static_cast<Eigen::Index>(values.size()));
}
std::vector<double> as_list(const VectorXd& values) {
  return {values.begin(), values.end()};
}

/// The held ones by index, the others by index.
struct Split {
  std::vector<Eigen::Index> free, held;
};
Split split(const std::vector<Held>& states) {
  Split out;
  for (std::size_t i = 0; i < states.size(); ++i) {
    (states[i] == Held::No ? out.free : out.held)
        .push_back(static_cast<Eigen::Index>(i));
  }
  return out;
}

double bound_of(const nlp::Range& range, Held held) {
  return held == Held::AtUpper ? range.upper : range.lower;
}

std::vector<double> eigenvalues_along(const MatrixXd& hessian,
                                      const MatrixXd& held_rows) {
  if (hessian.rows() == 0) return {};
  MatrixXd along = MatrixXd::Identity(hessian.rows(), hessian.rows());
  // An orthonormal basis, so that lengths stay what they are.
  if (held_rows.rows() > 0) along = math::orthonormal_kernel(held_rows);
  if (along.cols() == 0) return {};
  return as_list(math::eigenvalues(along.transpose() * hessian * along));
}

/// Lets go of what its multiplier pulls away from its bound. False if there is
/// nothing of the kind.
bool release(const nlp::Problem& problem, const PrimalDual& point,
             nlp::ActiveSet& active) {
  bool released = false;
  const auto let_go = [&](Held& held) {
    held = Held::No;
    released = true;
  };
  for (std::size_t i = 0; i < active.variables.size(); ++i) {
    if (point.z_lower[i] < 0.0 || point.z_upper[i] < 0.0) {
      let_go(active.variables[i]);
    }
  }
  for (std::size_t i = 0; i < active.constraints.size(); ++i) {
    const double lambda = point.lambda[i];
    Held& held = active.constraints[i];
    if (problem.constraint_range(static_cast<int>(i)).single()) continue;
    if ((held == Held::AtLower && lambda > 0.0) ||
        (held == Held::AtUpper && lambda < 0.0)) {
      let_go(held);
    }
  }
  return released;
}

/// Whether what is not held lies within its bounds, but for rounding.
bool within_bounds(const nlp::Problem& problem, const nlp::ActiveSet& active,
                   const VectorXd& y, const VectorXd& values) {
  constexpr double kRounding = 1e-12;
  const auto within = [](Held held, const nlp::Range& range, double value) {
    return held != Held::No || (value >= range.lower - kRounding &&
                                value <= range.upper + kRounding);
  };
  for (std::size_t i = 0; i < active.variables.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!within(active.variables[i], problem.variable_range(index), y[index])) {
      return false;
    }
  }
  for (std::size_t i = 0; i < active.constraints.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!within(active.constraints[i], problem.constraint_range(index),
                values[index])) {
      return false;
    }
  }
  return true;
}

/// With that held, from the point.
FewVariablesPoint refine(nlp::Problem& problem, PrimalDual start,
                         nlp::ActiveSet active, double step) {
  constexpr int kMostSteps = 6;
  constexpr double kAtRest = 1e-7;
  FewVariablesPoint out;
  out.active = std::move(active);
  const Split variables = split(out.active.variables);
  const Split rows = split(out.active.constraints);
  VectorXd y = as_vector(start.x), lambda = as_vector(start.lambda);
  for (const Eigen::Index i : variables.held) {
    y[i] = bound_of(problem.variable_range(static_cast<int>(i)),
                    out.active.variables[static_cast<std::size_t>(i)]);
  }
  for (const Eigen::Index i : rows.free) lambda[i] = 0.0;
  out.point = std::move(start);

  const auto num_free = static_cast<Eigen::Index>(variables.free.size());
  const auto num_rows = static_cast<Eigen::Index>(rows.held.size());
  std::optional<Linearised> here = linearise(problem, y);
  if (!here) return out;
  MatrixXd hessian(num_free, num_free);
  for (Eigen::Index j = 0; j < num_free; ++j) {
    const auto column =
        hessian_column(problem, *here, y, lambda,
                       variables.free[static_cast<std::size_t>(j)], step);
    if (!column) return out;
    hessian.col(j) = (*column)(variables.free);
  }
  hessian = (0.5 * (hessian + hessian.transpose())).eval();

  // [W Jᵀ; J 0] [Δy; λ] = −[∇f; c − b] on what is free and what is held.
  for (int count = 0; count < kMostSteps && here && !out.converged; ++count) {
    const MatrixXd jacobian = here->jacobian(rows.held, variables.free);
    MatrixXd kkt = MatrixXd::Zero(num_free + num_rows, num_free + num_rows);
    kkt.topLeftCorner(num_free, num_free) = hessian;
    kkt.bottomLeftCorner(num_rows, num_free) = jacobian;
    kkt.topRightCorner(num_free, num_rows) = jacobian.transpose();
    VectorXd right(num_free + num_rows);
    right.head(num_free) = -here->gradient(variables.free);
    for (Eigen::Index i = 0; i < num_rows; ++i) {
      const Eigen::Index row = rows.held[static_cast<std::size_t>(i)];
      right[num_free + i] =
          bound_of(problem.constraint_range(static_cast<int>(row)),
                   out.active.constraints[static_cast<std::size_t>(row)]) -
          here->values[row];
    }
    // Bounds may hold every variable: then no step is left to solve for.
    VectorXd change = right;
    if (change.size() > 0) change = math::solve_next_to_singular(kkt, right);
    if (!change.allFinite()) return out;
    y(variables.free) += change.head(num_free);
    lambda(rows.held) = change.tail(num_rows);
    here = linearise(problem, y);
    out.converged = here && change.head(num_free).norm() <= kAtRest;
  }
  if (!here) return out;
  out.curvatures =
      eigenvalues_along(hessian, here->jacobian(rows.held, variables.free));
  out.point.x = as_list(y);
  out.point.lambda = as_list(lambda);
  out.point.z_lower.assign(out.point.x.size(), 0.0);
  out.point.z_upper.assign(out.point.x.size(), 0.0);
  nlp::set_bound_multipliers(problem, out.active, out.point);
  out.converged =
      out.converged && within_bounds(problem, out.active, y, here->values);
  return out;
}

}  // namespace

FewVariablesPoint refine_few_variables(nlp::Problem& problem, PrimalDual start,
                                       double step) {
  FewVariablesPoint out;
  out.point = std::move(start);
  out.active = nlp::active_set(problem, out.point);
  // What is let go of is not held again.
  do {
    out = refine(problem, std::move(out.point), std::move(out.active), step);
  } while (out.converged && release(problem, out.point, out.active));
  return out;
}

}  // namespace brachisto
