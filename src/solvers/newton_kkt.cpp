// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/newton_kkt.hpp"

#include <cmath>
#include <limits>

#include "solvers/kkt_system.hpp"
#include "solvers/sparse_lu.hpp"

namespace brachisto {

namespace {

/// x, λ and φ in one vector.
struct Iterate {
  PrimalDual point;
  double phi;

  [[nodiscard]] Iterate moved(std::span<const double> step, double by,
                              bool has_phi) const {
    Iterate out = *this;
    std::size_t i = 0;
    for (double& value : out.point.x) value += by * step[i++];
    for (double& value : out.point.lambda) value += by * step[i++];
    if (has_phi) out.phi += by * step[i];
    return out;
  }
};

}  // namespace

NewtonResult solve_with_newton(nlp::Problem& problem,
                               nlp::ClosingEquation* closing,
                               const PrimalDual& start, double phi,
                               const NewtonOptions& options) {
  NewtonResult result;
  result.point = start;
  result.phi = phi;
  KktSystem system(problem, closing);
  Iterate now{start, phi};
  if (!system.evaluate(now.point.x, now.point.lambda, now.phi)) {
    result.status = Status::NotEvaluable;
    result.first_residual = result.residual =
        std::numeric_limits<double>::infinity();
    return result;
  }
  double residual = system.max_residual();
  result.first_residual = result.residual = residual;
  SparseLu lu(system.pattern(), system.elimination_order());

  while (result.iterations < options.max_iterations) {
    if (residual <= options.tolerance && !options.to_rounding) break;
    if (residual == 0.0 || !std::isfinite(residual)) break;
    if (options.stop.met()) {
      result.status =
          options.stop.interrupted() ? Status::Interrupted : Status::TimeLimit;
      return result;
    }
    const bool regular = lu.factorise(system.jacobian());
    result.determinant_sign = lu.determinant_sign();
    if (!regular) break;
    std::vector<double> rhs(system.residual().begin(), system.residual().end());
    for (double& value : rhs) value = -value;
    const std::vector<double> step = lu.solve(rhs);
    ++result.iterations;

    // The first of the full, halved, … steps that makes the residual fall.
    bool moved = false;
    double by = 1.0;
    for (int halving = 0; halving <= options.max_halvings; ++halving) {
      const Iterate trial = now.moved(step, by, closing != nullptr);
      if (system.evaluate(trial.point.x, trial.point.lambda, trial.phi) &&
          system.max_residual() < residual) {
        moved = system.max_residual() <= 0.5 * residual ||
                residual > options.tolerance;
        residual = system.max_residual();
        now = trial;
        result.point = now.point;
        result.phi = now.phi;
        result.residual = residual;
        break;
      }
      // Below the tolerance a step that does not help is rounding.
      if (residual <= options.tolerance) break;
      by *= 0.5;
    }
    if (!moved) break;
  }
  if (closing != nullptr) closing->set_parameter(result.phi);
  if (result.residual <= options.tolerance) result.status = Status::Solved;
  return result;
}

}  // namespace brachisto
