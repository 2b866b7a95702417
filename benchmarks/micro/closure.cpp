// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The smooth contact: the end of the path is moved by 10⁻³ rad, and the
// extremal follows.

#include "brachisto/solvers/program_solvers.hpp"
#include "micro/extremal_on_mesh.hpp"
#include "solvers/newton_solver.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/costates.hpp"

namespace brachisto::benchmarks {

namespace {

constexpr double kMoved = 1e-3;  // [rad]

/// One pass of the iteration for φ: the program between fixed ends, from the
/// solution for another φ, and the slope at its end.
void closure_pass(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  ContactEquation contact(at.problem);
  contact.set_parameter(at.phi + kMoved);
  int iterations = 0;
  for (auto _ : state) {
    const SolverResult result = solve_with_ipopt(at.problem, at.point, {});
    if (result.status != Status::Solved) {
      state.SkipWithError(result.message.c_str());
      break;
    }
    iterations = result.iterations;
    benchmark::DoNotOptimize(
        at.problem.end_slope(result.point.x, result.point.lambda));
  }
  state.counters["iterations"] = iterations;
  per_node(state, at);
}

/// The whole tangency by Newton's method on extremal and contact together.
void closure_by_newton(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  ContactEquation contact(at.problem);
  int iterations = 0;
  for (auto _ : state) {
    const NewtonResult result =
        NewtonSolver(at.problem, &contact).solve(at.point, at.phi + kMoved, {});
    if (result.status != Status::Solved) {
      state.SkipWithError("Newton's method does not converge");
      break;
    }
    iterations = result.iterations;
  }
  state.counters["iterations"] = iterations;
  per_node(state, at);
}

void sizes(benchmark::internal::Benchmark* one) {
  for (const int elements : {4, 20, 200, 2'000}) one->Arg(elements);
  one->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
}

BENCHMARK(closure_pass)->Apply(sizes);
BENCHMARK(closure_by_newton)->Apply(sizes);

}  // namespace

}  // namespace brachisto::benchmarks
