// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// All checks of a solution.

#include "micro/extremal_on_mesh.hpp"
#include "solvers/newton_solver.hpp"
#include "trajectory/certify.hpp"
#include "transcription/contact_equation.hpp"

namespace brachisto::benchmarks {

namespace {

void certificate(benchmark::State& state) {
  constexpr double kError = 1e-10;  // that of the coarsest mesh here, at most
  ExtremalOnMesh at = extremal_for(state);
  ContactEquation contact(at.problem);
  const NewtonResult solved =
      NewtonSolver(at.problem, &contact).solve(at.point, at.phi, {});
  bool verified = true;
  for (auto _ : state) {
    verified = certify(at.problem, solved.point, solved.phi, kError).verified();
  }
  if (!verified) state.SkipWithError("not verified");
  per_node(state, at);
}
BENCHMARK(certificate)
    ->Arg(20)
    ->Arg(200)
    ->Arg(2'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

}  // namespace

}  // namespace brachisto::benchmarks
