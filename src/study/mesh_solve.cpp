// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/mesh_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "brachisto/model/contact.hpp"
#include "brachisto/nlp/kkt_residual.hpp"
#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/transcription/contact_equation.hpp"

namespace brachisto {

namespace {

bool solved_up_to_rounding(const FixedEnds& ends, const SolverResult& result) {
  if (result.status == Status::Solved) return true;
  if (result.status != Status::NotConverged &&
      result.status != Status::NotEvaluable) {
    return false;
  }
  if (result.point.x.empty() || !ends.problem.set_point(result.point.x)) {
    return false;
  }
  return nlp::kkt_residual(ends.problem, result.point).max() <=
         ends.reachable(ends.rounding_residual, result.point);
}

void polish(const FixedEnds& ends, const MeshOptions& options,
            MeshSolution& solution) {
  NewtonOptions newton;
  newton.tolerance = options.ipopt.tolerance;
  newton.to_rounding = true;
  newton.rounding = ends.reachable(0.0, solution.point);
  newton.linear_solver = options.ipopt.linear_solver;
  newton.stop = options.ipopt.stop;
  NewtonResult result = solve_with_newton(
      ends.problem, ends.contact, solution.point, solution.closure.phi, newton);
  solution.polish = {result.iterations, result.first_residual, result.residual};
  if (result.residual >= result.first_residual) return;
  solution.point = std::move(result.point);
  solution.closure.phi = result.phi;
  if (ends.contact == nullptr) return;
  solution.closure.mismatch = ends.end_slope(solution.point) - result.phi;
}

}  // namespace

double reachable(double tolerance, const PrimalDual& point) {
  constexpr double kTerms = 64.0;
  double largest = 1.0;
  for (const double x : point.x) largest = std::max(largest, std::abs(x));
  return std::max(tolerance,
                  kTerms * std::numeric_limits<double>::epsilon() * largest);
}

double rounding_of_ends(const Scene& scene, double phi, double p_x,
                        double p_z) {
  constexpr double kRoundings = 16.0;
  const Point start = start_of_centre(scene);
  const Point end = end_of_centre(scene, phi);
  const double largest =
      std::max({std::abs(start.x), std::abs(start.z), std::abs(end.x),
                std::abs(end.z), scene.L, scene.H});
  const double per_radian =
      scene.contact == Contact::Smooth ? scene.body.radius : 0.0;
  return kRoundings * std::numeric_limits<double>::epsilon() * largest *
         (1.0 + per_radian) * std::hypot(p_x, p_z);
}

namespace {

/// Calls `solve` with a problem in the rolling time as one of fixed ends.
template <class Solve>
MeshSolution with_fixed_ends(RollingTime& problem, double phi, Solve&& solve) {
  problem.set_end_angle(phi);
  std::optional<ContactEquation> contact;
  if (problem.scene().contact == Contact::Smooth) contact.emplace(problem);
  const auto slope_at_end = [&](const PrimalDual& point) {
    return end_slope(problem, point.x,
                     costates(problem, point.x, point.lambda));
  };
  return solve(FixedEnds{problem, contact ? &*contact : nullptr, slope_at_end,
                         reachable});
}

}  // namespace

MeshSolution solve_on_mesh(RollingTime& problem, const MeshStart& start,
                           const MeshOptions& options) {
  return with_fixed_ends(problem, start.phi, [&](const FixedEnds& ends) {
    return solve_between(ends, start, options);
  });
}

MeshSolution stay_on_mesh(RollingTime& problem, const MeshStart& start,
                          const MeshOptions& options) {
  return with_fixed_ends(problem, start.phi, [&](const FixedEnds& ends) {
    return stay_between(ends, start, options);
  });
}

MeshSolution stay_between(const FixedEnds& ends, const MeshStart& start,
                          const MeshOptions& options) {
  MeshSolution solution;
  NewtonOptions newton;
  newton.tolerance = ends.reachable(options.ipopt.tolerance, start.point);
  newton.to_rounding = true;
  newton.rounding = ends.reachable(0.0, start.point);
  newton.linear_solver = options.ipopt.linear_solver;
  newton.stop = options.ipopt.stop;
  if (ends.contact != nullptr) ends.contact->set_parameter(start.phi);
  NewtonResult result = solve_with_newton(ends.problem, ends.contact,
                                          start.point, start.phi, newton);
  solution.polish = {result.iterations, result.first_residual, result.residual};
  solution.point = std::move(result.point);
  solution.closure.phi = result.phi;
  solution.closure.slope = start.closure_slope;
  if (ends.contact != nullptr) {
    solution.closure.mismatch = ends.end_slope(solution.point) - result.phi;
  }
  solution.closure.closed =
      std::abs(solution.closure.mismatch) <= options.closure.loose_tolerance;
  solution.status = result.residual <= ends.reachable(ends.rounding_residual,
                                                      solution.point) &&
                            solution.closure.closed
                        ? Status::Solved
                        : Status::NotConverged;
  solution.message =
      solution.solved()
          ? "Newton's method: extremal found"
          : fmt::format("Newton's method stopped at a residual of {:.1e}",
                        result.residual);
  return solution;
}

MeshSolution solve_between(const FixedEnds& ends, const MeshStart& start,
                           const MeshOptions& options) {
  if (options.newton_alone) return stay_between(ends, start, options);
  const bool smooth = ends.contact != nullptr;
  MeshSolution solution;
  solution.point = start.point;
  const auto pass = [&](double phi) -> std::optional<double> {
    if (smooth) ends.contact->set_parameter(phi);
    IpoptOptions ipopt = options.ipopt;
    ipopt.tolerance = ends.reachable(ipopt.tolerance, solution.point);
    ipopt.max_iterations =
        std::max(0, ipopt.max_iterations - solution.iterations);
    SolverResult result = solve_with_ipopt(ends.problem, solution.point, ipopt);
    if (solution.closure.passes == 0) {
      solution.first_iterations = result.iterations;
      solution.refused_points = result.refused_points;
    }
    if (result.linear_solver != LinearSolver::Auto) {
      solution.linear_solver = result.linear_solver;
    }
    ++solution.closure.passes;
    solution.iterations += result.iterations;
    solution.log += result.log;
    solution.message = result.message;
    if (!solved_up_to_rounding(ends, result)) {
      solution.status = result.status;
      return std::nullopt;
    }
    solution.status = Status::Solved;
    solution.point = std::move(result.point);
    return ends.end_slope(solution.point);
  };

  ClosureOptions closure = options.closure;
  closure.initial_slope = start.closure_slope;
  if (options.polish) closure.tolerance = kPolishedFrom;
  if (smooth) {
    const double final_tolerance = options.closure.loose_tolerance;
    solution.closure = close_contact(pass, start.phi, closure);
    if (solution.closure.closed && options.polish) {
      polish(ends, options, solution);
      solution.closure.closed =
          std::abs(solution.closure.mismatch) <= final_tolerance;
    }
  } else {
    pass(start.phi);
    solution.closure.phi = start.phi;
    solution.closure.closed = solution.solved();
    if (solution.solved() && options.polish) {
      polish(ends, options, solution);
    }
  }
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
