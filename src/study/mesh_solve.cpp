// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/mesh_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/nlp/kkt_residual.hpp"

namespace brachisto {

namespace {

bool solved_up_to_rounding(RollingTime& problem, const SolverResult& result) {
  if (result.status == Status::Solved) return true;
  if (result.status != Status::NotConverged &&
      result.status != Status::NotEvaluable) {
    return false;
  }
  if (result.point.x.empty() || !problem.set_point(result.point.x)) {
    return false;
  }
  return nlp::kkt_residual(problem, result.point.x, result.point.lambda)
             .max() <= kRoundingResidual;
}

}  // namespace

MeshSolution solve_on_mesh(RollingTime& problem, const MeshStart& start,
                           const MeshOptions& options) {
  MeshSolution solution;
  solution.point = start.point;
  const auto pass = [&](double phi) -> std::optional<double> {
    problem.set_end_angle(phi);
    IpoptOptions ipopt = options.ipopt;
    ipopt.max_iterations =
        std::max(0, ipopt.max_iterations - solution.iterations);
    SolverResult result = solve_with_ipopt(problem, solution.point, ipopt);
    if (solution.closure.passes == 0) {
      solution.first_iterations = result.iterations;
      solution.refused_points = result.refused_points;
    }
    ++solution.closure.passes;
    solution.iterations += result.iterations;
    solution.log += result.log;
    solution.message = result.message;
    if (!solved_up_to_rounding(problem, result)) {
      solution.status = result.status;
      return std::nullopt;
    }
    solution.status = Status::Solved;
    solution.point = std::move(result.point);
    return end_slope(
        problem, solution.point.x,
        costates(problem, solution.point.x, solution.point.lambda));
  };

  if (problem.scene().contact == Contact::Centre) {
    pass(start.phi);
    solution.closure.phi = start.phi;
    solution.closure.closed = solution.solved();
    return solution;
  }
  ClosureOptions closure = options.closure;
  closure.initial_slope = start.closure_slope;
  solution.closure = close_contact(pass, start.phi, closure);
  if (solution.solved() && !solution.closure.closed) {
    solution.status = Status::NotConverged;
    solution.message = fmt::format(
        "no end angle φ reproduces itself: |β_end(φ) − φ| = {:.2e} at φ = "
        "{:.6g} rad after {} passes",
        std::abs(solution.closure.mismatch), solution.closure.phi,
        solution.closure.passes);
  }
  return solution;
}

}  // namespace brachisto
