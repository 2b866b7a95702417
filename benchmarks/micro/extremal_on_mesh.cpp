// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "micro/extremal_on_mesh.hpp"

#include <stdexcept>

#include "solvers/newton_solver.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto::benchmarks {

namespace {

struct Coarse {
  ExtremalCurve curve;
  double phi;
};

Coarse solve_coarse() {
  constexpr double kPhi = -0.1;  // near that of the contact
  constexpr int kElements = 20;
  auto [problem, start] =
      testing::solved(testing::natural(testing::off_centred_scene()),
                      uniform_mesh(kMicroDegree, kElements), kPhi);
  ContactEquation contact(problem);
  const NewtonResult result =
      NewtonSolver(problem, &contact).solve(start, kPhi, {});
  if (result.status != Status::Solved) {
    throw std::runtime_error("the reference case was not solved");
  }
  return {ExtremalCurve(problem, result.point), result.phi};
}

}  // namespace

ExtremalOnMesh extremal_on_mesh(int elements) {
  static const Coarse coarse = solve_coarse();
  RollingTime problem(coarse.curve.scene(),
                      uniform_mesh(kMicroDegree, elements), coarse.phi);
  PrimalDual point = prolong(coarse.curve, problem);
  return {std::move(problem), std::move(point), coarse.phi};
}

ExtremalOnMesh extremal_for(const benchmark::State& state) {
  return extremal_on_mesh(static_cast<int>(state.range(0)));
}

void per_node(benchmark::State& state, const ExtremalOnMesh& at) {
  using benchmark::Counter;
  state.counters["per_node"] = Counter(
      at.nodes(), Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["nodes"] = at.nodes();
  state.SetComplexityN(at.nodes());
}

}  // namespace brachisto::benchmarks
