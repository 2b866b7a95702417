// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// One place on the path: the Lagrangian there with its derivatives.

#include <vector>

#include "micro/extremal_on_mesh.hpp"
#include "model/hamiltonian.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto::benchmarks {

namespace {

std::vector<ExtremalPoint> places() {
  constexpr int kElements = 20;
  const ExtremalOnMesh at = extremal_on_mesh(kElements);
  const ExtremalCurve curve(at.problem, at.point);
  std::vector<ExtremalPoint> out;
  for (int node = 0; node < at.nodes(); ++node) {
    out.push_back(curve.at_node(node));
  }
  return out;
}

/// √A + p·f as a function of β, with its first two derivatives.
void slope_hamiltonian_point(benchmark::State& state) {
  const Scene scene = extremal_on_mesh(1).problem.scene();
  const std::vector<ExtremalPoint> all = places();
  std::size_t i = 0;
  for (auto _ : state) {
    const ExtremalPoint& at = all[i];
    benchmark::DoNotOptimize(slope_hamiltonian(
        scene.body, scene.gravity, {at.theta, at.w}, at.p, at.beta));
    i = i + 1 < all.size() ? i + 1 : 0;
  }
}
BENCHMARK(slope_hamiltonian_point);

/// The slope that makes 𝓗 minimal, by Newton's method from a slope beside it.
void minimising_slope_point(benchmark::State& state) {
  constexpr double kBeside = 1e-2;  // [rad]
  const Scene scene = extremal_on_mesh(1).problem.scene();
  const std::vector<ExtremalPoint> all = places();
  std::size_t i = 0;
  for (auto _ : state) {
    const ExtremalPoint& at = all[i];
    benchmark::DoNotOptimize(minimising_slope(
        scene.body, scene.gravity, {at.theta, at.w}, at.p, at.beta + kBeside));
    i = i + 1 < all.size() ? i + 1 : 0;
  }
}
BENCHMARK(minimising_slope_point);

}  // namespace

}  // namespace brachisto::benchmarks
