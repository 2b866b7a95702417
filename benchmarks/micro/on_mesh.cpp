// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The reference case to 1e-12 on a mesh that is given: the program, its
// solution by Newton's method with the contact, and the least time.

#include <stdexcept>

#include "micro/extremal_on_mesh.hpp"
#include "model/cycloid.hpp"
#include "refinement/mesh_solve.hpp"
#include "support/scenes.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto::benchmarks {

namespace {

/// The cheapest uniform mesh whose T is good to 1e-12.
Mesh mesh() {
  constexpr int kDegree = 4;
  constexpr int kElements = 32;
  return uniform_mesh(kDegree, kElements);
}

MeshOptions newton_alone() {
  MeshOptions options;
  options.newton_alone = true;
  return options;
}

double transit_time(RollingTime& problem, const MeshStart& start) {
  const MeshSolution found = solve_on_mesh(problem, start, newton_alone());
  if (!found.solved()) throw std::runtime_error(found.message);
  return ExtremalCurve(problem, found.point).transit_time();
}

void on_mesh_from_cycloid(benchmark::State& state) {
  const Scene scene = testing::natural(testing::off_centred_scene());
  for (auto _ : state) {
    const auto arc = axisymmetric_optimum(scene);
    const double phi = arc->slope_angle(arc->psi_end);
    RollingTime problem(scene, mesh(), phi);
    benchmark::DoNotOptimize(
        transit_time(problem, {cycloid_extremal(problem, *arc), phi, -1.0}));
  }
}

/// From a solution on another mesh whose T is good to nine digits.
void on_mesh_from_another(benchmark::State& state) {
  constexpr int kElements = 20;
  const ExtremalOnMesh other = extremal_on_mesh(kElements);
  const ExtremalCurve curve(other.problem, other.point);
  for (auto _ : state) {
    RollingTime problem(curve.scene(), mesh(), other.phi);
    benchmark::DoNotOptimize(
        transit_time(problem, {prolong(curve, problem), other.phi, -1.0}));
  }
}

BENCHMARK(on_mesh_from_cycloid)->Unit(benchmark::kMicrosecond);
BENCHMARK(on_mesh_from_another)->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace brachisto::benchmarks
