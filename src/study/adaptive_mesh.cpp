// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/adaptive_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/transcription/contact_equation.hpp"
#include "brachisto/transcription/discretisation.hpp"
#include "brachisto/transcription/element_errors.hpp"
#include "brachisto/transcription/equidistribution.hpp"
#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

namespace {

// What rounding leaves of T, relative: a few ulps from the sum of the integral.
constexpr double kRoundingError = 2e-15;

double sum_of_absolutes(const std::vector<double>& values) {
  return std::accumulate(
      values.begin(), values.end(), 0.0,
      [](double sum, double value) { return sum + std::abs(value); });
}

/// dT/dφ = r √A / w at the end: the end point moves along the path.
double time_per_radian(const ExtremalCurve& curve) {
  const ExtremalPoint end = curve.at(1.0);
  const Body& body = curve.scene().body;
  return body.radius * std::sqrt(inertia_factor(body, end.theta, end.beta)) /
         end.w;
}

void estimate(MeshAnswer& answer, const MeshOptions& options) {
  const ExtremalCurve coarse = answer.curve();
  Mesh mesh = coarse.mesh();
  mesh.degree += 1;
  const double phi = answer.solution.closure.phi;
  RollingTime finer(coarse.scene(), mesh, phi);
  const bool smooth = coarse.scene().contact == Contact::Smooth;
  std::optional<ContactEquation> contact;
  if (smooth) contact.emplace(finer);
  NewtonOptions newton;
  newton.tolerance = options.ipopt.tolerance;
  newton.max_iterations = 10;
  newton.stop = options.ipopt.stop;
  const NewtonResult result = solve_with_newton(
      finer, smooth ? &*contact : nullptr, prolong(coarse, finer), phi, newton);
  answer.solution.polish.newton_steps += result.iterations;
  if (result.residual > kRoundingResidual) return;
  answer.finer.emplace(finer, result.point);
  answer.finer_phi = result.phi;
  const double T = coarse.transit_time();
  const double difference = std::abs(answer.finer->transit_time() - T);
  const double of_finer = sum_of_absolutes(element_errors(*answer.finer));
  const ContactClosure& closure = answer.solution.closure;
  const double open_contact =
      std::abs(closure.mismatch / closure.slope) * time_per_radian(coarse);
  answer.estimated_error =
      (2.0 * difference + of_finer + open_contact) / T + kRoundingError;
}

}  // namespace

MeshAnswer answer_on_mesh(const Scene& scene, const Mesh& mesh,
                          const ExtremalCurve& curve, double phi,
                          const MeshOptions& options) {
  MeshAnswer answer{RollingTime(scene, mesh, phi), {}, {}, {}, phi};
  answer.solution = solve_on_mesh(
      answer.problem, {prolong(curve, answer.problem), phi, -1.0}, options);
  if (answer.solution.solved()) estimate(answer, options);
  return answer;
}

int starting_degree(double tolerance) {
  // One degree more for every two digits: elements stay about a tenth of a
  // turn of the body long.
  const double digits = -std::log10(tolerance);
  return std::clamp(static_cast<int>(std::lround(0.5 * digits + 0.5)), 2, 7);
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
    const double of_finer = sum_of_absolutes(element_errors(*answer.finer));
    if (3.0 * of_finer / T <= tolerance) return next;
  }
  // Errors between fixed ends by element, scaled to the estimate, which knows
  // the contact too.
  std::vector<double> errors = element_errors(answer.curve());
  const double sum = sum_of_absolutes(errors);
  const double scale = sum > 0.0 ? *answer.estimated_error * T / sum : 1.0;
  for (double& error : errors) error *= scale;
  constexpr double kSafety = 0.3;
  Mesh refined = equidistribute(mesh, errors, kSafety * tolerance * T);
  if (refined.num_elements() <= mesh.num_elements()) {
    // The order is not reached yet, or the error is rounding.
    refined = uniform_mesh(mesh.degree, mesh.num_elements() * 3 / 2 + 1);
  }
  return refined;
}

}  // namespace brachisto
