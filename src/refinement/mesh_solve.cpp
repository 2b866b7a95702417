// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/mesh_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/newton_solver.hpp"
#include "transcription/contact_equation.hpp"

namespace brachisto {

namespace {

/// With polishing, the mismatch at which Newton's method takes over [rad]: its
/// first step leaves the square of it.
constexpr double kPolishedFrom = 1e-5;

/// A problem with its tangency condition, if there is one, at an end angle.
struct BetweenEnds {
  Transcription& problem;
  std::optional<ContactEquation> equation;

  BetweenEnds(Transcription& transcription, double phi, bool fixed)
      : problem(transcription) {
    problem.set_end_angle(phi);
    if (fixed || problem.scene().contact != Contact::Smooth) return;
    equation.emplace(problem).set_parameter(phi);
  }
  [[nodiscard]] ContactEquation* contact() {
    return equation ? &*equation : nullptr;
  }
  [[nodiscard]] double end_slope(const PrimalDual& point) {
    return problem.end_slope(point.x, point.lambda);
  }
  [[nodiscard]] double reachable(double tolerance, const PrimalDual& point) {
    return brachisto::reachable(tolerance, problem, point.x);
  }
  /// Newton's method, until rounding keeps the residual from falling.
  [[nodiscard]] NewtonResult newton(PrimalDual start, double phi,
                                    double tolerance,
                                    const MeshOptions& options) {
    NewtonOptions newton;
    newton.tolerance = tolerance;
    newton.to_rounding = true;
    newton.rounding = reachable(0.0, start);
    newton.linear_solver = options.ipopt.linear_solver;
    newton.stop = options.ipopt.stop;
    return NewtonSolver(problem, contact())
        .solve(std::move(start), phi, newton);
  }
};

bool solved_up_to_rounding(BetweenEnds& ends, const SolverResult& result) {
  if (result.status == Status::Solved) return true;
  if (result.status != Status::NotConverged &&
      result.status != Status::NotEvaluable) {
    return false;
  }
  if (result.point.x.empty() || !ends.problem.set_point(result.point.x)) {
    return false;
  }
  return nlp::kkt_residual(ends.problem, result.point).max() <=
         ends.reachable(kRoundingResidual, result.point);
}

void polish(BetweenEnds& ends, const MeshOptions& options,
            MeshSolution& solution) {
  NewtonResult result = ends.newton(solution.point, solution.tangency.phi,
                                    options.ipopt.tolerance, options);
  solution.polish = {result.iterations, result.first_residual, result.residual};
  if (result.residual >= result.first_residual) return;
  solution.point = std::move(result.point);
  solution.tangency.phi = result.phi;
  if (!ends.equation) return;
  solution.tangency.mismatch = ends.end_slope(solution.point) - result.phi;
}

}  // namespace

double reachable(double tolerance, const Transcription& problem,
                 std::span<const double> x) {
  return std::max(tolerance, problem.rounding(x));
}

MeshSolution stay_on_mesh(Transcription& problem, MeshStart start,
                          const MeshOptions& options) {
  BetweenEnds ends(problem, start.phi, options.fixed_ends);
  MeshSolution solution;
  const double tolerance = ends.reachable(options.ipopt.tolerance, start.point);
  NewtonResult result =
      ends.newton(std::move(start.point), start.phi, tolerance, options);
  solution.polish = {result.iterations, result.first_residual, result.residual};
  solution.point = std::move(result.point);
  solution.tangency.phi = result.phi;
  solution.tangency.slope = start.tangency_slope;
  if (ends.equation) {
    solution.tangency.mismatch = ends.end_slope(solution.point) - result.phi;
  }
  solution.tangency.closed =
      std::abs(solution.tangency.mismatch) <= TangencyOptions{}.loose_tolerance;
  solution.status =
      result.residual <= ends.reachable(kRoundingResidual, solution.point) &&
              solution.tangency.closed
          ? Status::Solved
          : Status::NotConverged;
  solution.message =
      solution.solved()
          ? "Newton's method: extremal found"
          : fmt::format("Newton's method stopped at a residual of {:.1e}",
                        result.residual);
  return solution;
}

MeshSolution solve_on_mesh(Transcription& problem, MeshStart start,
                           const MeshOptions& options) {
  if (options.newton_alone) {
    return stay_on_mesh(problem, std::move(start), options);
  }
  BetweenEnds ends(problem, start.phi, options.fixed_ends);
  const bool smooth = ends.equation.has_value();
  MeshSolution solution;
  solution.point = std::move(start.point);
  const auto pass = [&](double phi) -> std::optional<double> {
    if (smooth) ends.equation->set_parameter(phi);
    IpoptOptions ipopt = options.ipopt;
    ipopt.tolerance = ends.reachable(ipopt.tolerance, solution.point);
    ipopt.max_iterations =
        std::max(0, ipopt.max_iterations - solution.iterations);
    SolverResult result = solve_with_ipopt(ends.problem, solution.point, ipopt);
    if (solution.tangency.passes == 0) {
      solution.first_iterations = result.iterations;
      solution.refused_points = result.refused_points;
    }
    if (result.linear_solver != LinearSolver::Auto) {
      solution.linear_solver = result.linear_solver;
    }
    ++solution.tangency.passes;
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

  TangencyOptions tangency;
  tangency.initial_slope = start.tangency_slope;
  if (options.polish) tangency.tolerance = kPolishedFrom;
  if (smooth) {
    solution.tangency = close_contact(pass, start.phi, tangency);
    if (solution.tangency.closed && options.polish) {
      polish(ends, options, solution);
      solution.tangency.closed =
          std::abs(solution.tangency.mismatch) <= tangency.loose_tolerance;
    }
  } else {
    pass(start.phi);
    solution.tangency.phi = start.phi;
    solution.tangency.closed = solution.solved();
    if (solution.solved() && options.polish) {
      polish(ends, options, solution);
    }
  }
  if (solution.solved() && !solution.tangency.closed) {
    solution.status = Status::NotConverged;
    solution.message = fmt::format(
        "no end angle φ was found that reproduces itself: |β_end(φ) − φ| = "
        "{:.2e} at φ = "
        "{:.6g} rad after {} passes",
        std::abs(solution.tangency.mismatch), solution.tangency.phi,
        solution.tangency.passes);
  }
  return solution;
}

MeshSolution solve_near(Transcription& problem, MeshStart start,
                        MeshOptions options) {
  constexpr int kMostIterations = 60;
  options.ipopt.max_iterations =
      std::min(options.ipopt.max_iterations, kMostIterations);
  return solve_on_mesh(problem, std::move(start), options);
}

void take_instead(MeshSolution& left, MeshSolution stayed) {
  stayed.tangency.passes = left.tangency.passes;
  stayed.first_iterations = left.first_iterations;
  stayed.iterations = left.iterations;
  stayed.linear_solver = left.linear_solver;
  stayed.log = std::move(left.log);
  stayed.message +=
      "; Ipopt left it, so that it is not a minimum, or nearly none";
  left = std::move(stayed);
}

}  // namespace brachisto
