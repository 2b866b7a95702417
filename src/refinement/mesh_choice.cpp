// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/mesh_choice.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/world_hamiltonian.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

namespace {

/// Degree to start with for a wanted relative error.
int starting_degree(double tolerance) {
  // One degree more for every two digits: elements stay about a tenth of a
  // turn of the body long.
  const double digits = -std::log10(tolerance);
  return std::clamp(static_cast<int>(std::lround(0.5 * digits + 0.5)), 2, 7);
}

}  // namespace

Mesh fixed_mesh(const Discretisation& wanted) {
  const int degree = wanted.degree_of_fixed();
  return uniform_mesh(degree, wanted.elements ? *wanted.elements
                                              : (*wanted.nodes - 1) / degree);
}

double largest_error_of_a_judge(double tolerance) {
  constexpr double kExact = 1e-11, kShare = 0.1;
  return std::min(kExact, kShare * tolerance);
}

Mesh first_mesh(const Discretisation& wanted, double tolerance,
                const ExtremalCurve& curve) {
  constexpr double kAim = 0.1;
  constexpr double kSize = 1.0;
  const double T = curve.transit_time();
  return equidistribute(
      curve.mesh(), element_errors(curve), kAim * tolerance * T,
      wanted.degree.value_or(starting_degree(tolerance)), kSize * T);
}

Mesh next_mesh(const MeshAnswer& answer, double tolerance,
               bool degree_is_fixed) {
  const Mesh& mesh = answer.problem.mesh();
  Mesh next = mesh;
  next.degree += 1;
  if (!answer.estimated_error) {
    // Nothing is known but that the mesh is too coarse.
    return uniform_mesh(mesh.degree, 2 * mesh.num_elements());
  }
  const double T = answer.finer->transit_time();
  if (!degree_is_fixed && next.degree <= kMaxDegree) {
    // The finer solution's own error, judged as the coarse one's was.
    if (3.0 * sum_of_errors(element_errors(*answer.finer)) / T <= tolerance)
      return next;
  }
  // Errors between fixed ends by element, scaled to the estimate, which knows
  // the contact too.
  const ExtremalCurve curve = answer.curve();
  std::vector<double> errors = element_errors(curve);
  const double sum = sum_of_errors(errors);
  const double scale = sum > 0.0 ? *answer.estimated_error * T / sum : 1.0;
  for (double& error : errors) error *= scale;
  constexpr double kSafety = 0.3;
  Mesh refined = equidistribute(mesh, errors, kSafety * tolerance * T);
  if (refined.num_elements() <= mesh.num_elements()) {
    // The order is not reached yet, or the error is rounding.
    refined = stretch(refined, mesh.num_elements() * 3 / 2 + 1);
  }
  return refined;
}

bool another_slope_is_faster(const ExtremalCurve& curve) {
  const Mesh& mesh = curve.mesh();
  for (int e = 0; e <= mesh.num_elements(); ++e) {
    const ExtremalPoint at = curve.at_node(e * mesh.degree);
    if (gain_of_other_directions(curve.scene(), at.state(), at.p, at.beta) >
        kAnotherSlope) {
      return true;
    }
  }
  return false;
}

}  // namespace brachisto
