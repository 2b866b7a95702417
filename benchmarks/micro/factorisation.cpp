// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The KKT matrix at the solution, factorised by the chain and by sparse LU.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "micro/extremal_on_mesh.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/kkt_system.hpp"
#include "solvers/sparse_lu.hpp"

namespace brachisto::benchmarks {

namespace {

/// Values of Hessian and Jacobian at the solution.
struct Values {
  explicit Values(ExtremalOnMesh& at)
      : hess(at.problem.hess_lag_pattern().num_entries()),
        jac(at.problem.jac_g_pattern().num_entries()) {
    if (!at.problem.set_point(at.point.x)) return;
    at.problem.eval_hess_lag(1.0, at.point.lambda, hess);
    at.problem.eval_jac_g(jac);
  }
  std::vector<double> hess, jac;
};

void chain_factorisation(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  const Values values(at);
  const std::array<std::span<const double>, 2> both = {values.hess, values.jac};
  const auto chain =
      make_chain_ldlt(at.problem, nlp::equations_only(at.problem));
  for (auto _ : state) {
    if (!chain->factorise(both)) {
      state.SkipWithError("singular");
      break;
    }
    benchmark::ClobberMemory();
  }
  per_node(state, at);
}

void chain_solution(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  const Values values(at);
  const std::array<std::span<const double>, 2> both = {values.hess, values.jac};
  const auto chain =
      make_chain_ldlt(at.problem, nlp::equations_only(at.problem));
  if (!chain->factorise(both)) state.SkipWithError("singular");
  std::vector<double> x(at.point.x.size() + at.point.lambda.size(), 1.0);
  for (auto _ : state) {
    // Of the same size again and again, or it would run out of range.
    std::ranges::fill(x, 1.0);
    chain->solve(x);
    benchmark::DoNotOptimize(x.data());
  }
  per_node(state, at);
}

/// As Newton's method has it where there is no chain; pattern analysed before.
void sparse_lu_factorisation(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  KktSystem system(at.problem, nullptr, nlp::equations_only(at.problem));
  if (!system.evaluate(at.point.x, at.point.lambda, at.phi)) return;
  system.evaluate_jacobian();
  std::vector<double> values;
  system.jacobian(values);
  SparseLu lu(system.pattern(), system.elimination_order());
  for (auto _ : state) {
    if (!lu.factorise(values)) {
      state.SkipWithError("singular");
      break;
    }
    benchmark::ClobberMemory();
  }
  per_node(state, at);
}

void sizes(benchmark::internal::Benchmark* one) {
  for (const int elements : {20, 200, 2'000, 20'000}) one->Arg(elements);
  one->Unit(benchmark::kMicrosecond)->Complexity();
}

BENCHMARK(chain_factorisation)->Apply(sizes);
BENCHMARK(chain_solution)->Apply(sizes);
BENCHMARK(sparse_lu_factorisation)->Apply(sizes);

}  // namespace

}  // namespace brachisto::benchmarks
