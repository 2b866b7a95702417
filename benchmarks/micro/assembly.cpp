// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The nonlinear program at a point: what its functions share, then the values
// of Jacobian and Hessian.

#include <cmath>
#include <utility>
#include <vector>

#include "micro/extremal_on_mesh.hpp"

namespace brachisto::benchmarks {

namespace {

/// A point, and one beside it: a problem does not evaluate the same one twice.
/// They differ by one unit of rounding in one unknown, so that they cost the
/// same.
class TwoPoints {
 public:
  explicit TwoPoints(const std::vector<double>& x) : now_(x), next_(x) {
    next_.back() = std::nextafter(next_.back(), 0.0);
  }
  /// Now the one, now the other.
  const std::vector<double>& another() {
    now_.swap(next_);
    return now_;
  }

 private:
  std::vector<double> now_, next_;
};

void set_point(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  TwoPoints points(at.point.x);
  for (auto _ : state) {
    if (!at.problem.set_point(points.another())) {
      state.SkipWithError("the problem refuses its solution");
      break;
    }
    benchmark::ClobberMemory();
  }
  per_node(state, at);
}

void constraints(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  std::vector<double> g(at.point.lambda.size());
  if (!at.problem.set_point(at.point.x)) return;
  for (auto _ : state) {
    at.problem.eval_g(g);
    benchmark::DoNotOptimize(g.data());
    benchmark::ClobberMemory();
  }
  per_node(state, at);
}

/// One point with Jacobian and Hessian, as an iteration of a solver has it.
void assembly(benchmark::State& state) {
  ExtremalOnMesh at = extremal_for(state);
  std::vector<double> jac(at.problem.jac_g_pattern().num_entries());
  std::vector<double> hess(at.problem.hess_lag_pattern().num_entries());
  TwoPoints points(at.point.x);
  for (auto _ : state) {
    if (!at.problem.set_point(points.another())) {
      state.SkipWithError("the problem refuses its solution");
      break;
    }
    at.problem.eval_jac_g(jac);
    at.problem.eval_hess_lag(1.0, at.point.lambda, hess);
    benchmark::DoNotOptimize(hess.data());
    benchmark::ClobberMemory();
  }
  per_node(state, at);
}

void sizes(benchmark::internal::Benchmark* one) {
  for (const int elements : {20, 200, 2'000, 20'000}) one->Arg(elements);
  one->Unit(benchmark::kMicrosecond)->Complexity();
}

BENCHMARK(set_point)->Apply(sizes);
BENCHMARK(constraints)->Apply(sizes);
BENCHMARK(assembly)->Apply(sizes);

}  // namespace

}  // namespace brachisto::benchmarks
