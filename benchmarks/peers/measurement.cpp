// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "peers/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "math/cpu_clock.hpp"
#include "peers/nl_program.hpp"
#include "program_files/nl_numbering.hpp"
#include "program_files/program_in_formulas.hpp"
#include "support/peak_memory.hpp"

namespace brachisto::benchmarks {

namespace {

/// On residuals, as each solver measures them.
constexpr double kTolerance = 1e-10;
constexpr int kMostIterations = 100;

/// What Newton's method found, in the words of the others.
SolverResult by_newton(nlp::Problem& problem, const PrimalDual& start) {
  NewtonOptions options;
  options.tolerance = kTolerance;
  options.max_iterations = kMostIterations;
  options.linear_solver = LinearSolver::Chain;
  NewtonResult found = solve_with_newton(problem, start, options);
  SolverResult result;
  result.status = found.status;
  result.point = std::move(found.point);
  result.iterations = found.iterations;
  return result;
}

SolverResult by_ipopt_and_chain(nlp::Problem& problem,
                                const PrimalDual& start) {
  IpoptOptions options;
  options.tolerance = kTolerance;
  options.max_iterations = kMostIterations;
  options.linear_solver = LinearSolver::Chain;
  return solve_with_ipopt(problem, start, options);
}

/// ∇²(f + λᵀg) v, v_i from `direction(i)`.
template <class Direction>
std::vector<double> times_hessian(nlp::Problem& problem,
                                  const PrimalDual& point,
                                  Direction direction) {
  if (!problem.set_point(point.x)) {
    throw std::runtime_error(problem.refusal());
  }
  const nlp::SparsityPattern& pattern = problem.hess_lag_pattern();
  std::vector<double> values(pattern.num_entries());
  problem.eval_hess_lag(1.0, point.lambda, values);
  std::vector<double> product(point.x.size());
  pattern.for_each([&](std::size_t entry, int row, int col) {
    product[static_cast<std::size_t>(row)] += values[entry] * direction(col);
    if (row == col) return;
    product[static_cast<std::size_t>(col)] += values[entry] * direction(row);
  });
  return product;
}

}  // namespace

Record measure(const ReferenceCase& reference, const Way& way, int nodes,
               const std::filesystem::path& nl_file,
               const MumpsOptions& mumps) {
  const double begun = process_cpu_seconds();
  std::unique_ptr<nlp::Problem> problem;
  PrimalDual start;
  if (way.peer == Peer::IpoptMumpsNl) {
    NlProgram read = read_nl_file(nl_file);
    problem = std::move(read.problem);
    start = std::move(read.start);
  } else {
    PeerProgram made(reference, way.formulation, nodes);
    problem = std::move(made.problem);
    start = std::move(made.start);
  }
  const double made = process_cpu_seconds();
  const double evaluated = phase_seconds().of(Phase::Evaluation);
  const SolverResult result =
      way.peer == Peer::NewtonChain ? by_newton(*problem, start)
      : way.peer == Peer::IpoptChain
          ? by_ipopt_and_chain(*problem, start)
          : solve_with_mumps(*problem, start, kTolerance, kMostIterations,
                             mumps);
  Record record{};
  record.solve_seconds = process_cpu_seconds() - made;
  record.made_seconds = made - begun;
  record.evaluation_seconds = phase_seconds().of(Phase::Evaluation) - evaluated;
  record.gigabytes = peak_gigabytes();
  record.solved = result.status == Status::Solved;
  record.variables = problem->num_variables();
  record.iterations = result.iterations;
  if (!problem->set_point(result.point.x)) {
    throw std::runtime_error(problem->refusal());
  }
  record.error = problem->eval_f() * reference.time_unit / reference.tau - 1.0;
  record.residual =
      nlp::kkt_residual(*problem, result.point, [](int) { return 1.0; }).max();
  return record;
}

double difference_of_hessians(const ReferenceCase& reference,
                              Formulation formulation, int nodes,
                              const std::filesystem::path& nl_file) {
  const PeerProgram ours(reference, formulation, nodes);
  const auto formulas = program_files::in_formulas(*ours.problem);
  const program_files::NlNumbering order(*ours.problem, *formulas);
  const NlProgram theirs = read_nl_file(nl_file);
  const auto direction = [](int i) { return std::cos(7.0 * i); };
  const std::vector<double> here =
      times_hessian(*ours.problem, ours.start, direction);
  const std::vector<double> there =
      times_hessian(*theirs.problem, theirs.start, [&](int i) {
        return direction(order.variables[static_cast<std::size_t>(i)]);
      });
  double worst = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const double expected = here[static_cast<std::size_t>(order.variables[i])];
    worst = std::max(worst, std::abs(there[i] - expected));
    largest = std::max(largest, std::abs(expected));
  }
  return worst / largest;
}

}  // namespace brachisto::benchmarks
