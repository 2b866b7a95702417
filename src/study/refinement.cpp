// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/transcription/extremal_curve.hpp"
#include "brachisto/transcription/mesh.hpp"

namespace brachisto {

namespace {

constexpr int kMaxMeshes = 12;
// A mesh of so many elements that cannot be solved on is not too coarse.
constexpr int kLargestDoubled = 2000;

/// The mesh on which `curve` promises the wanted error, at the degree to start
/// with.
Mesh first_mesh(const Discretisation& wanted, double tolerance,
                const ExtremalCurve& curve) {
  constexpr double kAim = 0.1;
  constexpr double kSize = 1.0;
  const double T = curve.transit_time();
  return equidistribute(
      curve.mesh(), element_errors(curve), kAim * tolerance * T,
      wanted.degree.value_or(starting_degree(tolerance)), kSize * T);
}

Mesh fixed_mesh(const Discretisation& wanted) {
  const int degree = wanted.degree_of_fixed();
  return uniform_mesh(degree, wanted.elements ? *wanted.elements
                                              : (*wanted.nodes - 1) / degree);
}

std::string progress_text(const MeshSolution& solution,
                          const std::optional<double>& error) {
  if (!solution.solved()) return solution.message;
  return fmt::format(
      "{} iterations in {} passes, {} Newton steps, error of T {}",
      solution.iterations, solution.closure.passes,
      solution.polish.newton_steps,
      error ? fmt::format("{:.1e}", *error) : "unknown");
}

/// answer_on_mesh(), booked in `out` and in the budget.
MeshAnswer booked_answer(const Scene& scene, const Mesh& mesh,
                         const ExtremalCurve& curve, double phi,
                         MeshOptions& options, const MeshAnswer* coarser,
                         Refinement& out) {
  const std::string name =
      fmt::format("mesh {} × {}", mesh.degree, mesh.num_elements());
  if (options.progress) options.progress(name, "solving");
  MeshAnswer answer = answer_on_mesh(scene, mesh, curve, phi, options, coarser);
  const MeshSolution& solution = answer.solution;
  book(answer.problem, solution, answer.estimated_error, options, out);
  if (options.progress) {
    options.progress(name, progress_text(solution, answer.estimated_error));
  }
  return answer;
}

/// Whether the error of a large mesh can be judged by this answer of a coarser
/// one, because it is exact already but for rounding: then degree p + 1 would
/// only cost time and memory.
bool judges(const MeshAnswer& coarser, double tolerance) {
  constexpr double kExact = 1e-11;
  constexpr double kShare = 0.1;
  return coarser.estimated_error &&
         *coarser.estimated_error <= std::min(kExact, kShare * tolerance);
}

/// The answer of a much coarser mesh for a large one to start from.
std::optional<MeshAnswer> coarser_answer(const Scene& scene, const Mesh& mesh,
                                         const ExtremalCurve& curve, double phi,
                                         MeshOptions& options,
                                         Refinement& out) {
  constexpr int kManyElements = 4000;
  constexpr int kTimesCoarser = 8;
  constexpr int kEnoughElements = 5000;
  if (mesh.num_elements() < kManyElements) return std::nullopt;
  const int elements =
      std::min(mesh.num_elements() / kTimesCoarser, kEnoughElements);
  MeshAnswer answer = booked_answer(scene, uniform_mesh(mesh.degree, elements),
                                    curve, phi, options, nullptr, out);
  if (!answer.solution.solved()) return std::nullopt;
  return answer;
}

}  // namespace

void book(const Transcription& problem, const MeshSolution& solution,
          const std::optional<double>& error, MeshOptions& options,
          RefinementProtocol& out) {
  const Mesh& mesh = problem.mesh();
  out.meshes.push_back({mesh.degree, mesh.num_elements(), error,
                        solution.closure.passes, solution.first_iterations,
                        solution.iterations, solution.polish.newton_steps,
                        solution.linear_solver});
  out.log += solution.log;
  out.status = solution.status;
  out.message = solution.message;
  options.ipopt.max_iterations =
      std::max(0, options.ipopt.max_iterations - solution.iterations);
}

bool too_coarse(const MeshSolution& solution) {
  return solution.status == Status::NotConverged ||
         solution.status == Status::NotEvaluable;
}

Refinement refine(const Scene& scene, const Discretisation& wanted,
                  const ExtremalCurve& curve, double phi, MeshOptions options) {
  Refinement out;
  const double tolerance = wanted.tolerance.value_or(kDefaultTolerance);
  const int max_meshes = wanted.fixed() ? 1 : kMaxMeshes;
  Mesh mesh = wanted.fixed() ? fixed_mesh(wanted)
                             : first_mesh(wanted, tolerance, curve);
  ExtremalCurve from = curve;
  double from_phi = phi;
  std::optional<MeshAnswer> coarser;
  if (wanted.fixed()) {
    coarser = coarser_answer(scene, mesh, curve, phi, options, out);
    if (coarser) {
      from = coarser->curve();
      from_phi = coarser->solution.closure.phi;
    }
  }
  for (int i = 0; i < max_meshes; ++i) {
    MeshAnswer answer = booked_answer(
        scene, mesh, from, from_phi, options,
        coarser && judges(*coarser, tolerance) ? &*coarser : nullptr, out);
    const MeshSolution& solution = answer.solution;
    if (options.ipopt.stop.met()) break;
    if (!solution.solved()) {
      if (!too_coarse(solution) || mesh.num_elements() > kLargestDoubled) break;
      mesh = stretch(mesh, 2 * mesh.num_elements());
      continue;
    }

    const bool improved =
        !out.answer || !out.answer->estimated_error ||
        (answer.estimated_error &&
         *answer.estimated_error < *out.answer->estimated_error);
    // Once finer meshes only get worse, rounding has the last word.
    if (!improved) break;
    out.answer.emplace(std::move(answer));
    const MeshAnswer& best = *out.answer;
    if (best.estimated_error && *best.estimated_error <= tolerance) break;
    if (i + 1 == max_meshes) break;
    mesh = next_mesh(best, tolerance, wanted.degree.has_value());
    from = best.finer ? *best.finer : best.curve();
    from_phi = best.finer ? best.finer_phi : best.solution.closure.phi;
  }
  return out;
}

}  // namespace brachisto
